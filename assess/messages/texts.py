"""The English of every message that is told by key: plain text with the names of its values in braces."""

from __future__ import annotations

from collections.abc import Mapping

TEXTS: Mapping[str, str] = {
    # remarks
    "fails-below": "the scan already fails just above {pga}: responses do not grow steadily with PGA",
    "rocks-before-sliding": "it rocks before it slides, which A.1 leaves out",
    "ground-motion": "at height the motion of the ground is taken as it is: unconservative where the building "
    "amplifies it",
    # of loads
    "not-lasting": 'load "{load}" is not shown to last: where it resists it counts in the multiplier alone, not in '
    "displacements and histories; give {missing} (until: the displacement of its point at which it ends, or "
    '"collapse"; source: a line for the mechanism or its loads in [report.sources])',
    "unheld": "the mechanism stands only by {loads}, not shown to last to collapse, so nothing can be said of its "
    "displacements and histories; give until, for a tie with strength, length and fracture_strain, and a source",
    "lower-confidence-factor": "by the confidence factor {given} given, below the code's {deciding}: for comparison",
    "larger-usable-rotation": "by the usable share {given} given, above the Guidelines' {deciding}: for comparison",
    "held-from-sliding": "a pass holds where it is kept from sliding: by the friction given it slides before it rocks, "
    "from PGA {pga} on",
    "counts-at-rest": "a pass holds where every tie and force that resists acts with its whole force as the motion "
    "starts: nobody shows that they last, and the multiplier counts them",
    "holds-to-its-end": "a pass holds where {what} is there with its whole force up to the displacement given as its "
    "end",
    "seats-hold": "a pass at {state} holds where the seat of {what} lasts up to a displacement d* of {moved}",
    # of the verdict
    "no-deciding-method": "no method that may decide {state} was asked or applies: {methods}",
    "missing-key": "{key}: {text}",
    "class-not-given": "a pass holds in classes of use I to III, class IV asks for {states} too; give "
    "[building] use_class",
    "pga-lowered": "a pass holds at site.pga = {given}, in place of {own} by the parameters of the spectrum",
    "thrust-is-tied": "a pass holds where ties or tie-beams take the thrust of {what} up to collapse",
    "premise-anchorage": "a pass holds where the wall is anchored to floors and roof",
    "premise-collar-joints": "a pass holds where the collar joints between the leaves are sound",
    "premise-coursed": "a pass holds for coursed masonry, not for rubble: say which it is by "
    "procedures.asce41-13.masonry",
    "premise-no-floors": "a pass holds for an element that carries no floor: gable, parapet, chimney",
    # of folders of results
    "writing-finished": "a command was stopped while it put its files there; the rest of them is in place now",
    "writing-taken-back": "a command was stopped while it put its files there, and they do not fit what is there now: "
    "what was there stays, what it had made is in {place}",
    "results-changed": "these results were changed since the program wrote them: nothing vouches for their numbers; "
    "run the project again",
    # of directions
    "direction-weaker": "towards {direction} it is clearly weaker than towards the direction given: multiplier "
    "{weaker} and d0* {weaker_d0}, against {given} and {given_d0}; check `direction`",
    "direction-stopped": "towards {direction}, with a multiplier of {weaker}, it is stopped by {bodies}, which touches "
    "it there: left out",
    "direction-held": "towards {direction}, with a multiplier of {weaker}, and back it is touched by {bodies}; it is "
    "taken to move all the same, as nothing else is nearly as weak: give `direction` where what touches it holds it",
    "direction-into": "the direction given, {direction}, leads into {bodies}, which touches it there: check it",
    "direction-left-out": "towards {direction} it cannot rock as described and was left out: {why}",
    "sides-by-contact": "it rocks to one side only: {bodies} touches it behind; write `sides` to say otherwise",
    # of amplification
    "by-floor-factor": "every record and pulse times {factor} at h = {height} of H = {building} by {clause}",
    "by-first-mode": "first mode of {frequency} ({frequency_from}), h_e = {effective} ({effective_from}), damping "
    "{damping}, linear shape: at h = {height} participation times shape h/h_e = {shape}",
    # of suites of records
    "suite-empty": "there are no records: {remedy}",
    "suite-not-named": "artificial records decide only where [verdict] procedures names {procedure}: {remedy}",
    "suite-count": "{code} asks for {limit} records, here are {found}: {remedy}",
    "suite-step": "{code} {clause} asks for steps of {limit} at most, the largest is {found}: {remedy}",
    "suite-duration": "{code} {clause} asks for {limit}, the shortest record lasts {found}: {remedy}",
    "suite-stationary": "{code} {clause} asks for a stationary part of {limit}, the shortest lasts {found}: {remedy}",
    "suite-usable": "{code}: the slowest mechanism has a period of {limit}, the records are usable up to {found}: "
    "{remedy}",
    "suite-mean-low": "{code} {clause}: from {low} to {high} the mean spectrum falls to {found} of the target, {limit} "
    "is asked: {remedy}",
    "suite-mean-high": "{code} {clause}: from {low} to {high} the mean spectrum rises to {found} of the target, "
    "{limit} is allowed: {remedy}",
    "suite-run-below": "{code} {clause}: from {low} to {high} the mean spectrum lies below the target at {found} of a "
    "hundred periods to the decade side by side, {limit} are allowed: {remedy}",
    "suite-out-of-reach": "{code} {clause} looks at the mean spectrum from {low} to {high}, the comparison ends at "
    "{end}: {remedy}",
    # reasons of checks
    "within-capacity": "the demand is within {capacity}",
    "beyond-capacity": "the demand is beyond {capacity}",
    "no-rocking": "no rocking: the demand does not lift the body off its base",
    "no-lasting-rotation": "lifts off, yet the method finds no lasting rotation at this demand",
    "moves-on-joints": "moves on its joints, yet the method finds no lasting rotation at this demand",
    "overturns": "overturns: no rotation holds this demand",
    "beyond-spectrum": "rotation beyond the allowable, and beyond the end of the spectrum",
    "spectrum-too-short": "{period} lies beyond the end of the spectrum at {end}: extend its table",
    "limit-beyond-overturning": "the empirical limit of rotation lies beyond overturning: outside its range",
    "records-overturn": "{fallen} of {n} records overturn the body",
    "records-beyond-collapse": "{fallen} of {n} records move the body beyond d0*, where it stands by chance",
    "too-few-records": "{n} records, of which {fallen} overturn the body; {clause} asks for at least {least}",
    "above-building": "the supports of the mechanism are {height} above the ground, higher than the building: check "
    "[building] height and ground_elevation",
    "ground-motion-at-height": "what holds the mechanism is {height} above the ground, where the motion of the ground "
    "can fail a check and cannot pass it: {remedy}",
    "scalar-motion-at-height": "what holds the mechanism is {height} above the ground; histories carried there by one "
    "number miss resonance, so they can fail a check and cannot pass it: {remedy}",
    "ground-unknown": "the lowest body lies {height} from elevation 0 and nobody says where the ground is: give "
    "[building] ground_elevation, or the mechanism its base_elevation",
    "ground-contradicted": "base_elevation = {given}, yet its base is drawn {drawn} above the ground; that key is for "
    "a mechanism that is drawn alone: leave it out, or make both agree",
    "storey-unknown": "passes by the mildest row of {clause} and not by the strictest, and nobody says in which storey "
    "the wall is: give [building] height and storeys",
    "knowledge-unknown": "crushing of the masonry is modelled, so FC is that of the level of knowledge, which is not "
    "given; beside it the answer by LC1",
    "seat-unknown": "the seat of {what} is not given, and its loss limits SLC",
    "other-limit-state": "the site's single spectrum is that of {declared}; {state} is decided by its own: give the "
    "hazard over return periods",
    "hazard-too-short": "the hazard does not reach the return period of {state}: add a row",
    "no-rebound": "the effective damping is that of impacts after which the body rocks on; this one stops at the first",
    "one-sided": "the effective damping is that of the two impacts of a body that rocks both ways; this one rocks to "
    "one side",
    "stops-at-impact": "restitution by the momentum kept at the impact is {restitution}: a mechanism this squat stops "
    "at its first impact; for histories give it restitution as a number in [0, 1]",
    "not-a-wall": "{clause} is of walls that stand free or span between floors; this mechanism is neither",
    "not-spanning": "{clause} is of walls that span between supports; this one stands free",
    "no-wall-size": "{clause} needs height and thickness of the wall; this mechanism has no geometry",
    "overloaded-wall": "{clause}: what presses on the wall is 39 times its own weight, which leaves no effective "
    "thickness: check the loads",
    "carries-floors": "EN 1998-1 4.3.5 is for elements that carry no floor; for walls that do no method is accepted "
    "before EN 1998-3:2025, and the answer by ntc2018 is for comparison",
    "rubble-masonry": "{clause} is for coursed masonry; rubble cannot be judged by it",
    "ordinate-not-by-name": "{clause} asks for {symbol}, which a table of ordinates does not state: give {key}",
    "friction-unknown": "friction at hinge {hinge} is not known; {remedy}",
    "hinge-pulls": "hinge {hinge} would have to pull with {pull} before the mechanism rocks, so friction does not "
    "hold it: check hinges and loads",
    "no-hinge-forces": "an equivalent block has no geometry: what its hinge presses on is not known; check sliding by "
    "hand",
    "slides-first": "slides before it rocks, at hinge {hinge}: the rocking answers are not the ones that count",
    "slides-later": "no sliding yet; it would slide before it rocks from PGA {pga} on",
    "rocks-first": "it rocks before it slides; hinge {hinge} comes nearest",
    "one-block-only": "{clause} is for one block on its base",
    "weight-only": "{clause} is for a body under its weight alone, and on this one {loads} acts too; the procedure "
    "sliding counts that",
    "level-base-only": "{clause} is for a level base; the procedure sliding looks at inclined ones",
    "sliding-beyond-before": "sliding beyond the allowable, at a smaller PGA already",
    "no-sliding": "no sliding: the spectrum does not reach c_s",
    "no-allowable-sliding": "for information; give procedures.asce43-05.allowable_sliding for a verdict",
    "sliding-unbounded": "the spectrum does not fall below c_s before it ends: extend its table, or give more friction",
    # warnings and notes of a project
    "mesh": "{file}: {trail}",
    "size": "{text}",
    "mechanism": "{text}",
    "site-study": "{text}",
    "box-size": "a number without unit is in m, so this is {given}; if it was meant in another unit write {likely}",
    "material-unit": "a number without unit is in SI, so this is {given}, which no masonry has; write {likely} if that "
    "was meant, and check the units of the other numbers",
    "weight-density": "{given} is a weight per volume; by standard gravity, 9.80665 m/s2, it is a density of {density}",
    "unit": '{given} is {as_g}; write "{number} g" if that was meant',
    "overlap": 'bodies "{one}" and "{other}" overlap by {volume}, {share} of the smaller, which is weighed with both; '
    "cut one back",
    "gap": 'bodies "{one}" and "{other}" touch nowhere: they lie {distance} apart; as one block they are taken to be '
    "joined",
    "gap-at-hinge": 'bodies "{one}" and "{other}" touch nowhere: they lie {distance} apart; with a hinge between them '
    "they are taken to meet: close the gap, or check hinges and blocks",
    "equation": '"linearised": it has a threshold of uplift, which the joints of {mechanisms} have not: below it the '
    'histories of the linearised equation do not move at all; write "exact"',
    "amplification": "{text}",
    "not-amplified": "above the ground, yet histories and ASCE 43-05 use the ground's motion as it is: {mechanisms}; "
    "the floor clauses of the other codes ask for the floor's motion; `amplification` carries the histories up",
    "two-first-modes": "histories take a first mode of {frequency}, the floor clauses of the codes a period of "
    "{period}; give period = {reciprocal} for one building",
    "confidence-factor": "crushing of the masonry is not modelled in {mechanisms}: by {circular} the FC of LC1, "
    "{least}, decides there",
    "sweep": "swept: the controlling one of {cases} cases, {case}, stands for the mechanism",
    "sweep-left-out": "left out of the envelopes, which are of the values in the file: {keys}; `assess run` takes the "
    "cases",
    # of records
    "artificial-records": "artificial records fit the spectrum at every period at once, as no earthquake does; real "
    "records are better",
    "coarse-record": "the time step of {records} is too coarse for {motion}: what shakes it between two samples is not "
    "in the record; take records with a step of {longest} or less",
    "files-not-read": "{files} not read: {told}",
    "flatfile": "{text}",
    "cells-passed-over": "{cells} passed over: {told}",
    "implausible-record": "{text}",
    "vertical-left-out": "vertical components are left out: {records}",
}
