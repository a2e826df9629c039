"""The procedures by name. An unknown name raises and lists the known ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from assess.codes.asce41_13 import slenderness
from assess.codes.asce41_13.clauses import Options as Asce41Options
from assess.codes.asce43_05 import history, spectrum
from assess.codes.asce43_05.clauses import Options as Asce43Options
from assess.codes.check import Check
from assess.codes.context import Context
from assess.codes.dmi2008 import linear, nonlinear, nonlinear_thesis
from assess.codes.dmi2008.clauses import Options as Dmi2008Options
from assess.codes.en1998_1 import element
from assess.codes.en1998_1.clauses import Options as Ec8Options
from assess.codes.nzsee2017 import face_loaded
from assess.codes.nzsee2017.clauses import Options as Nzsee2017Options
from assess.errors import ProcedureError
from assess.oscillator import Oscillator

Assess = Callable[[Oscillator, Context], tuple[Check, ...]]


@dataclass(frozen=True)
class CodeOptions:
    """The options of every code."""

    asce43_05: Asce43Options = field(default_factory=Asce43Options)
    dmi2008: Dmi2008Options = field(default_factory=Dmi2008Options)
    nzsee2017: Nzsee2017Options = field(default_factory=Nzsee2017Options)
    asce41_13: Asce41Options = field(default_factory=Asce41Options)
    ec8: Ec8Options = field(default_factory=Ec8Options)


PROCEDURES: dict[str, Callable[[CodeOptions], Assess]] = {
    "asce43-05-spectrum": lambda options: partial(spectrum.assess, options=options.asce43_05),
    "asce43-05-spectrum-thesis": lambda options: partial(spectrum.assess_thesis, options=options.asce43_05),
    "asce43-05-history": lambda options: partial(history.assess, options=options.asce43_05),
    "dmi2008-linear": lambda options: partial(linear.assess, options=options.dmi2008),
    "dmi2008-nonlinear": lambda options: partial(nonlinear.assess, options=options.dmi2008),
    "dmi2008-nonlinear-thesis": lambda options: partial(nonlinear_thesis.assess, options=options.dmi2008),
    "nzsee2017-face-loaded": lambda options: partial(face_loaded.assess, options=options.nzsee2017),
    "asce41-13-ht": lambda options: partial(slenderness.assess, options=options.asce41_13),
    "ec8-element": lambda options: partial(element.assess, options=options.ec8),
}


def procedure(name: str, options: CodeOptions) -> Assess:
    """The procedure `name` with its code's options put in; ProcedureError for an unknown name."""
    if name not in PROCEDURES:
        raise ProcedureError(f'procedure "{name}" is not known; known are: {", ".join(PROCEDURES)}')
    return PROCEDURES[name](options)
