"""`assess schema`: the JSON Schema of the project file."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated

import typer


def schema(
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Write the schema to a file; an earlier one is replaced."),
    ] = None,
) -> None:
    """Print the JSON Schema of the project file, or write it to a file.

    Editors with TOML support check and complete a project file by it, units of quantities included. They find it by the
    first line of the project file, `#:schema ./project.schema.json`; `assess new` writes both.
    """
    from assess.project.schema import schema_text

    if output is None:
        print(schema_text(), end="")
        return
    from assess.outputs.single import replace_file

    with replace_file(output, command="assess schema", is_replaceable=_is_schema) as made:
        made.write_text(schema_text(), encoding="utf-8", newline="\n")
    print(output)


def _is_schema(path: Path) -> bool:
    """Whether a file is a schema that this command wrote."""
    from assess.project.schema import TITLE

    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(content, dict) and content.get("title") == TITLE
