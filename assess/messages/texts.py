"""The English text of every message, by key: plain sentences with the names of their values in braces.

Those on checks, the verdict, the project, fragility and uncertainty stand here; those on what a project gives, bodies,
loads, joints and records, in `input_texts`.
"""

from __future__ import annotations

from collections.abc import Mapping

from assess.messages.building_texts import BUILDING_TEXTS
from assess.messages.candidate_texts import CANDIDATE_TEXTS
from assess.messages.input_texts import GEOMETRY_TEXTS, RECORD_TEXTS

UNCERTAINTY_TEXTS: Mapping[str, str] = {
    # why no lognormal curve is drawn
    "fragility-none-reach": "no record reaches this state: no lognormal curve",
    "fragility-all-reach": "every record reaches this state at every intensity: no lognormal curve",
    "fragility-one-intensity": "the records have one intensity in common: no lognormal curve",
    "fragility-separated": "all records reach this state between the same two intensities: the scatter is less than "
    "the step between them, and no lognormal curve can be fitted",
    "fragility-cloud-separated": "every record that reaches this state is stronger than every one that does not: the "
    'cloud shows no scatter, and no lognormal curve can be fitted; add records, or use method = "ida"',
    "fragility-falling": "the share of records that reach this state does not rise with this measure: no lognormal "
    "curve",
    "fragility-no-threshold": "on joints that deform at once there is no uplift, and the state of rocking is not "
    "defined",
    "fragility-no-cloud": "too few records make the mechanism rock without overturning it, or their responses do not "
    "rise with this measure: no lognormal curve",
    # why a lognormal has no interval
    "fragility-interval-events": "the records are of fewer than {least} earthquakes ({events}): the curve has no "
    "interval",
    "fragility-interval-draws": "more than one bootstrap draw in 20 gives no curve, as too few records stand above the "
    "weakest that reaches this state, or rock and do not overturn: the curve has no interval; add records",
    # records
    "fragility-few-records": "records: {number}, fewer than {least}: dispersion and tails are hardly known",
    "fragility-artificial": "artificial records: {number} of {all}; made for one spectrum, they differ less than "
    "earthquakes do, so the dispersion is too small; use recorded motions",
    "fragility-hollow": "runs at scale factors above 4: {runs}, up to {largest}; motions scaled so far may not "
    "resemble strong earthquakes",
    "fragility-uncertain": "each record met a wall of its own, with sampled values of {keys}: the dispersion holds "
    "what is not known of these, which the epistemic dispersion must not hold again",
    "fragility-long-periods": "{measure} needs periods up to {period}, beyond those to which {records} can be used",
    "fragility-no-events": "records that name no earthquake: {number}; each counts as an earthquake of its own, "
    "and intervals may be too narrow",
    "fragility-stripes-one-measure": "by stripes fragility is found for the measure that records are scaled by, "
    '{measure}; use method = "ida" to compare measures',
    # exports
    "fragility-left-out": "{mechanism}, {measure}: {why}",
    "fragility-state-left-out": "{mechanism}, {measure}, {state}: {why}",
    # risk
    "fragility-no-hazard-measure": "the hazard is in {measure}, which is not among the measures of the fragility: no "
    "rate; add it to [analysis.fragility] measures",
    "fragility-hazard-far": "the nearest site of the file is {distance} from that of the project",
    "fragility-hazard-ends": "the hazard ends at {intensity}, where the share of records that reach the state is "
    "{share}: rarer, stronger motions may add at most {beyond} a year",
    "fragility-hazard-starts": "the hazard begins at {intensity}, where already {share} of records reach the state: "
    "more frequent motions add to the rate",
    "fragility-runs-end": "records are run up to {intensity}, where the share that reaches the state is {share}; "
    "stronger motions of the hazard may add at most {lacking} a year; run to a larger intensity, or give stronger "
    "records",
    "fragility-cloud-ends": "the strongest record has {intensity}, above which the curve is extrapolated: a share of "
    "{share} of the rate is of stronger motions, and these may add at most {lacking} a year; give stronger records, or "
    "a factor on them",
    "fragility-cloud-starts": "the weakest record has {intensity}, below which the curve is extrapolated: a share of "
    "{share} of the rate is of weaker motions; give weaker records",
    "fragility-no-epistemic": "a target is set, but no dispersion of what is not known of the mechanisms: no rate is "
    "shown to be within the target; give it",
    "fragility-epistemic-above": "the rate is within the target only without the epistemic dispersion; with it, it is "
    "{rate} a year, above the target",
    "fragility-scalar-motion": "above the ground, where one factor on the motion of the ground leaves out resonance "
    "with the building: rates may be too small, and no target is shown to be met; use amplification = {{ method = "
    '"modal-filter" }}',
    "fragility-ground-motion": "above the ground, but shaken by the motion of the ground unamplified: rates may be too "
    'small, and no target is shown to be met; give amplification = {{ method = "modal-filter" }}',
    # numbers that are varied
    "not-varied": "not varied: {why}",
    "not-assessed-low": "not assessed at the low value, {value}: {why}",
    "not-assessed-high": "not assessed at the high value, {value}: {why}",
    # uncertain numbers
    "uncertainty-means": "numbers with a scatter are used at their means ({keys}); a table [analysis.uncertainty] "
    "shows how the answers spread",
    "uncertainty-hinges-stay": "these hinges are given as points and do not move with the faces when {key} varies; "
    "give their coordinates a scatter of the same group, or leave them out",
    "uncertainty-left-out": "not sampled: {why}",
    "uncertainty-thickness-left-out": "thickness not sampled: {why}",
    "uncertainty-not-built": "{number} of {samples} samples could not be built and have no answer; the first: {why}",
    "uncertainty-open": "{number} of {samples} samples not answered: {why}",
    "uncertainty-no-influence": "{group} changes nothing: varied alone from its 5 % to its 95 % quantile, the answer "
    "is the same",
    "uncertainty-idle": "{keys}: no influence on any answer",
    "uncertainty-cut-off": "a share of {share} of its distribution lies beyond what is possible; values are "
    "drawn from the rest, whose mean is {mean} times the one given",
}

