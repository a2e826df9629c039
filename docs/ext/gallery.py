"""The gallery: a page for each solved case, run and drawn when the manual is built, into docs/made.

No commit holds these pages. What was run is kept in build/docs/cases under the hash of the case and of the program with
its data, so that it runs again only where one of them has changed.
"""

from __future__ import annotations

import hashlib
from functools import cache
from itertools import groupby
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from assess.results.provenance import sources_digest
from assess.results.verification import CaseResult
from assess.verification.case_files import CaseFile, read_cases
from assess.verification.verify import compare_case, solve_case
from assess.workers import process_pool
from docs.ext.case_figures import (
    draw_agreement,
    draw_mechanisms,
    draw_project,
    is_half,
    project_results,
    tree_mechanisms,
)
from docs.ext.case_pages import Shown, case_page
from docs.ext.markdown import cell, escape
from reports.render.vector import write_figure

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "build" / "docs" / "cases"
MADE = "made"
FOLDER = "gallery"
ROW = "row.txt"
COLUMNS = "| | case | values | largest difference / tolerance | |\n|---|---|--:|--:|---|"


def setup(app: Any) -> dict[str, bool]:
    """Make the pages before Sphinx looks for them."""
    app.connect("builder-inited", lambda app: write_pages(Path(app.srcdir) / MADE))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def write_pages(folder: Path) -> None:
    """Write the pages that have changed, so that a second build reads only these, and remove those of earlier ones."""
    made = {folder / name: text for name, text in pages().items()}
    for path, text in made.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
    for old in {path for path in folder.rglob("*.*") if path.is_file()} - set(made):
        old.unlink()


def pages() -> dict[str, str]:
    """Return each page and figure by its name, and `gallery/table.txt`, the list of all."""
    files = read_cases()
    with process_pool(None) as pool:
        kept = list(pool.map(keep_case, files) if pool is not None else map(keep_case, files))
    found = {f"{FOLDER}/table.txt": _table(files, kept)}
    for folder in kept:
        for path in sorted(folder.iterdir()):
            if path.name != ROW:
                found[f"{FOLDER}/{path.name}"] = path.read_text(encoding="utf-8")
    return found


def page_name(file: CaseFile) -> str:
    """Return the name of a case's page, which its figures begin with."""
    return file.key.replace("/", "-")


def keep_case(file: CaseFile) -> Path:
    """Run and draw a case, unless that has been done before; return the folder of its page and figures."""
    folder = KEPT / page_name(file) / _hash(file)
    if not (folder / ROW).exists():
        folder.mkdir(parents=True, exist_ok=True)
        _write_case(file, folder)
    return folder


def _write_case(file: CaseFile, folder: Path) -> None:
    tree = solve_case(file)
    result, name = compare_case(file, tree), page_name(file)
    figures = [("agreement", "Values of this case beside those of its source", draw_agreement(result))]
    results = project_results(tree)
    drawn = draw_mechanisms(tree_mechanisms(tree)) if results is None else draw_project(results)
    figures = [*drawn, *figures]
    for key, _, figure in figures:
        write_figure(figure, folder / f"{name}-{key}.svg", creator="assess")
    shown = [Shown(f"{name}-{key}.svg", caption, half=is_half(figure)) for key, caption, figure in figures]
    (folder / f"{name}.md").write_text(case_page(file, result, shown), encoding="utf-8")
    (folder / ROW).write_text(_row(name, result, f"{name}-{_for_the_list(figures)}.svg"), encoding="utf-8")


def _for_the_list(figures: list[tuple[str, str, Figure]]) -> str:
    """Return the figure that stands for a case in the list: a mechanism if one is drawn."""
    names = [key for key, _, _ in figures]
    return next((key for key in ("view", "sketch", "sketch-0") if key in names), names[0])


def _row(name: str, result: CaseResult, picture: str) -> str:
    """Return the case as a row of the list, for a page of docs/gallery."""
    page = f"../made/{FOLDER}/{name}.md"
    largest = f"{max(result.shares):.2f}" if result.shares else "–"
    return (
        f"| ![](../made/{FOLDER}/{picture}){{width=120px}} | [{cell(escape(result.title))}]({page}) "
        f"| {len(result.values)} | {largest} | {result.source.standing}, {result.outcome} |"
    )


def _table(files: tuple[CaseFile, ...], kept: list[Path]) -> str:
    """Return the list of all cases as Markdown, a heading for each source."""
    lines: list[str] = []
    both = zip(files, kept, strict=True)
    for citation, group in groupby(both, key=lambda each: each[0].case.source.citation):
        rows = [(folder / ROW).read_text(encoding="utf-8") for _, folder in group]
        lines += [f"## {escape(citation)}", "", COLUMNS, *rows, ""]
    return "\n".join(lines)


def _hash(file: CaseFile) -> str:
    digest = hashlib.sha256(_program().encode())
    for path in file.paths:
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


@cache
def _program() -> str:
    """Return the hash of all files of the program, with its cases and examples, and of what draws their pages."""
    digest = hashlib.sha256(sources_digest(ROOT).encode())
    for path in sorted((ROOT / "docs" / "ext").rglob("*.py")):
        digest.update(path.relative_to(ROOT).as_posix().encode() + path.read_bytes())
    return digest.hexdigest()
