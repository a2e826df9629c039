"""`assess schema`: the JSON Schema of the project file."""

from __future__ import annotations


def schema() -> None:
    """Print the JSON Schema of the project file.

    An editor with TOML support checks and completes a project file with it.
    """
    import json

    from assess.project.schema import json_schema

    print(json.dumps(json_schema(), indent=2, ensure_ascii=False))
