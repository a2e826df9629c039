"""`python -m tools.same BASE`: that every number, name, outcome, order and key is what it was at BASE.

The projects are the shipped examples and all that the tests open; they are collected once, into build/same/projects or
the folder given with --corpus. Each is run by the program at BASE and by the one that stands here. Compared is what
`run`, `check`, `parameters`, `spectrum`, `fragility`, `report` (pages and tables, of a part of the projects), `batch`
and `schema` give. Texts for people may differ, and are listed.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tarfile
from pathlib import Path

from tools.same.compare import compare

ROOT = Path(__file__).parents[2]
TESTED = ("tests/unit/assess", "tests/end_to_end", "tests/properties")


def collect(projects: Path) -> None:
    """Keep the examples and every project that the tests open."""
    for example in sorted((ROOT / "assess/examples/projects").iterdir()):
        if example.is_dir():
            made = projects / f"example-{example.name}"
            python("-m", "assess", "new", str(made), "--example", example.name, tree=ROOT)
            (made / ".project").write_text("project.toml")
    kept = ("-p", "keep_projects", "--keep-projects", str(projects))
    python("-m", "pytest", "-q", *kept, *TESTED, tree=ROOT, check=False)


def unpack(commit: str, tree: Path) -> None:
    """Lay the files of a commit into the folder `tree`."""
    tree.mkdir(parents=True)
    archive = tree.with_suffix(".tar")
    subprocess.run(["git", "archive", "--output", str(archive), commit], cwd=ROOT, check=True)
    with tarfile.open(archive) as files:
        files.extractall(tree, filter="data")
    archive.unlink()


def python(*arguments: str, tree: Path, check: bool = True) -> None:
    """Run Python with the program of a tree."""
    path = os.pathsep.join([str(tree), str(ROOT / "tools/same")])
    subprocess.run([sys.executable, *arguments], cwd=tree, env={**os.environ, "PYTHONPATH": path}, check=check)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tools.same", description=__doc__)
    parser.add_argument("base", help="a commit, whose program is run beside this one")
    parser.add_argument("--folder", type=Path, default=ROOT / "build/same")
    parser.add_argument("--corpus", type=Path, help="a folder of projects collected before (default: FOLDER/projects)")
    asked = parser.parse_args()
    commit = subprocess.check_output(["git", "rev-parse", "--short", asked.base], cwd=ROOT, text=True).strip()
    folder: Path = asked.folder.absolute()
    projects, tree = (asked.corpus or folder / "projects").absolute(), folder / f"tree-{commit}"
    if not projects.exists():
        collect(projects)
    if not tree.exists():
        unpack(commit, tree)
    for source, results in ((tree, folder / commit), (ROOT, folder / "here")):
        if source == ROOT:
            for old in results.glob("*.json"):
                old.unlink()
        python(str(ROOT / "tools/same/run_projects.py"), str(projects), str(results), tree=source)
    return compare(folder / commit, folder / "here")


if __name__ == "__main__":
    sys.exit(main())
