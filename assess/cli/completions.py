"""Values that the shell completes; what lists them is imported only when the shell asks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

Completion = Callable[[str], Sequence[str]]


def of_words(*words: str) -> Completion:
    """Return the completion of an option that takes one of these words."""

    def complete(incomplete: str) -> Sequence[str]:
        return [word for word in words if word.startswith(incomplete)]

    return complete


def examples(incomplete: str) -> Sequence[str]:
    """Complete the name of an example, by the folders that are shipped."""
    folders = (Path(__file__).parents[1] / "examples" / "projects").iterdir()
    return sorted(each.name for each in folders if each.is_dir() and each.name.startswith(incomplete))


def spectrum_codes(incomplete: str) -> Sequence[str]:
    """Complete the name of a design spectrum."""
    from spectra.registry import SPECTRA

    return [name for name in SPECTRA if name.startswith(incomplete)]


def acceleration_units(incomplete: str) -> Sequence[str]:
    """Complete a unit of acceleration."""
    from spectra.columns import ACCELERATION_UNITS

    return [unit for unit in ACCELERATION_UNITS if unit.startswith(incomplete)]


def export_formats(incomplete: str) -> Sequence[str]:
    """Complete the last of the formats of an export, which stand between commas."""
    from assess.cli.fragility import FORMATS

    before, comma, last = incomplete.rpartition(",")
    return [f"{before}{comma}{name}" for name in FORMATS if name.startswith(last) and name not in before.split(",")]


def solved_cases(incomplete: str) -> Sequence[str]:
    """Complete the key of a solved case, or of all cases of one source."""
    from assess.results.solved_cases import exercised_by_case

    keys = set(exercised_by_case())
    return [key for key in sorted(keys | {key.partition("/")[0] for key in keys}) if key.startswith(incomplete)]
