"""The English text of messages on what a project gives, by key: bodies, loads, joints, mechanisms, records, spectra."""

from __future__ import annotations

from collections.abc import Mapping

GEOMETRY_TEXTS: Mapping[str, str] = {
    # meshes
    "mesh": "{file}: {step}",
    "several-classes": "elements of several classes joined into one body: {number} ({classes})",
    "many-shells": "one body of {number} closed shells",
    "elements-joined": "elements joined into one body: {number} ({names})",
    "element-incomplete": 'element "{element}": {what}',
    "not-all-built": "not all of it could be built from what the file says, volume and mass may be wrong: {lost}",
    "read-with-y-up": 'read with y up, as glTF prescribes; write mesh_up = "z" if z is up',
    "read-in-units": "read in units of {given}, as the project states, although the file states {stated}",
    "triangles-reversed": "triangles reversed to match their neighbours: {number}; the volume is unchanged",
    "double-triangles-removed": "double triangles removed: {number}; the volume changes by {change}",
    "border-corners-joined": "corners of open borders joined: {number}, at most {reach} apart; the volume changes by "
    "{change}",
    "edges-split": "edges split at corners of other triangles that lie on them: {number}; the volume is unchanged",
    "holes-closed": "holes closed by planes: {number} with {edges} edges and an area of {area}, {share} of the "
    "surface, the first around x = {x}, y = {y}, z = {z}; the volume changes by {change} against the open mesh, with "
    "its holes taken as cones to the middle of its box",
    "body-reversed": "its triangles faced inwards and were reversed; the volume is unchanged",
    "flat-shells-removed": "closed shells without volume removed: {number}",
    "shells-reversed": "closed shells that faced inwards reversed: {number}, the first around x = {x}, y = {y}, z = "
    "{z}; the volume changes by {change}",
    "shells-united": "its {number} closed shells, some of which overlap (near x = {x}, y = {y}, z = {z}), united so "
    "that their common volume counts once; a cavity would face inwards; the volume changes by {change}",
    "self-overlap": "its surface intersects itself near x = {x}, y = {y}, z = {z}, so that about {share} of its volume "
    "counts twice or not at all; left as it is",
    # size and place of bodies
    "size": 'body "{body}" measures {size} at its longest; is its unit right?',
    "size-in-unit": 'body "{body}" measures {size} at its longest; is its unit right? With mesh_unit = "{unit}" '
    "(--unit) it would measure {other}",
    "size-thick": 'body "{body}" measures {size} at its longest and is about {thickness} thick; is its unit right?',
    "size-thick-in-unit": 'body "{body}" measures {size} at its longest and is about {thickness} thick; is its unit '
    'right? With mesh_unit = "{unit}" (--unit) it would measure {other}',
    "far-from-origin": 'body "{body}" is {distance} from the origin in single precision, which resolves {resolution} '
    "there; move the mesh closer to the origin before exporting it",
    "overlap": 'bodies "{one}" and "{other}" overlap by {volume}, {share} of the smaller one; as they move as one, the '
    'overlap counts once, with "{one}", which is named first',
    "gap": 'bodies "{one}" and "{other}" do not touch: they are {distance} apart, although they form one block: close '
    "the gap, or add the body that joins them to the block",
    "blocks-apart": "block {second} is in the air: its body nearest to block {first}, with which it has a hinge, is "
    '"{other}", {distance} from "{one}": close the gap, or check hinges and blocks',
    "blocks-beside": "the upper block begins {depth} below the top of the lower one, beside it: two blocks of a wall "
    "stand one on the other",
    "blocks-overlap": "blocks {first} and {second} overlap by {mass}, {share} of the lighter one, although they move "
    "apart: cut one back",
    # bases and cuts
    "askew": "the base touches its extreme line in the direction of motion at a point, not along an edge; if the body "
    "stands askew to `direction`, turn one to the other: a corner as hinge overestimates the resistance",
    "cut-slopes": "the cut slopes across the direction of motion and its extreme line rises by {rise}; the hinge is "
    "taken level at the middle of that line: turn `direction` to the slope of the crack",
    "uneven-base": "the base is the lowest face alone, {width} wide, yet within {above} above it the body is {wide} "
    "wide; if it stands on all of that, make it plane by a cut",
    "turns-about-corner": "the cut slopes, so in most directions the block turns about one corner of it and slides "
    "along the crack beyond: check that the crack can be as smooth as that",
    "crack-by-formula": "crack at z = {z}, {share} of the height, by Mehrotra eq. 3.27: N / W = {load}, tension f_mt l "
    "b / W = {tension}; the formula is for a plain rectangular wall",
    "crack-by-general-formula": "crack at z = {z}, {share} of the height, by the general form of Mehrotra eq. 3.27, "
    "load at {place} of the thickness from the edge support: N / W = {load}, tension f_mt l b / W = {tension}; the "
    "formula is for a plain rectangular wall",
    "crack-of-least-multiplier": "crack at z = {z}, {share} of the height, where the uplift multiplier is least, "
    "{multiplier}",
    "crack-of-least-multiplier-with-tension": "crack at z = {z}, {share} of the height, where the uplift multiplier is "
    "least, {multiplier} with the mortar's tension before it opens",
    # arches
    "arch-beyond-joints": "{share} of the arch lies beyond its first and last joint and stands still: check centre and "
    "angles of `joints` unless it is meant",
    "joint-askew": "joint {joint} is {angle} off square to the arch: check `joints`",
    "hinges-found-positive": "hinges of positive rotation found as the least of all mechanisms over {joints} joints, "
    "uplift multiplier {multiplier}: {hinges}",
    "hinges-found-negative": "hinges of negative rotation found as the least of all mechanisms over {joints} joints, "
    "uplift multiplier {multiplier}: {hinges}",
    "four-hinges": "A at x = {ax}, z = {az}; B at x = {bx}, z = {bz}; C at x = {cx}, z = {cz}; D at x = {dx}, z = {dz}",
    # hinges
    "loose-hinge": "hinge {hinge} at x = {x}, z = {z} is {gap} away from block {block}; check it",
    "hinge-beside-block": "hinge {hinge} at x = {x}, z = {z} lies {gap} outside block {block}, whose nearest point is "
    "x = {near_x}, z = {near_z}; give a point of their contact",
    "hinge-beside-base": "hinge {hinge} at x = {x}, z = {z} lies outside its contact, which reaches from x = {low_x}, "
    "z = {low_z} to x = {high_x}, z = {high_z}; give a point of it",
    "hinge-beside-contact": "interface {interface}: the hinge lies {distance} outside the edge of its contact, which "
    "is {depth} deep; give a point of the contact",
    "hinge-in-tension": "hinge {hinge} would have to pull its block down with {pull} when the mechanism starts, which "
    "masonry cannot: check hinges and loads",
    "hinge-off-base": "hinge {hinge} at x = {x}, z = {z} is not on the base of the body, which reaches from x = "
    "{low_x}, z = {low_z} to x = {high_x}, z = {high_z}; the whole body turns about it all the same",
    "no-such-body": "I_O / (M R^2) = g / (p^2 R) = {ratio} is less than 1, which no body has; check p and radius",
    "side-walls-where-counted": "the friction of its side walls counts in the multiplier and in a(d) of ntc2018-linear "
    "and ntc2018-nonlinear, and in histories by the exact equation on rigid joints, where the wall opens farther than "
    "ever before; displacements at collapse and all other procedures leave it out, and so do histories on joints that "
    "deform or by the linearised equation, where that is on the safe side of most records and not of each",
    # joints
    "never-crushes": "interface {interface}: no strength is known, so its joint never crushes; give strength",
    "joint-taken-level": "interface {interface}: no faces meet at its hinge, so its joint is taken level",
    "hinge-inside-contact": "interface {interface}: the hinge lies {distance} inside the edge of its contact, which is "
    "{depth} deep; pressure is counted from the hinge on",
    "hinge-outside-contact": "interface {interface}: the hinge lies {distance} outside the edge of its contact, which "
    "is {depth} deep; pressure is counted from the hinge on",
    "contacts-apart": "interface A: its contact lies {distance} apart for the two directions, as it is {depth} deep "
    "and begins at the hinge of each; give a shape as deep as they are apart",
    "contact-not-symmetric": "interface {interface}: the contact is not symmetric about the plane of motion: its "
    "resultant moves by up to {distance}, {share} of the section, along the axis of rotation, which turns the body out "
    "of plane",
    "load-through-top": "interface C: the load on the middle of the top comes through the joint there, so its "
    "resultant moves to the edge as the wall turns, and is at hinge C in the rigid mechanism beside it; a load off the "
    'middle stays in its place, and so does one with through = "fixed"',
    # loads
    "load-stands-in-block": 'load "{load}": body "{other}" stands where the block does; it is not taken to carry a '
    "part of this",
    "load-touches-overlapping": 'load "{load}": body "{other}", which it touches too, overlaps the block by {volume}',
    "load-weight-not-carried": 'load "{load}": nothing in the project carries its weight',
    "load-half-taken": 'load "{load}": nothing else in the project carries it; half of it is taken, since its other '
    "foot must stand on something: else give share",
    "load-all-taken": 'load "{load}": nothing else in the project carries it, so its whole weight is on the block: '
    "else give share",
    "load-share-unsure": 'load "{load}": {share} of its weight is on the block as drawn, yet {least} to {most} by how '
    "the drawing is read: bodies up to {apart} apart touch or do not, and a slope that meets an edge bears over little "
    "or much of it; give share with its source, or draw what it bears on",
    "overburden-share-unsure": 'overburden "{load}": {share} of its weight is on the wall as drawn, yet {least} to '
    "{most} by how the drawing is read: bodies up to {apart} apart touch or do not; give force, what presses on the "
    "wall, in place of bodies, or draw what it bears on",
    "load-on-other-block": 'load "{load}": block {given} is given, yet it touches block {touched}; it moves with the '
    "one given: check `block`",
    "load-part-left-out": 'load "{load}": it bears on block {block} too, and no load puts that part of it there: '
    "remove `block`, or add a load with block = {block}",
    "load-anchor-moves": 'load "{load}": its anchor at x = {x}, z = {z} lies on block {block}, which moves too, yet it '
    "is taken as fixed in space: check `anchor`",
    "load-in-the-air": 'load "{load}" at x = {x}, z = {z} is in the air, {distance} from the block as seen in the '
    "plane of motion; it moves with the block all the same: check `at`",
    "load-across-crack": 'load "{load}" at x = {x}, z = {z} acts on block {block}, yet the crack is at z = {crack}; '
    "write block = {side} if it moves with that one",
    # restitution
    "restitution-no-rebound": "restitution 0 is used: Sorrentino et al. 2011, Mehrotra eq. 3.45, gives {value}, which "
    "is not negative: there is no rebound",
    "restitution-chain": "no formula is published for the rebound of a chain that rocks to one side: histories take "
    "the worst of none and 0.5, 1 and 1.5 times that of a slender block, 0.5; give one as a number",
    "restitution-takes-more": "restitution {given} is given, where momentum kept over the mechanism is {momentum}: "
    "each impact takes more energy than by that rule, so histories and ASCE 43-05 A.2 rest on the source of that "
    "number",
    "restitution-stops": "restitution {value} ({source}): a mechanism this squat stops at its first impact; 0 is "
    "taken, and histories are not answered: for those give restitution as a number in [0, 1]",
    "restitution-of-high-mass": "restitution {value} is above the {plain} of the same blocks without {loads}: a mass "
    "high up moves almost horizontally before and after the impact, which therefore takes little of its velocity",
    "restitution-above-one": "restitution {value} is above 1 though energy is lost: the hinges of the two directions "
    "differ, and the branch that begins is the faster one, its inertia being {share} of that of the one that ends; the "
    "impact keeps {kept} of the energy",
    # loads, as far as they last
    "not-lasting": 'load "{load}" is not shown to last: where it resists, it counts only in the multiplier, not in '
    "displacements and histories; give {missing} (until: the displacement of its point of application at which it "
    'is lost, or "collapse"; source: a line for the load in [report.sources], as "mechanisms.NAME.loads[1]")',
    "tie-not-lasting": 'tie "{load}" is not shown to last: it counts only in the multiplier, with its pretension of '
    "{force}, not in displacements and histories; give {missing} (strength: the least of plate, masonry and far wall; "
    'source: a line for the tie in [report.sources], as "mechanisms.NAME.loads[1]")',
    "one-bar-twice": "it has the ends of {other}, of another mechanism, and so is the same bar, with other values of "
    "{keys}: state one bar alike wherever it holds, as each answer counts on its own numbers",
    "tie-brittle": 'tie "{load}": {link} at {strength}, where the bar yields at {yielding}: with less than {spare} '
    "times that it is not taken to yield, and the tie is gone when its ends have moved apart by {elongation}; "
    "strengthen the anchorage, or take a weaker bar. Where a tie that is lost takes more than half of the capacity "
    "along, displacements of the codes end there, and the wall without it may reach a higher index",
    "far-wall-less": 'tie "{load}": the wall "{body}" at its far end turns inwards above {crack} at {strength}, under '
    "{action} g of its own: less than the {stated} that is stated for the far end or the anchorage, and the lesser "
    "counts; hold that wall from within, or draw what holds it",
    "far-wall-falls": 'tie "{load}": the wall "{body}" at its far end turns inwards above {crack} by itself at '
    "{multiplier} g, and is to hold the tie at {action} g: the tie has next to nothing to hold on to, and counts for "
    "nothing; hold that wall from within, or draw what holds it",
    "pretension-above-strength": 'load "{load}" is given a pretension of {force}, above its strength; it counts with '
    "{strength}; check force and strength",
    "seat-wide": 'the seat of load "{load}" is {seat} wide, more than any wall offers; is its unit right?',
    "unheld": "the mechanism is stable only because of {loads}, not shown to last to collapse, so its displacements "
    "and histories cannot be evaluated; give until (for a tie also strength, length and fracture_strain; for one that "
    "stretches strength alone) and a source",
    # sources of loads
    "load-overburden": "weight of {bodies} on the wall, {aside} from mid-thickness",
    "load-not-shared": "not shared with {bodies}, which stands where the wall does",
    "load-bears": "bears on {area}",
    "load-pushes": "only pushes on {area}",
    "load-bears-given": "bears (given; by its contact it {seen})",
    "load-pushes-given": "only pushes (given; by its contact it {seen})",
    "load-share-given": "share {share} (given)",
    "load-share-beside": "share {share} (given; by statics {statics})",
    "load-share-beside-none": "share {share} (given; by statics none)",
    "load-share-statics": "share {share} (statics; the rest on {bodies})",
    "load-place-given": "place given (its contact is at x = {x}, z = {z})",
    "load-measure": "{symbol} = {size} (found)",
    "load-measure-given": "{symbol} = {size} (given)",
    "load-mass-given": "{mass} (given; by its table {table})",
    "load-mass-direct": "{mass} (direct values)",
    "load-mass": "{mass} ({own})",
    "load-counted-once": "{share} of it, as loads before it count what they share with it",
    "load-lies-within": "of its {mass} that load the block {within} are drawn within it, where they count as masonry: "
    "nothing of its weight is left on it; move the drawing, or give its share",
    "load-within-block": "less {mass} of it that lies in the block, which counts it",
    "load-ungewitter": "Ungewitter's case {case}, {name}: {thickness} x {density} (assumed) x intrados {area}",
    "load-with-fill": "{own}, and fill {fill} x plan {plan}",
    "load-thrust": "H = V x / f = {V} x {x} / {f} = {H}",
    "load-along-motion": "{force} along the motion",
    "load-lever-of-vault": "x to the weight of half the vault from its springing (L / 4 would give {even})",
    # sources of restitution
    "restitution-3-45": "Sorrentino et al. 2011, Mehrotra eq. 3.45: {value}",
    "restitution-other": '"{rule}" would give {value}',
    "restitution-sliding": "{value} if the loads slide on their seats and pass on no horizontal momentum",
    "restitution-positive": "positive: {source}",
    "restitution-negative": "negative: {source}",
    # directions
    "direction-weaker": "the mechanism is clearly weaker towards {direction} than in the direction given: "
    "multiplier {weaker} and d0* {weaker_d0}, against {given} and {given_d0}; check `direction`",
    "direction-stopped": "towards {direction}, where its multiplier is {weaker}, the mechanism is blocked by "
    "{bodies}, which touches it there: direction left out",
    "direction-held": "{bodies} touches the mechanism towards {direction}, where its multiplier is {weaker}, and on "
    "the opposite side; it is assumed free to move, as no other direction is nearly as weak: give `direction` if "
    "the contact restrains it",
    "direction-into": "the direction given, {direction}, points into {bodies}, which touches the mechanism there: "
    "check it",
    "direction-left-out": "towards {direction} the mechanism cannot rock as described, so that direction was left "
    "out: {why}",
    "sides-by-contact": "the mechanism rocks to one side only because {bodies} touches it behind; set `sides` to "
    "override this",
}

