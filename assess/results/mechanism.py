"""Everything about one mechanism."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from assess.codes.check import Check
from assess.messages.message import Message, Term
from assess.results.amplification import AmplificationResult
from assess.results.directions import DirectionCandidate, DirectionSweep
from assess.results.drawing import Drawing
from assess.results.envelopes import EnvelopeResult
from assess.results.histories import HistoryResult, SuiteResult
from assess.results.joints import ContactSheet, HingeForceResult, InterfaceCurves
from assess.results.loads import LoadResult
from assess.results.oscillator import Curve, OscillatorResult
from assess.results.view import View
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class MechanismResult(ShortRepr):
    """Everything about one mechanism; direction_sweep is None unless its direction was sought on a whole circle.

    oscillator, curve: with every action that is there at rest. deciding_curve: with actions that are shown to last to
    collapse and those that drive; displacements and histories are of this curve, and their ratios refer to its
    overturning rotations (deciding_overturning_rad, of rigid joints, positive and negative). Both are None if the two
    curves are the same, or if the mechanism falls at rest without the other actions.
    direction: of positive rotation, horizontal; None for an equivalent block. candidates: directions among which the
    weakest was found, or with which a given one was compared. base_elevation_m: of its base above the ground;
    input_height_m: of its support, the mean of base and far support if it has both; above_ground: whether that counts
    as above the ground; ground_known_from: source of the level of the ground. restitution_source: the English of
    restitution_said.
    """

    name: str
    label: str
    kind: str
    sides: Literal["one", "two"]
    equation: Literal["exact", "linearised"]
    drawing: Drawing
    view: View | None
    oscillator: OscillatorResult
    oscillator_negative: OscillatorResult | None
    curve: Curve
    interfaces: tuple[dict[str, Any], ...]
    amplification: AmplificationResult
    checks: tuple[Check, ...]
    histories: tuple[HistoryResult, ...]
    suites: tuple[SuiteResult, ...]
    envelope: EnvelopeResult | None
    restitution_source: str
    loads: tuple[LoadResult, ...]
    direction_sweep: DirectionSweep | None
    interface_curves: InterfaceCurves | None = None
    hinge_forces: tuple[HingeForceResult, ...] = ()
    deciding_curve: Curve | None = None
    deciding_overturning_rad: tuple[float, float | None] | None = None
    direction: tuple[float, float, float] | None = None
    candidates: tuple[DirectionCandidate, ...] = ()
    base_elevation_m: float | None = None
    input_height_m: float | None = None
    above_ground: bool | None = None
    ground_known_from: str = ""
    restitution_said: tuple[Term | Message, ...] = ()
    contact_sheets: tuple[ContactSheet, ...] = ()
