"""The procedures by name. An unknown name raises and lists the known ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from assess.codes import asce41_13, asce43_05, asce43_05_sliding, dmi2008, en1998_1, nzsee2017, sliding
from assess.codes import dmi2008 as dmi2008_history
from assess.codes import ntc2018 as ntc2018_history
from assess.codes import ntc2018 as ntc2018_linear
from assess.codes import ntc2018 as ntc2018_nonlinear
from assess.codes.asce41_13 import Asce41Options
from assess.codes.asce43_05 import Asce43Options
from assess.codes.check import Check
from assess.codes.context import Context
from assess.codes.en1998_1 import Ec8Options
from assess.codes.italian_histories import HistoryRule
from assess.codes.italian_limit_states import ItalianOptions
from assess.codes.nzsee2017 import Nzsee2017Options
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
    "asce43-05-spectrum": lambda options: partial(asce43_05.assess_spectrum, options=options.asce43_05),
    "asce43-05-spectrum-thesis": lambda options: partial(asce43_05.assess_spectrum_thesis, options=options.asce43_05),
    "asce43-05-history": lambda options: partial(asce43_05.assess_history, options=options.asce43_05),
    "dmi2008-linear": lambda options: partial(dmi2008.assess_linear, options=options.dmi2008),
    "dmi2008-nonlinear": lambda options: partial(dmi2008.assess_nonlinear, options=options.dmi2008),
    "dmi2008-nonlinear-thesis": lambda options: partial(dmi2008.assess_nonlinear_thesis, options=options.dmi2008),
    "nzsee2017-face-loaded": lambda options: partial(nzsee2017.assess_face_loaded, options=options.nzsee2017),
    "asce41-13-ht": lambda options: partial(asce41_13.assess_slenderness, options=options.asce41_13),
    "ec8-element": lambda options: partial(en1998_1.assess_element, options=options.ec8),
    "dmi2008-history": lambda options: partial(dmi2008_history.assess_history, options=options.dmi2008),
    "ntc2018-linear": lambda options: partial(ntc2018_linear.assess_linear, options=options.ntc2018),
    "ntc2018-nonlinear": lambda options: partial(ntc2018_nonlinear.assess_nonlinear, options=options.ntc2018),
    "ntc2018-history": lambda options: partial(ntc2018_history.assess_history, options=options.ntc2018),
    "asce43-05-sliding": lambda options: partial(asce43_05_sliding.assess_sliding, options=options.asce43_05),
    "sliding": lambda options: sliding.assess_sliding,
}

LIMIT_STATES: dict[str, tuple[str, ...]] = {  # that an Italian procedure checks, of those its options ask for
    "dmi2008-linear": dmi2008.LINEAR_STATES,
    "dmi2008-nonlinear": dmi2008.NONLINEAR_STATES,
    "dmi2008-history": dmi2008_history.HISTORY_STATES,
    "ntc2018-linear": ntc2018_linear.LINEAR_STATES,
    "ntc2018-nonlinear": ntc2018_nonlinear.NONLINEAR_STATES,
    "ntc2018-history": ntc2018_history.HISTORY_STATES,
}


def history_rules(options: CodeOptions) -> dict[str, tuple[HistoryRule, ItalianOptions]]:
    """Return the Italian procedures that need suites of time histories at a PGA of their own, with their options."""
    return {
        dmi2008_history.HISTORY_RULE.procedure: (dmi2008_history.HISTORY_RULE, options.dmi2008),
        ntc2018_history.HISTORY_RULE.procedure: (ntc2018_history.HISTORY_RULE, options.ntc2018),
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
