"""The page in the browser for tests: opened on a project, and set as a browser sets it."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from assess.page.page import Page, open_page


@contextmanager
def page_of(folder: Path, text: str, *, patience: float) -> Iterator[Page]:
    """Open the page of a project of this text, and wait until it has found what it shows [s]."""
    (folder / "project.toml").write_text(text, encoding="utf-8")
    with open_page(folder) as found:
        assert found.wait(patience)
        yield found


def by_hand(handle: Any, value: object) -> None:
    """Set a value as a browser does."""
    handle.value = value
    for callback in handle._impl.update_cb:
        callback(SimpleNamespace(client_id=0, client=None, target=handle))
