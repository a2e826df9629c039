"""What the keys of a table mean: the sentence below each in its class."""

from __future__ import annotations

import ast
import inspect
from functools import cache
from itertools import pairwise
from textwrap import dedent


@cache
def descriptions(table: type) -> dict[str, str]:
    """Return the sentence below each attribute that the class `table` itself declares.

    It is read from the source when needed; pydantic would read it at every import (0.1 s).
    """
    found = {}
    (body,) = ast.parse(dedent(inspect.getsource(table))).body
    assert isinstance(body, ast.ClassDef)
    for attribute, below in pairwise(body.body):
        match attribute, below:
            case ast.AnnAssign(target=ast.Name(name)), ast.Expr(value=ast.Constant(value=str(sentence))):
                found[name] = inspect.cleandoc(sentence)
    return found
