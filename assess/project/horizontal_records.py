"""Which components of the records shake the mechanisms: the horizontal ones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assess.errors import ProjectError
from assess.messages.message import Message, note
from records.orientation import is_vertical
from records.record import Record


def horizontal_records(records: Sequence[Record]) -> tuple[Record, ...]:
    """Return the records without vertical components; raise ProjectError if there are no others."""
    kept = tuple(record for record in records if not is_vertical(record.component))
    if records and not kept:
        raise ProjectError("records.files: vertical components alone; give the files of horizontal ones")
    return kept


def vertical_record_messages(records: Sequence[Record]) -> Iterator[Message]:
    """Say which vertical components were found and are not used."""
    vertical = [record.id for record in records if is_vertical(record.component)]
    if vertical:
        yield note("vertical-left-out", "records.files", records=", ".join(vertical))
