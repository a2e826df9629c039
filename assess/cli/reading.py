"""Results that commands read again: made good where a run was stopped, and doubted where they were changed since."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from assess.cli.warning import tell
from assess.errors import AssessError, ResultsError
from assess.messages.message import warning
from assess.outputs.manifest import is_changed
from assess.outputs.recovery import recover_for_reading
from assess.results import Results
from assess.results.json import find_results, read


@dataclass(frozen=True)
class Found:
    """Results, the file they come from, and whether the folder's manifest shows them to be as they were written."""

    results: Results
    path: Path
    as_written: bool

    @contextmanager
    def believed(self) -> Iterator[None]:
        """Blame what goes wrong in the block on the results, unless they are as the program wrote them."""
        try:
            yield
        except (AssessError, OSError):
            raise
        except Exception as error:
            if self.as_written:
                raise
            what = f"{type(error).__name__}: {error}"
            raise ResultsError(
                f"{self.path}: its parts do not fit together ({what[:200]}); run the project again"
            ) from error


def results_at(path: Path) -> Found:
    """The results that a file or folder names; results changed since they were written are told and carry a warning."""
    for folder in (path, *sorted(path.glob("*-results"))) if path.is_dir() else (path.parent,):
        recover_for_reading(folder, tell=tell)
    file = find_results(path)
    results, differs = read(file), is_changed(file)
    if differs:
        doubt = warning("results-changed", str(file))
        tell(doubt)
        results = replace(results, warnings=(replace(doubt, where=file.name), *results.warnings))
    return Found(results, file, as_written=differs is False)
