"""The first page: the verdict, its basis, its conditions, and what is missing."""

from __future__ import annotations

from collections.abc import Iterator
from hashlib import sha256

from assess.codes.verdict import Decision, Missing, Verdict
from assess.codes.verdict_text import (
    action_text,
    building_index_text,
    outcome_text,
    relevant_warnings,
    target_text,
    toml_lines,
)
from assess.messages.plural import count_noun
from assess.results import Results
from reports.chapters import heights, mechanism_verdicts
from reports.document import Banner, Block, Code, Column, Items, Section, Table, Text, nonempty
from reports.language.lettering import truncate
from reports.language.message_text import message_text

MANY = 12  # points of a list
LOCAL = "Local mechanisms only: the index of the building is at most the smallest of theirs."
SAFE = "With all of these given, at the safe value where there is one, the verdict would be: "


def section(results: Results) -> Section:
    """Return the page: the verdict of the building and of each mechanism, with its conditions and warnings."""
    found = results.verdict
    if found is None:
        return Section("Verdict", 0, (Text(("No verdict: nothing was assessed.",)),))
    blocks: list[Block] = [
        Banner(found.outcome.value, headline(found), found.at_the_limit and found.outcome != Decision.INCOMPLETE),
        basis_table(found),
        *_bullet_list("The verdict is subject to these conditions:", [message_text(each) for each in found.conditions]),
        *_missing(found, results),
        *_bullet_list("Related warnings:", list(_relevant_warnings(results))),
        mechanism_verdicts.table(results),
        *nonempty(heights.table(results)),
    ]
    return Section("Verdict", 0, tuple(blocks))


def headline(found: Verdict) -> str:
    """Return the meaning of the verdict in one sentence."""
    every = count_noun(len(found.mechanisms), "mechanism")
    number = sum(one.outcome == found.outcome for one in found.mechanisms)
    at = f"at the site’s own action, PGA {found.action.pga_g:.3g} g"
    if found.outcome == Decision.PASS:
        return f"The one mechanism holds {at}." if number == 1 else f"All {every} hold {at}."
    if found.outcome == Decision.FAIL:
        return f"{number} of {every} {'fails' if number == 1 else 'fail'} {at}."
    if not found.basis:
        return "No deciding basis is named: the results of the procedures are for comparison only."
    have = "has" if number == 1 else "have"
    return f"{number} of {every} {have} no deciding answer {at}; without one there is no pass."


def basis_table(found: Verdict) -> Table:
    """Tabulate the basis of the verdict: code, limit states, action, methods and target."""
    index = building_index_text(found).replace("zeta_E", "ζ_E")
    rows = (
        ("Basis", f"{found.basis}: {found.edition}" if found.basis else "none named"),
        ("Statement", found.clauses[0][0] if found.basis == "own" else ""),
        ("Limit state", ", ".join(found.limit_states)),
        ("Site’s own action", action_text(found.action)),
        ("Methods that may decide", ", ".join(found.methods)),
        ("Target of the index", target_text(found)),
        ("Index of the building", index),
    )
    columns = (Column("Item"), Column("Value"))
    return Table("verdict-asked", f"Basis of the verdict. {LOCAL}", columns, tuple(row for row in rows if row[1]))


def _missing(found: Verdict, results: Results) -> list[Block]:
    """Return what would complete the verdict, as lines to paste, and what it would be with the safe values."""
    if found.outcome != Decision.INCOMPLETE or not found.missing:
        return []
    blocks = _bullet_list("Missing:", [f"{each.key}: {_missing_reason(each)}." for each in found.missing])
    if found.provisional in (Decision.PASS, Decision.FAIL):
        blocks.append(Text((f"{SAFE}{outcome_text(found.provisional, near=False)}.",)))
    given = [key for key, each in results.project.items() if each.given]
    return [
        *blocks,
        Text(("To complete it, add to the project file, with your own values:",)),
        Code(toml_lines(found.missing, given)),
    ]


def _missing_reason(missing: Missing) -> str:
    """Return why an input is needed, with the numbers of its reasons whole."""
    text = missing.text
    for reason in missing.reasons:
        text = text.replace(reason.text, message_text(reason))
    return text


def _relevant_warnings(results: Results) -> Iterator[str]:
    """Yield the warnings of the run, and the remarks of the checks that decide, each once."""
    for each in relevant_warnings(results.warnings):
        yield f"{each.where}: {message_text(each)}" if each.where else message_text(each)
    for mechanism in results.mechanisms:
        remarks = (
            message_text(each) for check in mechanism.checks if check.role == "deciding" for each in check.remarks
        )
        yield from (f"{mechanism.name}: {text}" for text in dict.fromkeys(remarks))


def _bullet_list(title: str, points: list[str]) -> list[Block]:
    """Return a list under its title; of a long one the first points, and how many there are besides."""
    if not points:
        return []
    more = [f"… and {len(points) - MANY} more."] if len(points) > MANY else []
    return [Text((title,)), Items((*(truncate(text, 400) for text in points[:MANY]), *more))]


def fingerprint(results: Results) -> str:
    """Return the number of files read and one SHA-256 over theirs, which identifies the inputs of the report."""
    joined = "".join(each.sha256 for each in results.inputs).encode("ascii", "replace")
    return f"{count_noun(len(results.inputs), 'file')}, together SHA-256 {sha256(joined).hexdigest()}"
