"""ISO 10303-21 exchange files, the text format that STEP and IFC share."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

END = b"END-ISO-10303-21;"
NUMBERED = re.compile(rb"^[ \t]*#(\d+)\s*=", re.MULTILINE)


def refuse_damaged(file: Path) -> None:
    """Raise where an exchange file lacks its end, or numbers two of its entities alike.

    Readers would take a truncated file as complete, and one of the two entities at random.

    Raises
    ------
    ValueError : its last keyword is missing, or a number is used twice
    """
    content = file.read_bytes()
    if END not in content[-1000:].replace(b" ", b""):
        raise ValueError("it does not end as it must, is it whole?")
    numbers = NUMBERED.findall(content)
    if len(set(numbers)) < len(numbers):
        number = Counter(numbers).most_common(1)[0][0].decode()
        raise ValueError(f"#{number} is defined twice in it; it is damaged, export it again")
