"""The results of a run as one frozen tree: the content of results.json, field by field.

Names of fields end in their units. The tree is pure data, without clock or number of jobs: the same input gives the
same bytes.
"""

from assess.results.amplification import AmplificationResult, CarriedMotion, Factor
from assess.results.comparison import ComparisonRow
from assess.results.controls import Control, ControlKind
from assess.results.directions import DirectionCandidate, DirectionSweep
from assess.results.drawing import Displaced, Drawing, DrawnLoad, NamedPoint
from assess.results.envelopes import CriticalBand, CriticalResult, EnvelopeResult
from assess.results.ground_motion import (
    EquivalentPeriods,
    GroundMotionResult,
    Remaining,
    RequirementResult,
    SelectionResult,
)
from assess.results.histories import HistoryResult, SuiteResult, Trace
from assess.results.inputs import Input, Program, Resolved
from assess.results.joints import BranchMoment, ContactSheet, HingeForceResult, InterfaceCurves
from assess.results.loads import Lasting, LoadResult
from assess.results.mechanism import MechanismResult
from assess.results.oscillator import BranchCurve, Curve, LinearisedResult, OscillatorResult
from assess.results.report_matter import (
    NO_MATTER,
    ChecklistItem,
    ChecklistOutcome,
    MediaType,
    Picture,
    ReportMatter,
    Revision,
)
from assess.results.run import SCHEMA_VERSION, Results
from assess.results.sensitivity import SensitivityResult
from assess.results.site import PrimaryPulse, RecordResult, RecordSpectrum, SpectrumResult
from assess.results.sweeps import SweepResult
from assess.results.values import Floats, Place, Point, Ring
from assess.results.view import Axis, View

__all__ = [
    "NO_MATTER",
    "SCHEMA_VERSION",
    "AmplificationResult",
    "Axis",
    "BranchCurve",
    "BranchMoment",
    "CarriedMotion",
    "ChecklistItem",
    "ChecklistOutcome",
    "ComparisonRow",
    "ContactSheet",
    "Control",
    "ControlKind",
    "CriticalBand",
    "CriticalResult",
    "Curve",
    "DirectionCandidate",
    "DirectionSweep",
    "Displaced",
    "Drawing",
    "DrawnLoad",
    "EnvelopeResult",
    "EquivalentPeriods",
    "Factor",
    "Floats",
    "GroundMotionResult",
    "HingeForceResult",
    "HistoryResult",
    "Input",
    "InterfaceCurves",
    "Lasting",
    "LinearisedResult",
    "LoadResult",
    "MechanismResult",
    "MediaType",
    "NamedPoint",
    "OscillatorResult",
    "Picture",
    "Place",
    "Point",
    "PrimaryPulse",
    "Program",
    "RecordResult",
    "RecordSpectrum",
    "Remaining",
    "ReportMatter",
    "RequirementResult",
    "Resolved",
    "Results",
    "Revision",
    "Ring",
    "SelectionResult",
    "SensitivityResult",
    "SpectrumResult",
    "SuiteResult",
    "SweepResult",
    "Trace",
    "View",
]
