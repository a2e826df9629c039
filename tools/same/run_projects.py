"""Run `assess run --no-report` on many projects with the program found on PYTHONPATH: run_projects.py CORPUS TARGET.

Writes for each project of CORPUS the file TARGET/NAME.json: `code` (how the command ended), `told` (standard error)
and `results` (the text of results.json; null where there is none).
"""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
from multiprocessing import Pool
from pathlib import Path


def run_project(job: tuple[Path, Path]) -> None:
    """Run one project, a folder or an example named `example-NAME`, and write how it ended."""
    from typer.testing import CliRunner

    from assess.cli.app import app
    from assess.errors import AssessError

    folder, kept = job
    with tempfile.TemporaryDirectory(prefix="same-") as scratch:
        project, results = Path(scratch) / "project", Path(scratch) / "out"
        shutil.copytree(folder, project)
        file = project / (folder / ".project").read_text()
        ended = CliRunner().invoke(app, ["run", str(file), "-o", str(results), "--no-report", "--jobs", "1"])
        error = ended.exception
        told = str(error) if isinstance(error, AssessError) else repr(error) if ended.exit_code == 1 and error else ""
        made = results / "results.json"
        answer = {
            "code": type(error).__name__ if told else ended.exit_code,
            "told": told.replace(scratch, ""),
            "results": json.loads(made.read_text().replace(scratch, "")) if made.is_file() else None,
        }
    kept.write_text(json.dumps(answer))


def main(corpus: Path, target: Path) -> None:
    """Run every project of the corpus that has not been run yet, two at a time."""
    target.mkdir(parents=True, exist_ok=True)
    jobs = [(folder, target / f"{folder.name}.json") for folder in sorted(corpus.iterdir())]
    jobs = [(folder, kept) for folder, kept in jobs if not kept.exists()]
    with Pool(2, maxtasksperchild=200) as pool:
        for done, _ in enumerate(pool.imap_unordered(run_project, jobs), start=1):
            sys.stderr.write(f"\r{done} of {len(jobs)} projects")
    sys.stderr.write("\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
