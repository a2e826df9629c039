"""The mechanism that a key of the project file belongs to, of names that may begin alike."""

from __future__ import annotations

from assess.results import Results

START = "mechanisms."


def split_key(results: Results, key: str) -> tuple[str, str]:
    """Return the mechanism that a key belongs to and its key in there; empty and the whole key for no one's."""
    rest = key.removeprefix(START) if key.startswith(START) else ""
    names = [each.name for each in results.mechanisms]
    found = [name for name in names if rest == name or rest.startswith((f"{name}.", f"{name}["))]
    owner = max(found, key=len, default="")
    return (owner, rest.removeprefix(owner).removeprefix(".")) if owner else ("", key)


def starred_key(results: Results, key: str) -> tuple[str, str]:
    """Return the mechanism that a key belongs to, and the key with * in its place; empty and the key for no one's."""
    owner, rest = split_key(results, key)
    return (owner, f"{START}*.{rest}".removesuffix(".")) if owner else ("", key)
