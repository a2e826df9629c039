"""What the formulas of calculation sheets come to: a small parser of their notation, written apart from the program.

Products stand side by side or have a dot, and are worked from left to right with quotients: a / b c is (a / b) c. Only
what is written without a space binds tighter: 2π, 4π², 2α.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence

PART = r"(?:[^\W²³⁴]|[*'′₀-₉])"
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[+-]?\d+)?")
POWERS = {"²": 2.0, "³": 3.0, "⁴": 4.0}
FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "max": max,
    "min": min,
    "ln": math.log,
    "exp": math.exp,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "arctan": math.atan,
    "|": abs,
}
CONSTANTS = {"π": math.pi, "g": 9.80665}
Token = tuple[str, float | str, bool]  # kind, what, whether a space stands before it


class NoFormulaError(ValueError):
    """The text is no formula of these symbols."""


def evaluate(formula: str, given: Mapping[str, float]) -> float:
    """What `formula` comes to with the values `given`; raises NoFormulaError for words in it."""
    parser = Parser(tokens_of(formula, {**CONSTANTS, **given}))
    value = parser.sum()
    if parser.peek() is not None:
        raise NoFormulaError(f"{formula}: {parser.peek()} is left over")
    return value


def tokens_of(formula: str, known: Mapping[str, float]) -> list[Token]:
    """The formula in pieces; the longest symbol that stands there counts."""
    names = sorted(known, key=len, reverse=True)
    found: list[Token] = []
    at = 0
    while at < len(formula):
        if formula[at].isspace():
            at += 1
            continue
        spaced = at > 0 and formula[at - 1].isspace()
        kind, what, length = _piece(formula, at, names, known)
        found.append((kind, what, spaced))
        at += length
    return found


def _piece(formula: str, at: int, names: Sequence[str], known: Mapping[str, float]) -> tuple[str, float | str, int]:
    for name in names:
        ends = formula.startswith(name, at) and not re.match(PART, formula[at + len(name) : at + len(name) + 1])
        if ends and not (at and re.match(r"[^\W\d]|_", formula[at - 1])):
            return "value", known[name], len(name)
    if number := NUMBER.match(formula, at):
        return "value", float(number[0]), len(number[0])
    for name in FUNCTIONS:
        if name.isalpha() and formula.startswith(name, at):
            return "function", name, len(name)
    if formula[at] in "+−-·/()√^,|²³⁴":
        return "sign", "−" if formula[at] == "-" else formula[at], 1
    raise NoFormulaError(f"{formula}: {formula[at:]!r} is no symbol of it")


class Parser:
    """Sums of products of powers."""

    def __init__(self, tokens: list[Token]) -> None:
        self.tokens, self.at = tokens, 0

    def peek(self) -> float | str | None:
        """The next piece; a value stands as "value"."""
        if self.at == len(self.tokens):
            return None
        kind, what, _ = self.tokens[self.at]
        return kind if kind != "sign" else what

    def take(self, sign: str) -> None:
        """Pass over a sign that must be there."""
        if self.peek() != sign:
            raise NoFormulaError(f"{sign} is missing before {self.peek()}")
        self.at += 1

    def sum(self) -> float:
        """Products with signs between."""
        value = self.product()
        while self.peek() in ("+", "−"):
            sign = 1.0 if self.peek() == "+" else -1.0
            self.at += 1
            value += sign * self.product()
        return value

    def product(self) -> float:
        """Powers side by side, or with · or / between, from left to right."""
        value = self.power()
        while self.peek() in ("·", "/", "value", "function", "(", "√"):
            sign = self.peek()
            if sign in ("·", "/"):
                self.at += 1
            other = self.power()
            value = value / other if sign == "/" else value * other
        return value

    def power(self) -> float:
        """A value with its exponent, and what stands at it without a space."""
        if self.peek() == "−":
            self.at += 1
            return -self.power()
        value = self.atom()
        if self.peek() in POWERS:
            value **= POWERS[str(self.peek())]
            self.at += 1
        elif self.peek() == "^":
            self.at += 1
            value **= self.power()
        if self.peek() == "value" and not self.tokens[self.at][2]:
            value *= self.power()
        return value

    def atom(self) -> float:
        """A number, a symbol, a root, a function, or a sum in brackets."""
        sign, (_, what, _) = self.peek(), self.tokens[min(self.at, len(self.tokens) - 1)]
        self.at += 1
        if sign == "value":
            return float(what)
        if sign == "√":
            return math.sqrt(self.atom())
        if sign == "(":
            return self.closed(")")
        if sign == "|":
            return abs(self.closed("|"))
        if sign == "function":
            self.take("(")
            return FUNCTIONS[str(what)](*self.arguments())
        raise NoFormulaError(f"a value is missing before {sign}")

    def closed(self, sign: str) -> float:
        """A sum up to the sign that closes it."""
        value = self.sum()
        self.take(sign)
        return value

    def arguments(self) -> list[float]:
        """Sums with commas between, up to the bracket that closes them."""
        found = [self.sum()]
        while self.peek() == ",":
            self.at += 1
            found.append(self.sum())
        self.take(")")
        return found
