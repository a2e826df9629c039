"""Formulas of calculation sheets, worked out from their inputs."""

from __future__ import annotations

import math
import re

from scipy.constants import g

from assess.codes.step import Step

WORDS = {"sqrt": math.sqrt, "max": max, "min": min, "g": g, "pi": math.pi}


def value_of(step: Step) -> float | None:
    """What the formula of a step gives with its inputs; None where it has no input to put in."""
    values = {each.symbol: each.value for each in step.inputs} | {"π": math.pi, "g": g}
    absent = [each.symbol for each in step.inputs if _pattern([each.symbol]).search(step.formula) is None]
    if not step.inputs or absent:
        return None
    text = _pattern(list(values)).sub(lambda found: f"({values[found[0]]!r})", step.formula)
    for sign, word in {"·": "*", "−": "-", "²": "**2", "^": "**", "√": "sqrt"}.items():
        text = text.replace(sign, word)
    return float(eval(text, {"__builtins__": {}}, WORDS))


def _pattern(symbols: list[str]) -> re.Pattern[str]:
    part = r"[\w*'′₀-₉]"
    longest = "|".join(map(re.escape, sorted(symbols, key=len, reverse=True)))
    return re.compile(rf"(?<!{part})({longest})(?!{part})")
