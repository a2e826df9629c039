"""The operator for text: what the working prints is as much a result as its numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from cosmic_ray.operators.operator import Example, Operator

MARK = "XX"
Position = tuple[tuple[int, int], tuple[int, int]]


class ReplaceText(Operator):  # type: ignore[misc]
    """Put a mark at the beginning of a literal, or of a piece of one with fields."""

    def mutation_positions(self, node: Any) -> Iterator[Position]:
        """Yield the place of a literal."""
        if node.type == "string" or (node.type == "fstring_string" and node.parent.type == "fstring"):
            yield node.start_pos, node.end_pos

    def mutate(self, node: Any, index: int) -> Any:
        """Return the literal with the mark."""
        opening = 0
        if node.type == "string":
            quote = min(node.value.find(each) for each in "\"'" if each in node.value)
            opening = quote + (3 if node.value[quote : quote + 3] == node.value[quote] * 3 else 1)
        node.value = node.value[:opening] + MARK + node.value[opening:]
        return node

    @classmethod
    def examples(cls) -> tuple[Example, ...]:
        """Return what Cosmic Ray's own tests would try."""
        return (Example("x = 'y'", "x = 'XXy'"),)
