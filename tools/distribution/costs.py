"""What each dependency weighs on the disk, as a table in Markdown: `make costs`.

Sizes are those of the files that pip recorded of the packages in the environment that runs this, and of their compiled
Python files, in MB of 10^6 bytes:
a dependency alone; with all that it brings; and what would not be installed without it, nor without its dependents.
"""

from __future__ import annotations

import platform
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from importlib.metadata import PackageNotFoundError, distribution
from importlib.util import cache_from_source
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parents[2]
OWN = "rocking-assess"


@cache
def size(name: str) -> float:
    """Return the size of a package's own files, compiled ones included [MB]."""
    recorded = {Path(str(each.locate())) for each in distribution(name).files or ()}
    compiled = {Path(cache_from_source(path)) for path in recorded if path.suffix == ".py"}
    return sum(path.stat().st_size for path in recorded | compiled if path.is_file()) / 1e6


def brought(requirement: Requirement) -> frozenset[str]:
    """Return the names of all that a requirement installs here, itself included."""
    found: dict[tuple[str, str], None] = {}
    waiting = [(canonicalize_name(requirement.name), extra) for extra in ("", *requirement.extras)]
    while waiting:
        name, extra = waiting.pop()
        if (name, extra) in found or not is_installed(name):
            continue
        found[name, extra] = None
        for text in distribution(name).requires or ():
            needed = Requirement(text)
            if needed.marker is None or needed.marker.evaluate({"extra": extra}):
                waiting += [(canonicalize_name(needed.name), more) for more in ("", *needed.extras)]
    return frozenset(name for name, _ in found)


def is_installed(name: str) -> bool:
    """Return whether this environment has a package."""
    try:
        distribution(name)
    except PackageNotFoundError:
        return False
    return True


def rows(declared: Mapping[str, frozenset[str]], others: frozenset[str]) -> Iterator[tuple[str, float, float, float]]:
    """Yield name, own size, size with what it brings, and size of what only it brings, the largest first.

    others : packages that are installed in any case
    """
    for name, names in sorted(declared.items(), key=lambda item: -sum(map(size, item[1]))):
        rest = others.union(*(each for other, each in declared.items() if other != name))
        yield name, size(name), sum(map(size, names)), sum(map(size, names - rest))


def table(title: str, declared: Mapping[str, frozenset[str]], others: frozenset[str] = frozenset()) -> Iterator[str]:
    """Yield the lines of a table with the sum of a plain installation, or of what an extra adds to it."""
    yield f"| {title} | alone | with what it brings | only for it |"
    yield "|---|---:|---:|---:|"
    for name, *sizes in rows(declared, others):
        yield f"| {name} | " + " | ".join(f"{each:.1f}" for each in sizes) + " |"
    yield f"| together | | | {sum(map(size, frozenset().union(*declared.values()) - others)):.0f} |"


def main() -> None:
    """Print the tables of the plain installation and of the extras."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    plain = [Requirement(line) for line in project["dependencies"]]
    extra = [Requirement(line) for lines in project["optional-dependencies"].values() for line in lines]
    wanted = {canonicalize_name(each.name): brought(each) for each in plain}
    more = {canonicalize_name(each.name): brought(each) for each in extra if each.name != OWN}
    print(f"MB on {platform.system()} {platform.machine()}, Python {platform.python_version()}\n")
    print(*table("dependency", wanted), sep="\n", end="\n\n")
    print(*table("of an extra", more, frozenset().union(*wanted.values())), sep="\n")


if __name__ == "__main__":
    main()
