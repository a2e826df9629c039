"""The English text of messages on fragility, risk, sensitivity and uncertain numbers, by key."""

from __future__ import annotations

from collections.abc import Mapping

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
