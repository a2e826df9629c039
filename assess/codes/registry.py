"""The procedures by name. An unknown name raises and lists the known ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from assess.codes import sliding
from assess.codes.asce41_13 import slenderness
from assess.codes.asce41_13.clauses import Options as Asce41Options
from assess.codes.asce43_05 import history, spectrum
from assess.codes.asce43_05 import sliding as asce43_05_sliding
from assess.codes.asce43_05.clauses import Options as Asce43Options
from assess.codes.check import Check
from assess.codes.context import Context
from assess.codes.dmi2008 import history as dmi2008_history
from assess.codes.dmi2008 import linear, nonlinear, nonlinear_thesis
from assess.codes.en1998_1 import element
from assess.codes.en1998_1.clauses import Options as Ec8Options
from assess.codes.italian.edition import Options as ItalianOptions
from assess.codes.italian.history import Rule
from assess.codes.ntc2018 import history as ntc2018_history
from assess.codes.ntc2018 import linear as ntc2018_linear
from assess.codes.ntc2018 import nonlinear as ntc2018_nonlinear
from assess.codes.nzsee2017 import face_loaded
from assess.codes.nzsee2017.clauses import Options as Nzsee2017Options
from assess.errors import ProcedureError
from assess.oscillator import Oscillator

Assess = Callable[[Oscillator, Context], tuple[Check, ...]]


@dataclass(frozen=True)
class CodeOptions:
    """The options of every code."""

    asce43_05: Asce43Options = field(default_factory=Asce43Options)
    dmi2008: ItalianOptions = field(default_factory=ItalianOptions)
    ntc2018: ItalianOptions = field(default_factory=ItalianOptions)
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
    "dmi2008-history": lambda options: partial(dmi2008_history.assess, options=options.dmi2008),
    "ntc2018-linear": lambda options: partial(ntc2018_linear.assess, options=options.ntc2018),
    "ntc2018-nonlinear": lambda options: partial(ntc2018_nonlinear.assess, options=options.ntc2018),
    "ntc2018-history": lambda options: partial(ntc2018_history.assess, options=options.ntc2018),
    "asce43-05-sliding": lambda options: partial(asce43_05_sliding.assess, options=options.asce43_05),
    "sliding": lambda options: sliding.assess,
}

LIMIT_STATES: dict[str, tuple[str, ...]] = {  # that an Italian procedure checks, of those its options ask for
    "dmi2008-linear": linear.STATES,
    "dmi2008-nonlinear": nonlinear.STATES,
    "dmi2008-history": dmi2008_history.STATES,
    "ntc2018-linear": ntc2018_linear.STATES,
    "ntc2018-nonlinear": ntc2018_nonlinear.STATES,
    "ntc2018-history": ntc2018_history.STATES,
}


def history_rules(options: CodeOptions) -> dict[str, tuple[Rule, ItalianOptions]]:
    """Return the Italian procedures that need suites of time histories at a PGA of their own, with their options."""
    return {
        dmi2008_history.RULE.procedure: (dmi2008_history.RULE, options.dmi2008),
        ntc2018_history.RULE.procedure: (ntc2018_history.RULE, options.ntc2018),
    }


def procedure(name: str, options: CodeOptions) -> Assess:
    """Return a procedure with its code's options.

    Parameters
    ----------
    name : one of `PROCEDURES`
    options : of every code

    Returns
    -------
    callable
        Takes an oscillator and a context, returns checks.

    Raises
    ------
    ProcedureError
        For an unknown name; it lists the known ones.
    """
    if name not in PROCEDURES:
        raise ProcedureError(f'procedure "{name}" is not known; known are: {", ".join(PROCEDURES)}')
    return PROCEDURES[name](options)
