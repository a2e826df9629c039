"""Exchange files of ISO 10303-21, the text that STEP and IFC share."""

from __future__ import annotations

from pathlib import Path

END = b"END-ISO-10303-21;"


def refuse_cut_short(file: Path) -> None:
    """Raise where an exchange file does not end as it must, because readers take what is there for the whole.

    Raises
    ------
    ValueError : its last word is missing
    """
    with file.open("rb") as content:
        content.seek(0, 2)
        content.seek(max(0, content.tell() - 1000))
        if END not in content.read().replace(b" ", b""):
            raise ValueError("it does not end as it must, is it whole?")
