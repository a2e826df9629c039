"""The tables of a project file, one class each; every quantity is an SI float. Attributes are named as the keys.

The sentence below a key is its description in the JSON Schema and in the message when it is missing.
"""

from assess.project.sections.amplification import NoAmplification
from assess.project.sections.analysis import Records
from assess.project.sections.bodies import Body, BoxBody, DirectBody, Material, MeshBody
from assess.project.sections.content import Content
from assess.project.sections.cuts import CutAngle, CutPlane
from assess.project.sections.fragility import Fragility, Risk, measure_of
from assess.project.sections.hinges import Hinges, RadialJoints
from assess.project.sections.interfaces import Interface
from assess.project.sections.italian import FreeElement, Italian
from assess.project.sections.loads import BodyLoad, ForceLoad, MassLoad, OverburdenLoad, TieLoad
from assess.project.sections.mechanisms import Chained, EquivalentBlock, FourHinge, Mechanism, SingleBlock, TwoBlock
from assess.project.sections.pulses import Pulses
from assess.project.sections.report import Report
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
from assess.project.sections.uncertainty import Uncertainty
from assess.project.sections.verdict import VerdictSection

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
