"""The tables of a project file, one class each; every quantity is an SI float. Attributes are named as the keys.

The sentence below a key is its description in the JSON Schema and in the message when it is missing.
"""

from assess.project.sections.amplification import (
    FirstModeAmplification,
    FloorAmplification,
    NoAmplification,
    PrintedAmplification,
    RaisedAmplification,
)
from assess.project.sections.analysis import Procedures, Records
from assess.project.sections.bodies import Body, BoxBody, DirectBody, Material, MeshBody, ProfileBody
from assess.project.sections.content import Content
from assess.project.sections.interfaces import Interface, Shape
from assess.project.sections.italian import FreeElement, Italian
from assess.project.sections.loads import BodyLoad, ForceLoad, LoadTable, MassLoad, OverburdenLoad, TieLoad
from assess.project.sections.mechanisms import (
    Chained,
    CutAngle,
    CutPlane,
    EquivalentBlock,
    FourHinge,
    FourHinges,
    Hinges,
    Mechanism,
    RadialJoints,
    SingleBlock,
    TwoBlock,
)
from assess.project.sections.procedure_names import PROCEDURES
from assess.project.sections.pulses import Pulses
from assess.project.sections.select import Select
from assess.project.sections.sensitivity import SHARE, Change, Sensitivity
from assess.project.sections.site import Building, Site
from assess.project.sections.spectra import (
    Asce7MappedSpectrum,
    Asce7Spectrum,
    Ec8Spectrum,
    NtcHazardSpectrum,
    NtcSpectrum,
    Nzs1170Spectrum,
    Spectrum,
    TableSpectrum,
)
from assess.project.sections.sweeps import Sweep
from assess.project.sections.verdict import VerdictSection

__all__ = [
    "PROCEDURES",
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
    "FirstModeAmplification",
    "FloorAmplification",
    "ForceLoad",
    "FourHinge",
    "FourHinges",
    "FreeElement",
    "Hinges",
    "Interface",
    "Italian",
    "LoadTable",
    "MassLoad",
    "Material",
    "Mechanism",
    "MeshBody",
    "NoAmplification",
    "NtcHazardSpectrum",
    "NtcSpectrum",
    "Nzs1170Spectrum",
    "OverburdenLoad",
    "PrintedAmplification",
    "Procedures",
    "ProfileBody",
    "Pulses",
    "RadialJoints",
    "RaisedAmplification",
    "Records",
    "Select",
    "Sensitivity",
    "Shape",
    "SingleBlock",
    "Site",
    "Spectrum",
    "Sweep",
    "TableSpectrum",
    "TieLoad",
    "TwoBlock",
    "VerdictSection",
]
