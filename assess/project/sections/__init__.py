"""The tables of a project file, one class each; every quantity is an SI float. Attributes are named as the keys.

The sentence below a key is its description in the JSON Schema and in the message when it is missing.
"""

from assess.project.sections.analysis import (
    SHARE,
    Analysis,
    Change,
    Fragility,
    Pulses,
    Risk,
    Sensitivity,
    Uncertainty,
    measure_of,
)
from assess.project.sections.bodies_and_loads import BodySection, BoxBody, DirectBody, MaterialSection, MeshBody
from assess.project.sections.content import Content, Report
from assess.project.sections.ground_motion import BuildingSection, Records, Select, SiteSection
from assess.project.sections.mechanisms import ChainSection, HingesSection, MechanismSection, NoAmplification
from assess.project.sections.procedures import VerdictSection

__all__ = [
    "SHARE",
    "Analysis",
    "BodySection",
    "BoxBody",
    "BuildingSection",
    "ChainSection",
    "Change",
    "Content",
    "DirectBody",
    "Fragility",
    "HingesSection",
    "MaterialSection",
    "MechanismSection",
    "MeshBody",
    "NoAmplification",
    "Pulses",
    "Records",
    "Report",
    "Risk",
    "Select",
    "Sensitivity",
    "SiteSection",
    "Uncertainty",
    "VerdictSection",
    "measure_of",
]
