"""The rocking equation integrated for jobs (oscillator, motion, scale), compiled.

One branch at a time, in its own mirrored sign s = +1 or -1, with y = 0 at rest and 1 at overturning, and the ground
acceleration a(t) linear between samples:

    exact        y'' = -r(y) - b(y) s a(t)                r, b: the cubics of the branch (`assess.dynamics.packing`)
    linearised   y'' = p^2 (y - 1 - s a(t) / threshold)   threshold = g lambda

Both equations share one march and one treatment of events, because a step of either is an `Arc`: y as a polynomial of
time. Each equation supplies three functions:

    advance     whole record intervals, fast, as long as `no_event` holds and the error is small enough
    step        an arc from a state, over any part of an interval
    potential   the energy stored at a rotation; its sum with y'^2 / 2 is constant in free motion

    columns       the columns of the arrays that callers pass in and read
    polynomial    arcs and their roots
    ground        the acceleration of a record or of a pulse over one interval
    events        uplift, the test that an interval has no event, and what is kept of events
    march         one job from beginning to end, for either equation
    search        overturning pulses of one frequency, and the weakest of them, for either equation
    linearised    the linearised equation and its entry points
    cubics        the table of the exact equation
    exact         the exact equation and its entry points
    ties          ties that yield and break, and friction of side walls, on the table of the exact equation
    sine          the linearised equation under a sine, in closed form between events

`no_event` decides whether an interval can contain an impact, a passage of 1 or a new largest rotation. Only where it
can, `integrate_interval` divides it into pieces over which the velocity, then the rotation, is monotone, so that no
event can hide between two samples, and locates each event on the arc.
"""
