"""The whole tree of one run, with its comparison of mechanisms and its automatic controls."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.verdict import Verdict
from assess.messages.message import Message
from assess.results.ground_motion import GroundMotionResult, RecordResult, SpectrumResult
from assess.results.inputs import Input, Program, ResolvedValue
from assess.results.mechanism import MechanismResult
from assess.results.report_matter import NO_MATTER, ReportMatter
from assess.results.response import CriticalResult
from assess.results.variations import SensitivityResult, SweepResult, UncertaintyResult
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
    project: dict[str, ResolvedValue]
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


@dataclass(frozen=True, repr=False)
class ComparisonRow(ShortRepr):
    """One row of the comparison; rotation_ratio is None where the mechanism overturned or rotation is not known."""

    mechanism: str
    level_pga_g: float
    procedure: str
    rotation_ratio: float | None
    allowable_ratio: float | None
    demand_capacity: float | None


ControlKind = Literal["equilibrium", "energy", "hand-multiplier", "convergence"]


@dataclass(frozen=True, repr=False)
class Control(ShortRepr):
    """One control of one mechanism: a value of the run beside a reference found another way.

    Values are in SI. `value`, `reference`, `difference` and `met` are None where the control was not made; `note` says
    why. `met` is also None where the two need not agree, which the note explains.

    Parameters
    ----------
    kind : str
        "equilibrium", "energy", "hand-multiplier" or "convergence".
    mechanism : str
        Name of the mechanism.
    quantity : str
        What is compared, in English.
    value : float, optional
        The program's own value.
    reference : float, optional
        The value it is compared with.
    dimension : str
        Dimension of both, a key of `assess.messages.message.UNITS`.
    difference : float, optional
        Relative difference; docs/controls.md says relative to what.
    tolerance : float
        The largest difference that is accepted; 0 where there is none.
    met : bool, optional
        Whether the difference is within the tolerance.
    note : Message
        How the control was made, or why it was not.
    """

    kind: ControlKind
    mechanism: str
    quantity: str
    value: float | None
    reference: float | None
    dimension: str
    difference: float | None
    tolerance: float
    met: bool | None
    note: Message
