"""The procedures by name. An unknown name raises and lists the known ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from assess.codes import sliding
from assess.codes.asce43_05 import history, spectrum
from assess.codes.asce43_05 import sliding as asce43_05_sliding
from assess.codes.asce43_05.clauses import Options as Asce43Options
from assess.codes.check import Check
from assess.codes.context import Context
from assess.codes.dmi2008 import linear, nonlinear, nonlinear_thesis
from assess.codes.dmi2008.clauses import Options as Dmi2008Options
from assess.errors import ProcedureError
from assess.oscillator import Oscillator

Assess = Callable[[Oscillator, Context], tuple[Check, ...]]


@dataclass(frozen=True)
class CodeOptions:
    """The options of every code."""

    asce43_05: Asce43Options = field(default_factory=Asce43Options)
    dmi2008: Dmi2008Options = field(default_factory=Dmi2008Options)


PROCEDURES: dict[str, Callable[[CodeOptions], Assess]] = {
    "asce43-05-spectrum": lambda options: partial(spectrum.assess, options=options.asce43_05),
    "asce43-05-spectrum-thesis": lambda options: partial(spectrum.assess_thesis, options=options.asce43_05),
    "asce43-05-history": lambda options: partial(history.assess, options=options.asce43_05),
    "dmi2008-linear": lambda options: partial(linear.assess, options=options.dmi2008),
    "dmi2008-nonlinear": lambda options: partial(nonlinear.assess, options=options.dmi2008),
    "dmi2008-nonlinear-thesis": lambda options: partial(nonlinear_thesis.assess, options=options.dmi2008),
    "asce43-05-sliding": lambda options: partial(asce43_05_sliding.assess, options=options.asce43_05),
    "sliding": lambda options: sliding.assess,
}


def procedure(name: str, options: CodeOptions) -> Assess:
    """The procedure `name` with its code's options put in; ProcedureError for an unknown name."""
    if name not in PROCEDURES:
        raise ProcedureError(f'procedure "{name}" is not known; known are: {", ".join(PROCEDURES)}')
    return PROCEDURES[name](options)
