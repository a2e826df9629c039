"""Interim."""
import csv
from collections.abc import Sequence
from dataclasses import astuple, fields
from pathlib import Path

from assess.portfolio.row import Row


def write_ranking(rows: Sequence[Row], folder: Path) -> None:
    """Write the rows."""
    with (folder / "ranked.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([field.name for field in fields(Row)])
        writer.writerows(astuple(row) for row in rows)
