"""Sentences on fragility and risk that an owner or an insurer can read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from assess.results.fragility import (
    FragilityCurve,
    FragilityMethod,
    HazardResult,
    LognormalResult,
    MeasureResult,
    MechanismFragility,
    RateGap,
    RiskResult,
)
from reports.intensity_measures import (
    FIGURES,
    PERCENT,
    RATE_FIGURES,
    intensity,
    interval,
    last_state,
    main_curve,
    main_risk,
    measure_text,
    percent,
    state_text,
)
from reports.language.texts import Phrase, Text, Verbatim, count, listing, quantity, say, say_count

METHODS: Mapping[FragilityMethod, Phrase] = {
    "ida": say(
        "Each record is scaled step by step up to the largest scale and run at every step, in both polarities; the "
        "worse counts."
    ),
    "stripes": say(
        "At each intensity the records are scaled to it and run in both polarities; the worse counts."
    ),
    "cloud": say(
        "Each record is run as it is, in both polarities; the worse counts. A point is the share of some ten records "
        "of similar intensity; the lognormal is the one equivalent to the regression of the rotations on the intensity."
    ),
}  # fmt: skip
RATE_CURVES: Mapping[str, Phrase] = {
    "empirical": say("from the shares counted"),
    "lognormal": say("from the lognormal"),
    "first": say("bound, from the first intensity"),
}
GAPS: Mapping[RateGap, Phrase] = {
    "motion": say(
        "the mechanism is above the ground and is not shaken by the motion there; give its amplification by the "
        "modal filter"
    ),
    "runs": say(
        "the hazard has stronger motions than those that were run; run to a larger intensity, or give stronger records"
    ),
    "hazard": say(
        "stronger or more frequent motions than the hazard lists may add to it; give a hazard of more return periods"
    ),
    "epistemic": say(
        "what is not known of the mechanism itself is not in the rate; give its dispersion in [analysis.fragility] "
        "epistemic"
    ),
}


def mechanism_summary(mechanism: MechanismFragility, hazards: Sequence[HazardResult] = ()) -> Iterator[Text]:
    """Yield what an owner should know of a mechanism: the intensities that overturn it, then its annual rate.

    Parameters
    ----------
    mechanism : with its curves and rates
    hazards : of the site, to say why there is no rate though one is given
    """
    curve, risk = main_curve(mechanism), main_risk(mechanism)
    if curve is not None:
        yield intensity_sentence(curve)
        yield from _extrapolated(curve)
    if risk is not None:
        yield rate_sentence(risk)
        if risk.target_rate is not None:
            yield target_sentence(risk)
    elif hazards:
        yield no_rate_sentence(mechanism, hazards)


def no_rate_sentence(mechanism: MechanismFragility, hazards: Sequence[HazardResult]) -> Text:
    """Say why a mechanism has no annual rate although the hazard of the site is given."""
    state, measures = last_state(mechanism), [hazard.measure for hazard in hazards]
    found = [each for each in mechanism.curves if each.state == state and each.measure in measures]
    if found:
        return say(
            "How likely it is each year is not answered: the rate of a cloud is that of its lognormal, and there is "
            "none by {measure}: {why}.",
            measure=measure_text(found[0].measure),
            why=found[0].notes[0] if found[0].notes else say("the records do not bound one"),
        )
    return say(
        "How likely it is each year is not answered: there is no curve by {measures}, the measure of the hazard.",
        measures=listing(map(measure_text, measures)),
    )


def intensity_sentence(curve: FragilityCurve) -> Text:
    """Say at which intensity 5 % and 50 % of the records reach the state of a curve."""
    fitted = curve.lognormal
    if fitted is None:
        return _counted_sentence(curve)
    low, half = (
        value_with_interval(value, ends, curve.measure)
        for value, ends in (
            (fitted.five_percent, fitted.five_percent_interval),
            (fitted.median, fitted.median_interval),
        )
    )
    words = {"measure": measure_text(curve.measure), "low": low, "half": half}
    if curve.state.name == "overturning":
        return say(
            "Ground motions with {measure} of {low} overturn it in 5 cases of 100, those with {half} in 50 of 100.",
            **words,
        )
    return say(
        "Ground motions with {measure} of {low} bring it to {state} in 5 cases of 100, those with {half} in 50 of 100.",
        state=state_text(curve.state),
        **words,
    )


def _extrapolated(curve: FragilityCurve) -> Iterator[Text]:
    """Say where the median of a curve lies beyond the runs."""
    if curve.lognormal is None or not curve.empirical:
        return
    last = curve.empirical[-1]
    if curve.method == "cloud" and curve.lognormal.median > curve.end:
        yield say(
            "The strongest record has {most}: what is said of 50 of 100 is extrapolated.",
            most=intensity(curve.end, curve.measure),
        )
    elif curve.lognormal.median > curve.end:
        yield say(
            "The runs end at {most}, where {share} of the records reach it: what is said of 50 of 100 is extrapolated.",
            most=intensity(last.intensity, curve.measure),
            share=percent(last.share),
        )


def _counted_sentence(curve: FragilityCurve) -> Text:
    """Say what was counted where the records do not bound a curve."""
    if not curve.empirical:
        return say("There is no run by {measure} to count.", measure=measure_text(curve.measure))
    last = curve.empirical[-1]
    values: dict[str, Text] = {
        "measure": measure_text(curve.measure),
        "most": intensity(last.intensity, curve.measure),
        "state": state_text(curve.state),
    }
    if not any(point.reached for point in curve.empirical):
        return say("No record brings it to {state} up to {measure} of {most}, the highest examined.", **values)
    return say_count(
        "At {measure} of {most}, {number} record of {all} brings it to {state}; these runs do not bound a lognormal.",
        "At {measure} of {most}, {number} records of {all} bring it to {state}; these runs do not bound a lognormal.",
        last.reached,
        all=count(last.records),
        **values,
    )


def value_with_interval(value: float, ends: tuple[float, float] | None, measure: MeasureResult) -> Text:
    """Return an intensity with its interval in brackets, where it has one."""
    within = interval(ends, measure.dimension)
    shown = intensity(value, measure)
    return shown if within is None else say("{value} ({interval})", value=shown, interval=within)


def rate_sentence(risk: RiskResult) -> Text:
    """Say the annual rate of a state at the site, and its probability in 50 years."""
    return say(
        "With the hazard of the site, the annual rate of {state} is {rate}, a probability of {probability} in 50 "
        "years.",
        state=state_text(risk.state),
        rate=quantity(risk.annual_rate, "annual rate", RATE_FIGURES),
        probability=quantity(PERCENT * risk.probability_50_years, "percent", RATE_FIGURES),
    )


def target_sentence(risk: RiskResult) -> Text:
    """Say whether the rate is within the target that the project sets."""
    target = quantity(risk.target_rate or 0.0, "annual rate", FIGURES)
    wide = quantity(risk.with_epistemic or 0.0, "annual rate", RATE_FIGURES)
    if risk.outcome == "fail" and risk.gap == "epistemic":
        return say(
            "With the epistemic dispersion it is {rate}, more than the target of {target}; only without that "
            "dispersion is it within.",
            rate=wide,
            target=target,
        )
    if risk.outcome == "fail":
        return say("This is more than the target of {target}.", target=target)
    if risk.gap is None:
        return say(
            "With the epistemic dispersion it is {rate}, within the target of {target}.", rate=wide, target=target
        )
    return say("Whether this is within the target of {target} is not known: {why}.", target=target, why=GAPS[risk.gap])


def describe_counts(curve: FragilityCurve) -> Iterator[Text]:
    """Yield how many records make a curve, and what of them asks for care."""
    yield say_count(
        "{number} record of {events} makes this curve.",
        "{number} records of {events} make this curve.",
        curve.records,
        events=say_count("{number} earthquake", "{number} earthquakes", curve.events),
    )
    if curve.censored:
        yield say_count(
            "{number} of them does not reach the state at its largest scale and is counted as such.",
            "{number} of them do not reach the state at their largest scale and are counted as such.",
            curve.censored,
        )
    if curve.hollow:
        yield say_count(
            "{number} run behind it is of a record scaled by more than 4, which may not be like a real one of that "
            "strength.",
            "{number} runs behind it are of records scaled by more than 4, which may not be like real ones of that "
            "strength.",
            curve.hollow,
        )
    if curve.first is not None:
        yield say(
            "The dashed line is a bound and no fragility: rocking is not monotone, and a record may leave the "
            "mechanism standing above an intensity at which it reached the state."
        )


def islands_sentence(mechanism: MechanismFragility) -> Text:
    """Say how many records have islands."""
    number = sum(bool(run.islands) for run in mechanism.runs)
    if not number:
        return say("No record has an island: none leaves the mechanism standing above a scale that overturns it.")
    return say_count(
        "{number} record of {all} leaves the mechanism standing above a scale that overturns it (islands).",
        "{number} records of {all} leave the mechanism standing above a scale that overturns it (islands).",
        number,
        all=count(len(mechanism.runs)),
    )


def epistemic_sentences(mechanism: MechanismFragility) -> Iterator[Text]:
    """Yield the dispersion of what is not known of the mechanism, apart from that of records."""
    if mechanism.epistemic is None:
        yield say(
            "What is not known of the mechanism itself is not in these curves: its geometry, loads and materials are "
            "taken at their values in the project."
        )
        return
    parts = tuple(
        say("{key} {share}", key=Verbatim(key), share=quantity(share, figures=2))
        for key, share in (mechanism.epistemic_sources or {}).items()
    )
    total = quantity(mechanism.epistemic, figures=2)
    if parts:
        yield say(
            "Epistemic dispersion, of what is not known of the mechanism: {total} ({parts}). It is stated apart and is "
            "not in the curves; a target is compared with the rate that has it.",
            total=total,
            parts=listing(parts),
        )
    else:
        yield say(
            "Epistemic dispersion, of what is not known of the mechanism: {total}. It is stated apart and is not in "
            "the curves; a target is compared with the rate that has it.",
            total=total,
        )


def dispersion_text(fitted: LognormalResult) -> Text:
    """Return a dispersion with its interval."""
    shown = quantity(fitted.dispersion, figures=2)
    if fitted.dispersion_interval is None:
        return shown
    low, high = (quantity(end, figures=2) for end in fitted.dispersion_interval)
    return say("{value} ({interval})", value=shown, interval=say("{low} to {high}", low=low, high=high))
