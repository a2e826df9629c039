"""A site typed as options of a command instead of a project file; the keys and their meaning are the same."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from assess.errors import ProjectError
from assess.messages.message import Message
from assess.project.bare_numbers import bare_number_messages
from assess.project.key_text import error_line
from assess.project.sections.site import Site

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?")


def read_site_options(options: Mapping[str, str], *, folder: Path) -> Site:
    """Read a site from options of the command line, with the keys of [site.spectrum] and `pga`.

    Parameters
    ----------
    options : text of each option, by key
    folder : paths are relative to it

    Raises
    ------
    ProjectError : a project file would be refused for it; one line that names the option
    """
    raw = _table(options)
    try:
        return Site.model_validate(raw, context={"folder": folder})
    except ValidationError as error:
        raise ProjectError(_as_option(error_line(error, raw=raw))) from None


def site_option_messages(options: Mapping[str, str]) -> tuple[Message, ...]:
    """Warn of accelerations written without a unit that look as if g had been meant."""
    found = bare_number_messages({"site": _table(options)})
    return tuple(replace(each, where=_as_option(each.where.removeprefix("site."))) for each in found)


def _table(options: Mapping[str, str]) -> dict[str, Any]:
    """Return the options as the table [site] of a project file."""
    table = {key: value if key == "file" else _value(value) for key, value in options.items() if key != "pga"}
    raw: dict[str, Any] = {"spectrum": table}
    if "pga" in options:
        raw["pga"] = _value(options["pga"])
    return raw


def _value(text: str) -> float | int | str:
    """Return a number if the text is one, as TOML would have it without quotes, else the text."""
    if NUMBER.fullmatch(text) is None:
        return text
    return int(text) if re.fullmatch(r"[+-]?\d+", text) else float(text)


def _as_option(line: str) -> str:
    """Write the key in front of an error as the option."""
    return re.sub(r"^(?:spectrum\.)?(\w+)", lambda found: f"--{found[1].replace('_', '-')}", line)
