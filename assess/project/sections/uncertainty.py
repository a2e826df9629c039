"""The table [analysis.uncertainty]: how often the project is assessed with other values of its uncertain numbers."""

from __future__ import annotations

from typing import Annotated

from pydantic import AfterValidator, Field, StrictInt

from assess.project.quantities import Ratio
from assess.project.section import Section

FEWEST, MOST = 16, 65536  # samples


def _power_of_two(number: int) -> int:
    if number & (number - 1):
        below = 1 << (number.bit_length() - 1)
        raise ValueError(f"not a power of two, which Sobol's sequences need; write {below} or {2 * below}")
    return number


class Uncertainty(Section):
    """How the answers spread when the numbers given as { mean, cov } vary together; a table, empty for the defaults."""

    samples: Annotated[StrictInt, Field(ge=FEWEST, le=MOST), AfterValidator(_power_of_two)] = 128
    """values of each number, a power of two"""
    seed: Annotated[StrictInt, Field(ge=0, lt=2**32)] = 1
    """of the scrambled Sobol sequence"""
    thickness: Annotated[Ratio, Field(gt=0, lt=1)] | None = None
    """coefficient of variation of the size of all blocks along their direction, like 0.05, lognormal: of bodies whose
    thickness is no number of this file, as meshes"""
