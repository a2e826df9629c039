"""The whole tree of one run."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.verdict import Verdict
from assess.messages.message import Message
from assess.results.comparison import ComparisonRow
from assess.results.controls import Control
from assess.results.envelopes import CriticalResult
from assess.results.ground_motion import GroundMotionResult
from assess.results.inputs import Input, Program, Resolved
from assess.results.mechanism import MechanismResult
from assess.results.report_matter import NO_MATTER, ReportMatter
from assess.results.sensitivity import SensitivityResult
from assess.results.site import RecordResult, SpectrumResult
from assess.results.sweeps import SweepResult
from assess.results.uncertainty import UncertaintyResult
from assess.results.verification import AnnexResult
from assess.short_repr import ShortRepr

SCHEMA_VERSION = 2


@dataclass(frozen=True, repr=False)
class Results(ShortRepr):
    """One run, whole.

    project : maps each key, written with dots, to its resolved value
    stamp : of the inputs and the program, the same in every output of these results; "" in results of older versions
    uncertainty : None where the project gives no uncertain numbers, and in results of older versions
    verification : the annex of verification that the run names; None where there is none
    """

    schema_version: int
    program: Program
    inputs: tuple[Input, ...]
    warnings: tuple[Message, ...]
    project: dict[str, Resolved]
    spectrum: SpectrumResult | None
    records: tuple[RecordResult, ...]
    mechanisms: tuple[MechanismResult, ...]
    critical: CriticalResult | None
    comparison: tuple[ComparisonRow, ...]
    sweeps: tuple[SweepResult, ...]
    verdict: Verdict | None = None
    ground_motion: GroundMotionResult | None = None
    sensitivity: tuple[SensitivityResult, ...] = ()
    stamp: str = ""
    report: ReportMatter = NO_MATTER
    controls: tuple[Control, ...] = ()
    uncertainty: UncertaintyResult | None = None
    verification: AnnexResult | None = None