RECORD_TEXTS: Mapping[str, str] = {
    # files and flatfiles
    "file-not-read": "{file} not read: {why}",
    "files-not-read": "further files that could not be read: {number}",
    "cell-ignored": 'row {row}, {column}: "{value}": impossible value; ignored',
    "cells-ignored": "further cells ignored: {number}",
    "flatfile-columns-missing": "the flatfile has no column of {keys} under a name that is known, and the records' own "
    "files are believed there; is its header misspelt? Known are, however they are spaced: {known}",
    "flatfile-no-records": "no row of the flatfile fits, for there is no record that can be read",
    "flatfile-rows-absent": "of {total} records {count} have no row in the flatfile, like {file}; event, magnitude, "
    "distance and Vs30 are those of their own files, where they state them; was a row lost?",
    "flatfile-other-numbers": "no row of the flatfile fits: the files have NGA numbers {first} to {last}, the table "
    "{first_row} to {last_row}; it may be of another search or another NGA project",
    "flatfile-no-numbers": "no row of the flatfile fits: rows are found by the NGA number in a file's name or by the "
    "file's name, and {file} has neither; keep the names that files had when downloaded, like {example}",
    # a record
    "of-record": "{record}: {what}",
    "of-further-records": "further remarks of this kind on records: {number}",
    "peak-large": "its peak is {peak}, above {limit}, as hardly any earthquake reaches; check the unit",
    "peak-large-in-unit": "its peak is {peak}, above {limit}, as hardly any earthquake reaches; check the unit (read "
    "in {unit}; in {likely} it would be {meant})",
    "peak-small": "its peak is {peak}, below {limit}; check the unit",
    "peak-small-in-unit": "its peak is {peak}, below {limit}; check the unit (read in {unit}; in {likely} it would be "
    "{meant})",
    "step-fine": "a step of {step} is finer than instruments of its network have; check the step",
    "step-slow": "with a step of {step} its motion stays below {frequency}, slower than earthquakes; check the step",
    "step-fast": "with a step of {step} half of it is above {frequency}, faster than earthquakes; check the step",
    "step-other": "its step is {step}, that of {other}, of the same station and earthquake, {other_step}; check the "
    "steps",
    "impossible-in-header": "{what} is {value} in its header, which cannot be; the header is damaged",
    "peak-time": "its peak comes {after} after the earthquake's origin at {distance}, where it can come after "
    "{earliest} to {latest}; check the step and the times",
    "header-disagrees": "its {name} is {value}, but its {other_name} is {other}; one of them may be damaged",
    "velocities-disagree": "the velocities of {name} are not the integral of its accelerations",
    "columns-uneven": "the columns of line {line} are not those of the others; characters may be lost",
    "filter-above": "its filter ends at {corner}, but its motion does not with a step of {step}; check the step",
    "filter-below": "its filter begins at {corner}, its motion below that with a step of {step}; check the step",
    "filter-beyond-step": "its filter ends at {corner}, its step of {step} holds {most} at most; check the step",
    # how a record was read and processed
    "read-from": "read from {format}, unit {unit}",
    "read-from-given": "read from {format}, unit {unit} as given, for the file does not say",
    "read-from-by-format": "read from {format}, unit {unit} by the format",
    "read-from-volume": "read from {format} volume {volume}, unit {unit}",
    "read-from-event": "read from {format}, unit {unit}, event of {date}",
    "read-from-response": "read from {format}, response of {file}",
    "before-reading": "before that: {trail}",
    "uncorrected": "uncorrected",
    "mean-removed": "mean taken off",
    "mean-removed-of": "mean of {mean} {unit} taken off",
    "filtered-by-source": "filtered by the source: {low} to {high}",
    "filtered-by-source-from": "filtered by the source: from {low}",
    "filtered-by-source-as": "filtered by the source: {corners} Hz",
    "scaled-by": "scaled by {factor}",
    "baseline-removed": "baseline of degree {degree} taken off",
    "band-filtered": "acausal Butterworth of order {order}, {low} to {high}",
    "high-passed": "acausal Butterworth of order {order}, from {low}",
    "low-passed": "acausal Butterworth of order {order}, up to {high}",
    "resampled": "resampled from {before} to {after}",
    "trimmed": "trimmed to {start}-{end} of its Arias intensity, {first} to {last}",
    "turned": 'turned with component "{component}" of "{record}": {name}',
    "turned-to": 'turned with component "{component}" of "{record}": {name}, azimuth {azimuth}',
    "through-first-mode": "through a first mode of {frequency}, damping {damping}, to where it counts {shape}",
    "suite-raised": "the suite raised by {factor}, with which its mean meets ASCE 43-05, 2.4, to {period}",
    "pulse": "{shape} pulse, {frequency}, {amplitude}",
    "artificial-phases": "artificial: random phases, seed {seed}, number {number}; envelope of Jennings, Housner & "
    "Tsai (1968), {rise} rising, {level} stationary, falling to {duration}",
    "artificial-fit": "5 % spectrum fitted to {code} over {first} to {last}: {low} to {high}, rms {rms}; peak "
    "acceleration that of the target",
    "artificial-baseline": "baseline corrected: velocity and displacement end at zero, mean displacement zero",
    # a locked suite
    "suite-locked": "records and scale factors are those of {file}; {keys} of [records] say how it is made, and count "
    "when `assess records select PROJECT --lock` is run again",
    "lock-edited": "{file} was changed by hand since it was written; its records and factors are used as they are",
    # steps that are too coarse
    "coarse-record": "the time step of {records} is too coarse for {motion}: motion between two samples is lost; "
    "use records with a step of {longest} or less",
    "motion-elastic": "its elastic vibration on the joints, {frequency}",
    "motion-rocking": "its rocking, p = {p}",
    # spectra
    "implausible-site": "{name} = {value} is beyond any plausible site, {most}; is it in another unit?",
    "mapped-exchanged": "S_1 = {s_1} is above S_S = {s_s}, which no map has; are they exchanged?",
    "site-factors-capped": "Z R = {z} × {r} = {product} is taken as {most}, the most that NZS 1170.5, 3.1.1 asks for; "
    "check z and r",
    "reply-differs": "{name} of the reply is {value}, and by ASCE 7-22 §21.4 from its own spectrum {derived}, which is "
    "used; was the reply edited?",
    "ts1170-near-fault": "the clauses of TS 1170.5 on near faults were not read and are not in the spectrum; where a "
    "major fault is within 20 km, check the ordinates above 1.5 s",
    "study-of-class-e": "ASCE 7-16 §11.4.8 asks for a ground motion hazard analysis for site class E with S_S >= 1.0 "
    "g; F_a is that of class C by its exception 1",
    "study-of-classes-d-and-e": "ASCE 7-16 §11.4.8 asks for a ground motion hazard analysis for site classes D and E "
    "with S_1 >= 0.2 g; the spectrum by Table 11.4-2 can be low at long periods (Supplement 3 raises S_M1 of class D "
    'by half); give that of the study with code = "table"',
    # suites of records
    "remedy-keys": "give {keys}",
    "remedy-records": "give {number} more records",
    "remedy-longer": "records must last {duration}",
    "remedy-finer": "give artificial records at {step} or less",
    "remedy-factor": "scale every record by {factor}",
    "suite-empty": "there are no records: {remedy}",
    "suite-not-named": "artificial records may decide only if [verdict] procedures lists {procedure}: {remedy}",
    "suite-count": "{code} requires {limit} records, {found} are available: {remedy}",
    "suite-step": "{code} {clause} requires a time step of at most {limit}, the longest is {found}: {remedy}",
    "suite-duration": "{code} {clause} requires a duration of {limit}, the shortest record lasts {found}: {remedy}",
    "suite-stationary": "{code} {clause} requires a stationary part of {limit}, the shortest lasts {found}: {remedy}",
    "suite-usable": "{code}: the slowest mechanism has a period of {limit}, the records are usable up to {found}: "
    "{remedy}",
    "suite-mean-low": "{code} {clause}: between {low} and {high} the mean spectrum falls to {found} of the target, "
    "at least {limit} is required: {remedy}",
    "suite-mean-high": "{code} {clause}: between {low} and {high} the mean spectrum rises to {found} of the target, "
    "at most {limit} is allowed: {remedy}",
    "suite-run-below": "{code} {clause}: between {low} and {high} the mean spectrum is below the target at {found} "
    "consecutive periods (a hundred per decade), at most {limit} are allowed: {remedy}",
    "suite-out-of-reach": "{code} {clause} covers the mean spectrum from {low} to {high}, but the comparison ends "
    "at {end}: {remedy}",
    "artificial-records": "artificial records match the spectrum at every period at once, as no earthquake does; "
    "prefer recorded motions",
    "vertical-left-out": "vertical components are not used: {records}",
    # remarks on requirements
    "further-factor": "a further factor of {factor} on every record would do",
    "target-known": "the target is known from {low} to {high} only",
    # amplification
    "by-floor-factor": "every record and pulse is multiplied by {factor}, at h = {height} of H = {building}, "
    "according to {clause}",
    "clause-3-49": "Mehrotra 3.49: S [3 (1 + h/H) - 0.5], S = {soil}",
    "by-rayleigh": "Rayleigh's method on {slices} slices of its bodies: {assumptions}",
    "by-first-mode": "first mode at {frequency} ({frequency_from}), h_e = {effective} ({effective_from}), damping "
    "{damping}, linear mode shape: at h = {height} participation factor times mode shape h/h_e = {shape}",
    # works that are searched
    "retrofit-not-built": "cannot be built: {error}",
    "retrofit-pretension": "its pretension of {force} is above half of what yields the bar, {most}",
    "retrofit-spacing": "its anchors are {spacing} apart, more than {most}",
    "retrofit-tie-lacks": "this tie does not count up to collapse without {keys}, so works on it may show no effect",
    "retrofit-anchors": "the search does not check plates, cones of neighbouring anchors or bearing on the far wall: "
    "check them for the layout that is built",
    "retrofit-spacing-allowed": "anchors up to {spacing} apart were allowed: check the wall between them",
    "retrofit-direction": "with the works another direction is the weakest: state it and search again",
    "retrofit-others": "these mechanisms, which the works do not change, stay short of the target: {mechanisms}",
    "retrofit-as-typed": "values that help and that no source vouches for count as typed here, and are replaced in a "
    "run of the project with the works: {keys}",
    "retrofit-unsourced": "the layout reaches the target only with values that no source vouches for; give one for "
    "{keys}",
}
