"""What a verdict lacks: the keys with their reasons, and the lines to paste into the project file."""

from __future__ import annotations

from collections.abc import Sequence

from assess.codes.verdict import Decision, Missing, Verdict
from assess.codes.verdict_text import toml_lines
from assess.results import Results
from reports.chapters.mechanism_keys import split_key
from reports.chapters.mechanism_list import mechanism_list
from reports.document import Block, Code, Prose
from reports.language.texts import Term, Text, Verbatim, listing, say

LONGEST = 12  # lines to paste that page 1 holds


def missing_texts(results: Results, found: Verdict) -> list[Text]:
    """Return the keys that are missing and why; one that several mechanisms lack for one reason is said once."""
    groups: dict[tuple[str, str], list[Missing]] = {}
    for each in found.missing:
        _, key = split_key(results, each.key)
        groups.setdefault((key, each.text), []).append(each)
    return [_text(results, key, group) for (key, _), group in groups.items()]


def _text(results: Results, key: str, group: Sequence[Missing]) -> Text:
    first = group[0]
    why = listing(first.why or first.reasons, "") if first.why or first.reasons else Term(first.text)
    owners = [owner for owner in (split_key(results, each.key)[0] for each in group) if owner]
    if len(group) == 1 or not owners:
        return say("{key}: {why}", key=Verbatim(first.key), why=why)
    return say("{key} of {mechanisms}: {why}", key=Verbatim(key), mechanisms=mechanism_list(results, owners), why=why)


def lines_to_paste(results: Results, found: Verdict) -> tuple[str, ...]:
    """Return the missing keys as lines of a project file."""
    return toml_lines(found.missing, [key for key, each in results.project.items() if each.given])


def paste(results: Results, found: Verdict) -> list[Block]:
    """Return the lines to paste under their title; nothing where no line is known."""
    lines = lines_to_paste(results, found)
    if not lines:
        return []
    title = say("To complete the verdict, add these lines to the project file with your own values:")
    return [Prose((title,)), Code(lines)]


def fits_page_1(results: Results, found: Verdict) -> bool:
    """Return whether the lines to paste are few enough for page 1; else they stand with the recommendations."""
    return len(lines_to_paste(results, found)) <= LONGEST


def provisional(found: Verdict) -> list[Block]:
    """Return what the verdict would be with the safe values."""
    if found.provisional == Decision.PASS:
        return [Prose((say("With the safe value of all that is missing, the verdict would be: pass."),))]
    if found.provisional == Decision.FAIL:
        return [Prose((say("With the safe value of all that is missing, the verdict would be: fail."),))]
    return []
