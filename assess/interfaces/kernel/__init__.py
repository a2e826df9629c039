"""The contact of two faces in relative rotation, compiled: no tension, linear up to the strength, plastic beyond.

With the depth z from the compressed edge, closing u_e of that edge and rotation phi, the stress is

    sigma(z) = clip(k (u_e - phi z), 0, f)        open beyond a = u_e / phi, crushed up to a_2 = (u_e - f / k) / phi

Let A(z), S(z), T(z) be area, first moment of depth and first moment across, of the part of the section up to z. As
clip(k u, 0, f) = k <u> - k <u - f / k>, what the stress carries is an integral over the elastic zone alone,

    N = k phi int A dz        N a_f = k phi int S dz        N t = k phi int T dz        z from a_2 to a

(beyond the far edge A stays constant), so that no closed form for each regime is needed, and every term is positive.
k phi = f / (a - a_2): where the zone lies inside the section these are f times the means of A, S, T, which remain exact
for a stiff joint, whose zone is thin.

A section is made of pieces, in each of which the width is linear, and of discs, which count as positive or negative.

    discs          A, S and their integrals for a disc
    moments        A, S, T and their integrals for a section
    equilibrium    the closing that carries a force, and the contact there; the entry points
"""
