"""The tables of a project file, one class each; every quantity is an SI float. Attributes are named as the keys.

The sentence below a key is its description in the JSON Schema and in the message when it is missing.
"""

from assess.project.sections.analysis import (
    SHARE,
    Change,
    Fragility,
    Pulses,
    Risk,
    Sensitivity,
    Uncertainty,
    measure_of,
)
from assess.project.sections.bodies import Body, BoxBody, DirectBody, Material, MeshBody
from assess.project.sections.content import Content, Report
from assess.project.sections.loads import BodyLoad, ForceLoad, MassLoad, OverburdenLoad, TieLoad
from assess.project.sections.mechanisms import (
    Chained,
    CutAngle,
    CutPlane,
    EquivalentBlock,
    FourHinge,
    Hinges,
    Interface,
    Mechanism,
    NoAmplification,
    RadialJoints,
    SingleBlock,
    TwoBlock,
)
from assess.project.sections.procedures import FreeElement, Italian, VerdictSection
from assess.project.sections.records import Records, Select
from assess.project.sections.site import (
    Asce7MappedSpectrum,
    Asce7Spectrum,
    Building,
    Ec8Spectrum,
    NtcHazardSpectrum,
    NtcSpectrum,
    Nzs1170Spectrum,
    Site,
    Spectrum,
    TableSpectrum,
)

__all__ = [
    "SHARE",
    "Asce7MappedSpectrum",
    "Asce7Spectrum",
    "Body",
    "BodyLoad",
    "BoxBody",
    "Building",
    "Chained",
    "Change",
    "Content",
    "CutAngle",
    "CutPlane",
    "DirectBody",
    "Ec8Spectrum",
    "EquivalentBlock",
    "ForceLoad",
    "FourHinge",
    "Fragility",
    "FreeElement",
    "Hinges",
    "Interface",
    "Italian",
    "MassLoad",
    "Material",
    "Mechanism",
    "MeshBody",
    "NoAmplification",
    "NtcHazardSpectrum",
    "NtcSpectrum",
    "Nzs1170Spectrum",
    "OverburdenLoad",
    "Pulses",
    "RadialJoints",
    "Records",
    "Report",
    "Risk",
    "Select",
    "Sensitivity",
    "SingleBlock",
    "Site",
    "Spectrum",
    "TableSpectrum",
    "TieLoad",
    "TwoBlock",
    "Uncertainty",
    "VerdictSection",
    "measure_of",
]
