"""`assess schema`: the JSON Schema of the project file."""

from __future__ import annotations


def schema() -> None:
    """Print the JSON Schema of the project file.

    Editors with TOML support use it to check and complete a project file.
    """
    import json

    from assess.project.schema import json_schema

    print(json.dumps(json_schema(), indent=2, ensure_ascii=False))