TEXTS: Mapping[str, str] = {
    **GEOMETRY_TEXTS,
    **BUILDING_TEXTS,
    **RECORD_TEXTS,
    **UNCERTAINTY_TEXTS,
    **CANDIDATE_TEXTS,
    "listed": "{first}; {others}",
    # remarks on checks
    "spread-would-pass": "with their numerical spread a share {share} of the draws passes, but the records as they are "
    "fail, and so does the answer",
    "fails-below": "the PGA scan already fails just above {pga}: the response does not grow steadily with PGA",
    "rocks-before-sliding": "the body rocks before it slides, a case that A.1 does not cover",
    "ground-motion": "the ground motion is applied unamplified although the mechanism is above ground: "
    "unconservative where the building amplifies it",
    "on-softened-building": "histories are shown in the worst of {states} states of the building: first period "
    "{period}, {ratio} times the elastic one, damping {damping}",
    # reasons of checks
    "within-capacity": "the demand is within {capacity}",
    "beyond-capacity": "the demand exceeds {capacity}",
    "no-rocking": "no rocking: the demand does not start the motion",
    "slides-instead": "it does not rock, as it slides first, from PGA {pga} upwards",
    "no-lasting-rotation": "the body lifts off, but the method finds no stable rotation at this demand",
    "moves-on-joints": "the body moves on its flexible joints, but the method finds no stable rotation at this demand",
    "overturns": "overturns: no rotation balances this demand",
    "beyond-spectrum": "the rotation exceeds the allowable one and lies beyond the end of the spectrum",
    "spectrum-too-short": "{period} is beyond the end of the spectrum at {end}: extend its table",
    "limit-beyond-overturning": "the empirical rotation limit is larger than the overturning rotation: outside its "
    "range of validity",
    "records-overturn": "{fallen} of {n} records overturn the body",
    "records-overturn-factored": "{fallen} of {n} records overturn the body at FC = {factor} times the level, a PGA of "
    "{pga}",
    "numerical-spread": "the records as they are pass, but with their numerical spread only a share {share} of the "
    "draws does; a pass needs 0.84",
    "records-beyond-collapse": "{fallen} of {n} records move the body beyond d0*, where it survives only by chance",
    "too-few-records": "too few records: {n} ({fallen} overturning the body); {clause} requires at least {least}",
    "above-building": "the supports of the mechanism are {height} above the ground, higher than the building: check "
    "[building] height and ground_elevation",
    "ground-motion-at-height": "the mean height of the supports is {height} above the ground; with the ground "
    "motion applied there a check may fail but cannot pass: {remedy}",
    "scalar-motion-at-height": "the mean height of the supports is {height} above the ground; histories scaled "
    "to that height by a single factor miss resonance, so a check may fail but cannot pass: {remedy}",
    "vertical-motion-unknown": "the vertical motion of the floor is not known: give {key}, vertical over horizontal "
    "spectral acceleration, by the vertical floor spectrum",
    "floor-spectrum-unnamed": "the floor spectrum is that of another country's code, Circolare 7/2019, C7.2.5: name it "
    "in {key}, or give histories through modal-filter",
    "ground-unknown": "the lowest body is {height} from elevation 0 and the ground level is not given: give "
    "[building] ground_elevation, or the mechanism's base_elevation",
    "ground-contradicted": "base_elevation = {given}, but the base is modelled {drawn} above the ground; that key "
    "is for a mechanism modelled on its own: remove it, or make the two agree",
    "storey-unknown": "passes by the mildest row of {clause} but not by the strictest, and the storey of the wall "
    "is not given: give [building] height and storeys",
    "knowledge-unknown": "crushing of the masonry is modelled, so FC depends on the knowledge level, which is not "
    "given; the answer for LC1 is shown for comparison",
    "seat-unknown": "the seat of {what} is not given, and its loss limits SLC",
    "other-limit-state": "the site's single spectrum is for {declared}; {state} is decided by its own spectrum: "
    "give the hazard for several return periods",
    "hazard-too-short": "the hazard does not reach the return period of {state}: add a row",
    "no-rebound": "the effective damping applies to impacts after which the body continues to rock; this mechanism "
    "stops at the first impact",
    "one-sided": "the effective damping assumes the two impacts of a body that rocks both ways; this mechanism "
    "rocks to one side only",
    "stops-at-impact": "conservation of momentum gives a restitution of {restitution}: a mechanism this squat stops "
    "rocking at the first impact; for histories give restitution as a number in [0, 1]",
    "histories-unknown": "histories of this class are not answered: what its impacts leave is not known; its "
    "multiplier and its curve are, which the linear and the non-linear kinematic check of the Italian codes ask for",
    "not-a-wall": "{clause} applies to walls that stand free or span between floors; this mechanism is neither",
    "not-spanning": "{clause} applies to walls that span between supports; this wall stands free",
    "no-wall-size": "{clause} needs the height and thickness of the wall; this mechanism has no geometry",
    "overloaded-wall": "{clause}: the load on the wall is 39 times its own weight, which leaves no effective "
    "thickness: check the loads",
    "carries-floors": "EN 1998-1 4.3.5 is for elements that carry no floor; for walls that do, no method is "
    "accepted before EN 1998-3:2025, and the answer of ntc2018 is for comparison only",
    "rubble-masonry": "{clause} applies to coursed masonry; rubble masonry cannot be assessed with it",
    "ordinate-not-by-name": "{clause} needs {symbol}, which a table of ordinates does not state: give {key}",
    "friction-unknown": "friction at hinge {hinge} is not known; {remedy}",
    "hinge-pulls": "hinge {hinge} would need a tension of {pull} before the mechanism rocks, so friction cannot "
    "hold it: check hinges and loads",
    "no-hinge-forces": "an equivalent block has no geometry, so the forces at its hinge are not known; check "
    "sliding by hand",
    "slides-first": "slides before it rocks, at hinge {hinge}: the rocking answers do not govern",
    "slides-later": "no sliding yet; from PGA {pga} upwards it would slide before it rocks",
    "rocks-first": "rocks before it slides; hinge {hinge} comes closest to sliding",
    "one-block-only": "{clause} applies to a single block on its base",
    "weight-only": "{clause} applies to a body loaded by its weight alone, but {loads} also acts on this one; the "
    "procedure sliding includes it",
    "level-base-only": "{clause} applies to a level base; use the procedure sliding for inclined ones",
    "sliding-beyond-before": "the sliding displacement already exceeds the allowable one at a smaller PGA",
    "no-sliding": "no sliding: the spectrum does not reach c_s",
    "no-allowable-sliding": "for information; give procedures.asce43-05.allowable_sliding to get a verdict",
    "sliding-unbounded": "the spectrum does not fall below c_s before it ends: extend its table, or give a higher "
    "friction",
    # what a pass depends on
    "lower-confidence-factor": "uses the given confidence factor {given}, below the code's {deciding}: for "
    "comparison only",
    "larger-usable-rotation": "uses the given usable share {given}, above the Guidelines' {deciding}: for "
    "comparison only",
    "held-from-sliding": "a pass is valid only if sliding is prevented: with the friction given, the body slides "
    "before it rocks from PGA {pga} upwards",
    "counts-at-rest": "a pass is valid only if every resisting tie and force acts in full as the motion starts: "
    "they count in the multiplier, but are not shown to last",
    "side-walls-hold": "a pass is valid only if the side walls are toothed into the wall as given, over the whole "
    "height of what turns, and no crack parts them yet",
    "side-walls-part": "with the friction of its side walls the upper {height} of the wall resists least, in front of "
    "cracks in them at tan(β) = {slope} from the vertical: no more friction counts than gives the wall the multiplier "
    "of that part, {multiplier}; examine it as a mechanism of its own",
    "holds-to-its-end": "a pass is valid only if each of these acts in full up to the displacement at which it ends, "
    "and what it is anchored to holds it: {what}",
    "seats-hold": "a pass at {state} is valid only if the seats that are not given are longer than what moves on them "
    "at the displacement capacity: {seats}",
    "seat-travel": "{what}: {moved}",
    "not-scanned": "a pass by histories is valid only if no lower PGA is worse, which was not looked at: [analysis] "
    "scan = true runs the histories at rising PGA",
    "one-component": "a pass is valid for one horizontal component alone; with the other components of the motion "
    "it needs a capacity of {factor} times the action, which is not shown",
    "no-vertical-on-floor": "a pass is valid without vertical motion: histories have none, and {key} does not give "
    "that of the floor",
    # values that help
    "source-of-too-much": "the source of {key} vouches for no value in it: name a key, or the innermost table that "
    "holds it",
    "source-to-fill-in": 'the source of {key}, "{text}", is still to be filled in and vouches for nothing yet: write '
    "by which test or survey, by whom and when",
    "source-needed": "{key} = {value} has no source, and without it the case cannot be read, so that no pass may rest "
    "on it; name who vouches for it in [report.sources]",
    "override-unsourced": "{key} = {value} has no source; {without}: {outcome}, up to {margin} times the action",
    "override-unsourced-falls": "{key} = {value} has no source; {without}, what it bears on falls under its own loads",
    "override-unsourced-unknown": "{key} = {value} has no source; {without}: {outcome}",
    "override-sourced": "{key} = {value} ({source}); {without}: {outcome}, up to {margin} times the action",
    "override-sourced-falls": "{key} = {value} ({source}); {without}, what it bears on falls under its own loads",
    "override-sourced-unknown": "{key} = {value} ({source}); {without}: {outcome}",
    "without": "without it",
    "without-value": "with {instead}",
    "worst-of-range": "with the worst of its range, {instead}",
    "outcome-with-index": "{outcome}, {name} {index}",
    # conditions and gaps of the verdict
    "no-deciding-method": "no method that may decide {state} was requested or applies: {methods}",
    "missing-key": "{key}: {text}",
    "missing-of-mechanism": "{mechanism}: {procedure}: {reason}",
    "missing-basis": "which code decides; the site's spectrum does not determine it",
    "missing-class-by-state": "{state} is not satisfied, which decides in class of use IV",
    "missing-target": "the share of the new building standard to be reached, 34, 67 or 100, has no default",
    "missing-rigid-whole": "{what}: it is taken as one rigid block, as a whole building would be; draw the parts that "
    "move as bodies of their own, or name who vouches that these move as one",
    "missing-works": "the index before the works: local works have no threshold, but are not to lower it, and where "
    "they are against local collapses its increase is to be evaluated (NTC 8.4.1)",
    "missing-target-of-class-I": "the index before the works, to compare it with that after: of an improvement in "
    "class I no threshold is stated (NTC 8.4.2)",
    "compared-with-index-before": "no threshold is stated (NTC 8.4.1, 8.4.2): the increase from an index of {before} "
    "is for the engineer to judge",
    "before-incomplete": "the index before the works: a mechanism of {file} has no answer by a method that decides; "
    "complete that project, of no works, and run it again",
    "gone-since-before": "{mechanisms} of the state before the works: not examined here, so that the index may rise "
    "for want of the weakest; examine them, or name the source that shows them to be gone",
    "gone-by-source": "a pass is valid only if {mechanisms} of the state before the works are gone, as a source says",
    "before-unlisted": "the index before the works: no list in the folder of {file} shows that it is as the program "
    "wrote it; keep the folder of that run together, or name the source of its results",
    "unlisted-by-source": "a pass is valid only if {file} is as the program wrote it: no list in its folder shows it, "
    "a source vouches for it",
    "differs-before": "{before} in the state before the works, {here} here",
    "only-before": "drawn only in the state before the works",
    "only-here": "drawn only after the works",
    "load-gone": "{kind} of the state before the works that is gone here: the works must remove or replace it",
    "load-new": "{kind} here alone, not in the state before the works: it must be part of the works",
    "tie-new": "{kind} here alone, not in the state before the works",
    "same-building": "a pass is valid only if the state before the works is of the same building: {differences}",
    "gone-there": "{key} ({kind}) was there and is gone here",
    "new-here": "{key} ({kind}) was not there and is here",
    "differs-there": "{key} was {before} there and is {here} here",
    "differs-more": "{number} more in the list of differences",
    "index-falls": "the works lower the index from {before} to {after} (NTC 8.4.1)",
    "missing-class-of-improvement": "the class of use, on which the target of an improvement depends (NTC 8.4.2)",
    "missing-class-of-hazard": "the class of use, on which the return period of the action depends; provisional: the "
    "action is that of class {taken}, the severest",
    "missing-effective-height": "the height of the resultant of the building's first mode; provisional: {height}, of "
    "the linear mode of Circolare 7/2019, C7.2.10",
    "missing-importance-level": "the importance level, 1 to 4, on which the return period of ULS depends (NZS 1170.0, "
    "Table 3.3)",
    "missing-return-period-of-level": "importance level {level} asks for ULS at {years} years, R = {needed}; the "
    "spectrum has R = {given}",
    "missing-importance-factor": "importance class {class} asks for γ_I = {needed} (EN 1998-1, 4.2.5); the spectrum "
    "has {given}, by its importance_factor or return period",
    "missing-return-period": "the return period of the spectrum, which is given as a table",
    "missing-damping-of-table": "the damping of the spectrum, which is given as a table",
    "missing-return-period-of-state": "{state} asks for a return period of {years}; the spectrum is that of {given}",
    "missing-return-period-of-class": "{state} in class of use {class} asks for a return period of {years} where the "
    "nominal life is 50 years; the spectrum is that of {given}. For another nominal life give the hazard over return "
    "periods",
    "missing-class-of-return-period": "the class of use, on which the return period of {state} depends: {years} in "
    "class {taken}, and the spectrum is that of {given}",
    "missing-school": "whether the building is a school, for which class III asks 0.60 (NTC 8.4.2)",
    "missing-index-before": "the index before the works, which an improvement raises by at least 0.10 (NTC 8.4.2)",
    "missing-limit-state": "which limit state decides: {states}",
    "missing-spectrum-of-state": "the hazard is that of Italian limit states; {state} is decided by the spectrum of "
    "{states}: give it",
    "missing-state-of-spectrum": "which limit state the site's single spectrum represents; {state} is decided by the "
    "action of {states}",
    "missing-action-of-state": "the site's spectrum is that of {given}; {state} asks for the action of {states}",
    "missing-hazard": "the site's spectrum is that of {given}; {state} asks for the action of {states}: give the "
    "hazard over return periods",
    "missing-own-pga": "it scales the hazard to {share} of what the rows give, which decides nothing: remove it; "
    "[analysis] levels study other PGA",
    "missing-disintegration": "whether the masonry may disintegrate: the rigid chain is credible only where it does "
    "not (C8.7.1.2)",
    "missing-source": 'the source (survey, quality index, test) of {key} = "excluded"',
    "either": "{first} or {second}",
    "class-not-given": "a pass is valid for use classes I to III; class IV also requires {states}: give [building] "
    "use_class",
    "global-check": "a pass is valid for local mechanisms: an improvement or upgrading is shown for the whole "
    "building, whose global check is another (NTC 8.4.2, 8.4.3)",
    "phase-of-works": "a pass is valid only for a phase of works that lasts no more than {life} (NTC 2.4.1)",
    "floor-spectrum-of-other-code": "a pass is by the floor spectrum of another country's code: {clause}",
    "return-period-unstated": "a pass is valid only if the spectrum of the site is that of {state} with a return "
    "period of {years} (class of use {class}, nominal life of 50 years): [site] return_period does not say so",
    "dbe-by-asce7": "a pass is valid only if the spectrum by ASCE 7 (hazard = {hazard}) is no less than the design "
    "basis earthquake of ASCE/SEI 43-05",
    "premise-other-spectrum": "a pass is valid only if the engineer shows that {method} applies to a spectrum of "
    "{code}; it is written for those of {codes}",
    "premise-near-fault": "a pass is valid only if no major fault lies within 20 km: the clauses of TS 1170.5 on near "
    "faults were not read",
    "pga-lowered": "a pass is valid for site.pga = {given}, which replaces {own} from the parameters of the spectrum",
    "one-of-several": 'a pass is by the first of {procedures} that is answered, as rule = "any" has it: by another one '
    "of them the same mechanism may fail",
    "sliding-alone": "a pass is that it does not slide: no procedure of the basis examines whether it overturns",
    "top-held": "a pass is valid only if {mechanism} is held at its top and at its foot: as it begins to move, its "
    "supports take {force} at the top and {foot} at the foot",
    "top-unheld": "what holds the top of {mechanism}, {height} above the ground: a floor of the building (its height), "
    "or a floor, roof or tie among its loads",
    "not-drawn": "a pass is valid only if these are as stated, as no body is drawn that shows them and no source "
    "vouches for them; name one in [report.sources]: {keys}",
    "not-sought": "a pass is valid only for the mechanism as stated, as no weaker one is sought and no source vouches "
    "for it; name one in [report.sources]: {keys}",
    "struck-out": 'a pass is valid only if "{name}" cannot occur, which is struck out: {reason}',
    "slope-as-beam": "a pass is valid only if a ridge beam or a wall carries the upper end of {what}, which slopes one "
    "way: else it pushes, and has a thrust",
    "units-slide": "a pass is valid only if the units under the plate of {what} do not slide on their beds before a "
    "cone of masonry punches: course and overlap of the plate are not given",
    "far-wall-unexamined": "a pass is valid only if the engineer finds that the wall at the far end of {what} holds "
    "it; it is not examined: {reason}",
    "far-wall-held": 'a pass is valid only if the wall "{body}" at the far end of {what} is held from within, by '
    "{bodies}, and what these reach does not give way",
    "far-cone-masonry": "a pass is valid only if the masonry around the injected far end of {what} is no weaker in "
    "shear than at the plate, whose shear_strength its cone has",
    "far-wall-part": 'a pass is valid only if the wall at the far end of {what} holds it as a whole: only "{body}" is '
    "examined, and {bodies}, on it or under it, is not",
    "anchorage-computed": "a pass is valid only if the engineer finds the anchorage of {what} sound: no clause has "
    "formulas for it, and the program derives its own",
    "thrust-is-tied": "a pass is valid only if ties or tie-beams carry the thrust of {what} up to collapse",
    "falls-at-rest": "it falls under its own loads, uplift multiplier {multiplier}: {reason}",
    "falls-at-rest-unknown": "it falls under its own loads: {reason}",
    "examined-above-cut": "a pass holds for what lies above the cut; no mechanism examines {bodies} from the base",
    "premise-anchorage": "a pass is valid only if the wall is anchored to floors and roof",
    "premise-anchorage-foot": "a pass is valid only if the building holds the wall at its foot, by anchorage to the "
    "roof or the floor there",
    "premise-collar-joints": "a pass is valid only if the collar joints between the leaves are sound",
    "premise-coursed": "a pass is valid for coursed masonry, not for rubble: state which it is in "
    "procedures.asce41-13.masonry",
    "premise-importance-class": "a pass is valid only for a building of importance class {class} or lower (EN 1998-1, "
    "4.2.5), for which γ_I = {given}: [building] use_class does not say so",
    "premise-no-floors": "a pass is valid only for an element that carries no floor, such as a gable, parapet or "
    "chimney",
    "other-spectrum": "written for spectra of {codes}, here on one of {code}: for information",
    "period-of": "{symbol} = {period}",
    "period-or-building": "{symbol} = {period}, or T1 of the building,",
    "period-or-floor": "b T1' = {period}",
    # warnings and notes of a project
    "box-size": "a number without a unit is in m, so this is {given}; if another unit was meant, write {likely}",
    "density-odd": "a density of {given} is outside what masonry and floors have, {least} to {most}; is a digit or a "
    "unit wrong?",
    "friction-large": "a coefficient of friction of {given} is more than masonry has, {most}; is a point lost?",
    "level-large": "a level of {given} is beyond any plausible site, {most}; is it in another unit?",
    "corner-long": "T_C* of {given} is longer than at any site in Italy, {most}; is a point lost?",
    "corner-short": "T_C* of {given} is shorter than at any site in Italy, {least}, which makes the demand too small; "
    "is a point or a unit wrong?",
    "material-unit": "a number without a unit is in SI, so this is {given}, which is impossible for masonry; write "
    "{likely} if that was meant, and check the units of the other numbers",
    "weight-density": "{given} is a weight per volume; divided by standard gravity, 9.80665 m/s2, it gives a "
    "density of {density}",
    "unit": '{given} is {as_g}; write "{number} g" if that was meant',
    "equation": '"linearised": it assumes an uplift threshold, which the joints of {mechanisms} do not have: below '
    'it, histories of the linearised equation do not move at all; write "exact"',
    "not-amplified": "above the ground, but shaken by the ground motion unamplified in {procedures}, which may fail "
    'and cannot pass: {mechanisms}; give amplification = {{ method = "modal-filter" }}',
    "two-first-modes": "histories use a first mode of {frequency}, the floor clauses of the codes a period of "
    "{period}; give period = {reciprocal} so that both refer to the same building",
    "confidence-factor": "crushing of the masonry is not modelled in {mechanisms}: under {circular}, the FC of LC1, "
    "{least}, decides there",
    "sweep": "swept: the mechanism is represented by its most critical case, {case} (cases evaluated: {cases})",
    "worse-as-typed": "worse with the values of the file than with those that stand in for values without a source: "
    "the numbers are those of the file",
    "falls-replaced": "it falls at rest with the values that stand in for values without a source, and fails: what is "
    "shown of it beside the verdict is with the values of the file",
    "worst-of-range-apart": "the value of a range that is worst for this mechanism is not the one that is worst for "
    "the others: the numbers are those with its own",
    "sweep-as-typed": "swept: no case is more critical than the value of the file itself, which represents the "
    "mechanism",
    "sweep-left-out": "not swept in the envelopes, which use the values in the file: {keys}; `assess run` evaluates "
    "every case",
    # automatic controls
    "control-reactions": "sums over the whole mechanism as rocking about {hinge} starts, at {multiplier}",
    "control-without-hinges": "not made: the mechanism is given by its rocking parameters, without faces at its hinges",
    "control-energy-of-masses": "record {record} at {level}: energies from masses, heights and speeds, with the loss "
    "at {impacts} impacts",
    "control-energy-of-table": "record {record} at {level}: energies from the capacity curve, as joints deform, "
    "forces end or the equation is linearised, with the loss at {impacts} impacts",
    "control-free-rocking": "no history at the site's level rocks: free rocking from half the overturning rotation "
    "to the first impact",
    "control-no-impact": "not made: released at half its overturning rotation, the mechanism does not come back",
    "control-moments": "by moments about the hinges, from masses and lever arms, as rocking about {hinge} starts",
    "control-rigid-moments": "the largest multiplier on joints that deform or crush is {lower} below that of rigid "
    "hinges, by moments: the resultant lies inside the edge; the two need not agree",
    "control-coarser": "record {record} at {level}, again with half the rotations in the table and {factor} times "
    "the error allowed in a step",
    "control-coarser-table": "no history at the site's level rocks: from half the rotations in the table",
    "control-chaotic": "not made: records that differ by a thousandth and less part as far as a coarser table does; "
    "how far the history can be trusted counts in the verdict, as its numerical spread",
    "control-without-table": "not made: the linearised equation has no table, and its steps have no error",
    "control-not-in-equilibrium": "automatic control failed: the reactions differ from weights, loads and inertia by "
    "{difference} of the weight ({tolerance} allowed); do not use the results of this mechanism until the cause is "
    "found",
    "control-energy-lost": "automatic control failed: the energy balance is off by {difference} of the largest "
    "energy ({tolerance} allowed); do not use the histories of this mechanism until the cause is found",
    "control-other-multiplier": "automatic control failed: the uplift multiplier differs by {difference} from that "
    "by moments about the hinges ({tolerance} allowed); do not use the results of this mechanism until the cause is "
    "found",
    "control-not-converged": "automatic control failed: the response changes by {difference} with a coarser table "
    "and coarser steps ({tolerance} allowed): it is sensitive to small differences; judge by the whole suite",
    # the annex of verification
    "annex-other-sources": "the annex of verification {file} was made by other sources of the program than this run; "
    "make it again with `assess verify`",
    "annex-failures": "of the {cases} solved cases in the annex of verification {file}, {failures} fail; rely on no "
    "result that they concern before the cause is known",
    "annex-quick": "the annex of verification {file} contains only the quick cases; make it again without --quick",
    "annex-left-aside": "the annex of verification {file} is left aside: {why}",
    "annex-left-out": "the annex of verification {file} leaves out {number} of the program's cases that concern this "
    "project; make it again with `assess verify`, without naming cases",
    "annex-foreign": "the annex of verification {file} has {number} cases that are not as they come with the program",
    "annex-pdf": "the PDF beside the annex of verification {file} is missing or is not the one written with it; make "
    "both again with `assess verify`",
    "annex-uncovered": "no solved case that passes in the annex of verification {file} and is more than indicative "
    "exercises these things that the project uses: {uses}",
    # folders of results
    "writing-finished": "an earlier command was interrupted while writing its files; the remaining files are now in "
    "place",
    "writing-taken-back": "an earlier command was interrupted while writing its files, which do not match the files "
    "there now: those were kept, and the unfinished output is in {place}",
    "results-changed": "these results have been changed since the program wrote them, so their numbers cannot be "
    "trusted; run the project again",
}
