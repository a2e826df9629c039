"""Messages on a whole study."""

from __future__ import annotations

from collections.abc import Mapping

from assess.messages.message import Message, locate, note, warning
from assess.study.motions import ScaledRecord
from assess.study.study import Study
from assess.study.sweep_cases import MechanismSweep
from assess.study.sweep_results import case_messages
from assess.study.verdict import by_motion


def study_messages(study: Study, controlling: Mapping[str, MechanismSweep]) -> tuple[Message, ...]:
    """Return the messages of the study; those on a swept mechanism itself are of its controlling case."""
    swept = [mechanism for mechanism in study.mechanisms if mechanism.name in controlling]
    replaced = [each for one in swept for each in locate(one.warnings, f"mechanisms.{one.name}")]
    kept = [message for message in study.messages if message not in replaced]
    return (*kept, *(message for sweep in controlling.values() for message in case_messages(sweep)))


def suite_messages(study: Study, motions: tuple[ScaledRecord, ...]) -> tuple[Message, ...]:
    """Return the messages on artificial records; a note only if no method that follows the ground's motion decides."""
    if not any(motion.record.artificial for motion in motions):
        return ()
    return ((warning if by_motion(study.question) else note)("artificial-records", "records"),)


def envelope_messages(study: Study) -> tuple[Message, ...]:
    """Return the messages on envelopes, where no procedure of a code is used."""
    kept = tuple(message for message in study.messages if message.key != "confidence-factor")
    if not study.sweeps:
        return kept
    keys = ", ".join(sweep.key for sweep in study.sweeps)
    return (*kept, warning("sweep-left-out", "analysis.sweep", keys=keys))
