"""Ask the program found on PYTHONPATH for all it prints and writes of many projects: run_projects.py CORPUS TARGET.

Writes for each project of CORPUS the file TARGET/NAME.json: for each command how it ended (`code`), what it said
(`told`) and its answer: results.json of `run`, what `check`, `parameters`, `spectrum` and `fragility` print and, of the
examples and of one project in EVERY, the texts of the report's pages and all CSV tables. TARGET/_program.json has what
belongs to no project: the schema, its references resolved, and the rows of a batch.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any

EVERY = 12
"""One project in so many has its report written, which takes longer than all else of a small one."""
OWN_DIGEST = re.compile(r"\b[0-9a-f]{12,64}\b")
"""Digests in the report's text: that of the program's own sources changes with every line of them."""


def command(*arguments: str, scratch: Path) -> dict[str, Any]:
    """Run one command of the program in this process; its texts name no folder of this run."""
    from typer.testing import CliRunner

    from assess.cli.app import app
    from assess.errors import AssessError

    ended = CliRunner().invoke(app, list(arguments))
    error = ended.exception
    told = str(error) if isinstance(error, AssessError) else repr(error) if ended.exit_code == 1 and error else ""
    return {
        "code": type(error).__name__ if told else ended.exit_code,
        "told": told.replace(str(scratch), ""),
        "lines": printed(ended.stdout.replace(str(scratch), "")),
    }


def printed(text: str) -> Any:
    """What a command printed: JSON where it is, else its lines."""
    try:
        return json.loads(text)
    except ValueError:
        return text.splitlines()


def run_project(job: tuple[Path, Path]) -> None:
    """Ask all there is to ask of one project, and write the answers."""
    folder, kept = job
    with tempfile.TemporaryDirectory(prefix="same-") as name:
        scratch = Path(name)
        project, results = scratch / "project", scratch / "out"
        shutil.copytree(folder, project)
        file = project / (folder / ".project").read_text()
        answer = command("run", str(file), "-o", str(results), "--no-report", "--jobs", "1", scratch=scratch)
        del answer["lines"]
        made = results / "results.json"
        answer["results"] = json.loads(made.read_text().replace(name, "")) if made.is_file() else None
        answer["check"] = command("check", str(file), scratch=scratch)
        for asked in asked_of(file):
            answer[asked] = command(asked, str(file), "--json", scratch=scratch)
        if made.is_file() and (folder.name.startswith("example-") or by_digest(folder.name) % EVERY == 0):
            answer["report"] = report(made, scratch)
    kept.write_text(json.dumps(answer))


def asked_of(file: Path) -> Iterator[str]:
    """The commands that print JSON of this project."""
    yield from ("parameters", "spectrum")
    try:
        if "fragility" in tomllib.loads(file.read_text(encoding="utf-8")).get("analysis", {}):
            yield "fragility"
    except (OSError, ValueError, AttributeError):
        return


def report(made: Path, scratch: Path) -> dict[str, Any]:
    """The texts of a report's pages, and its tables as CSV."""
    from pypdf import PdfReader

    folder = scratch / "report"
    ended = command("report", str(made), "-o", str(folder), "--detail", "full", scratch=scratch)
    pages = [page.extract_text() for page in PdfReader(folder / "report.pdf").pages] if ended["code"] == 0 else []
    return {
        "code": ended["code"],
        "told": ended["told"],
        "pages": [OWN_DIGEST.sub("#", page.replace(str(scratch), "")).splitlines() for page in pages],
        "tables": {
            path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8").replace(str(scratch), "").splitlines()
            for path in sorted(folder.rglob("*.csv"))
        },
    }


def by_digest(name: str) -> int:
    """A number that stands for a name, the same in every process."""
    return int(hashlib.sha256(name.encode()).hexdigest()[:8], 16)


def program(corpus: Path) -> dict[str, Any]:
    """What belongs to no project: the schema, and the rows of a batch over the shipped street."""
    with tempfile.TemporaryDirectory(prefix="same-") as name:
        scratch = Path(name)
        schema = command("schema", scratch=scratch)["lines"]
        shutil.copytree(corpus / "example-street", scratch / "street")
        table = next((scratch / "street").glob("*.csv"))
        template = scratch / "street" / "template.toml"
        batch = ("batch", str(table), "--template", str(template), "-o", str(scratch / "out"))
        ended = command(*batch, scratch=scratch)
        rows = {path.name: path.read_text().splitlines() for path in sorted((scratch / "out").glob("*.csv"))}
    return {"schema": resolved(schema, schema.get("$defs", {})), "batch": {"code": ended["code"], "rows": rows}}


def resolved(part: Any, definitions: dict[str, Any], within: tuple[str, ...] = ()) -> Any:
    """A schema with what its references name in their place; one that holds itself is named by its depth."""
    if isinstance(part, list):
        return [resolved(each, definitions, within) for each in part]
    if not isinstance(part, dict):
        return part
    if "$ref" in part:
        name = str(part["$ref"]).rpartition("/")[2]
        rest = {key: value for key, value in part.items() if key != "$ref"}
        if name in within:
            return {"holds itself": len(within) - within.index(name), **rest}
        whole = resolved(definitions[name], definitions, (*within, name))
        return {**whole, **resolved(rest, definitions, within)}
    mapping = part.get("discriminator", {}).get("mapping")
    kept = {key: value for key, value in part.items() if key != "$defs"}
    if mapping is not None:
        kept["discriminator"] = {**part["discriminator"], "mapping": sorted(mapping)}
    return {
        key: value if key == "discriminator" else resolved(value, definitions, within) for key, value in kept.items()
    }


def main(corpus: Path, target: Path) -> None:
    """Ask every project of the corpus that has not been asked yet, two at a time."""
    target.mkdir(parents=True, exist_ok=True)
    jobs = [(folder, target / f"{folder.name}.json") for folder in sorted(corpus.iterdir())]
    jobs = [(folder, kept) for folder, kept in jobs if not kept.exists()]
    with ProcessPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        for done, ended in enumerate(as_completed([pool.submit(run_project, job) for job in jobs]), start=1):
            ended.result()
            sys.stderr.write(f"\r{done} of {len(jobs)} projects")
    sys.stderr.write("\n")
    if not (target / "_program.json").exists():
        (target / "_program.json").write_text(json.dumps(program(corpus)))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
