"""ISO 10303-21 exchange files, the text format that STEP and IFC share."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

END = b"END-ISO-10303-21;"
NUMBERED = re.compile(rb"^[ \t]*#(\d+)\s*=", re.MULTILINE)

NAMELESS = re.compile(rb"^[ \t]*#(\d+)\s*=\s*(?:\(\s*[^A-Z!\s/(]|\(\s*\()", re.MULTILINE | re.IGNORECASE)


def refuse_damaged(file: Path) -> None:
    """Raise where an exchange file lacks its end, has an entity without a name, or numbers two alike.

    Readers would take a truncated file as complete, one of the two entities at random, and crash on one without a name.

    Raises
    ------
    ValueError : its last keyword is missing, or a number is used twice or for no entity
    """
    content = file.read_bytes()
    if END not in content[-1000:].replace(b" ", b""):
        raise ValueError("it does not end as it must, is it whole?")
    if nameless := NAMELESS.search(content):
        raise ValueError(f"#{nameless[1].decode()} has no name of an entity in it; it is damaged, export it again")
    numbers = NUMBERED.findall(content)
    if len(set(numbers)) < len(numbers):
        number = Counter(numbers).most_common(1)[0][0].decode()
        raise ValueError(f"#{number} is defined twice in it; it is damaged, export it again")
