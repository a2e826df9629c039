"""What `assess retrofit` prints: the target, how many layouts were examined and proved, the least, and the front."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from math import isfinite

from assess.cli.tables import messages_text, text_table
from assess.messages.message import count_noun, escape_text
from assess.results.retrofit import CONFIDENCE, Layout, Reached, RetrofitResults, Trial
from reports.render.table_text import csv_lines

MOST_SHOWN, MOST_FAILED = 12, 5
MEASURES = {
    "index": "index",
    "ratio": "largest rotation over that which overturns",
    "probability": "upper end (84 %) of the share of records that overturn",
}


def retrofit_text(results: RetrofitResults) -> str:
    """Write what was asked and found, and the Pareto front."""
    target, shown = results.target, results.best or results.nearest
    where = f", {results.limit_state}" * bool(results.limit_state)
    lines = [
        f"target: {MEASURES[target.kind]} {'>=' if target.rising else '<='} {target.reach:g}{where}, "
        f"of what the works change: {', '.join(map(escape_text, results.mechanisms))}",
        f"{count_noun(sum(each.reached is not None for each in results.layouts), 'layout')} examined"
        f"{f' on {len(results.search_records)} records' * bool(results.search_records)}, "
        f"{sum(each.refused is not None for each in results.layouts)} refused, {results.candidates} reach it; "
        f"{results.tried} put to the proof{f' on {len(results.proof_records)} others' * bool(results.proof_records)}",
    ]
    if results.confidence is not None:
        lines.append(
            f"in the proof a share counts at a confidence of {results.confidence:.4g}, so that of up to "
            f"{count_noun(results.most, 'layout')} on the same records the one that is chosen has it at {CONFIDENCE:g}"
        )
    refused = Counter(each.refused.key for each in results.layouts if each.refused is not None)
    for key, number in refused.items():
        first = next(each.refused for each in results.layouts if each.refused is not None and each.refused.key == key)
        lines.append(escape_text(f"  refused {number} x, the first as {first}"))
    if results.best is None:
        lines.append("none is proved to reach the target" + ("" if shown is None else "; the nearest:"))
    else:
        lines.append("least that is proved:")
    if shown is not None:
        pairs = zip(results.varied, shown.values, strict=True)
        lines += [escape_text(f"  {each.key} = {value:.6g} {each.unit}".rstrip()) for each, value in pairs]
        lines.append(f"  {_amount(results, shown)}; reaches {_reached(shown.reached)}{_worst(results)}")
    if results.verdict:
        index = results.building_index
        of_all = "" if index is None else f"; its index, the worst of all its mechanisms: {index:.4g}"
        lines.append(f"  verdict of the project with these works: {results.verdict}{of_all}")
    text = "".join(f"{line}\n" for line in lines)
    if results.best is None and results.failed:
        shown_of = f" (the first {MOST_FAILED} of {len(results.failed)})" * (len(results.failed) > MOST_FAILED)
        text += f"fell short, with these factors on their ties{shown_of}:\n" + text_table(
            *_failed_rows(results, results.failed[:MOST_FAILED])
        )
        refusals = dict.fromkeys(str(each.proof.refused) for each in results.failed if each.proof.refused)
        text += "".join(f"  {escape_text(why)}\n" for why in list(refusals)[:MOST_FAILED])
    if results.front:
        least = [each for place, each in enumerate(results.front) if place < MOST_SHOWN or each == results.best]
        text += "layouts for which none that takes less reaches as much (Pareto front):\n" + text_table(
            *_rows(results, least)
        )
    return text + messages_text(results.warnings)


def retrofit_csv(results: RetrofitResults) -> str:
    """Write every layout as CSV at full precision."""
    table = results.table().astype(object)
    rows = table.where(table.notna(), "").values.tolist()
    return csv_lines([list(table.columns), *rows])


def retrofit_json(results: RetrofitResults) -> str:
    """Write what was found and every layout as JSON; null for what is not known, and for a ratio beyond overturning."""
    table = results.table()
    rows = [
        {key: None if isinstance(value, float) and not isfinite(value) else value for key, value in row.items()}
        for row in table.to_dict(orient="records")
    ]
    best = None if results.best is None else rows[results.layouts.index(results.best)]
    found = {
        "target": results.target.kind,
        "reach": results.target.reach,
        "limit_state": results.limit_state,
        "proved": best is not None,
        "best": best,
        "verdict": results.verdict,
        "building_index": results.building_index,
        "currency": results.currency,
        "tried": results.tried,
        "most": results.most,
        "confidence": results.confidence,
        "candidates": results.candidates,
        "search_records": results.search_records,
        "proof_records": results.proof_records,
        "layouts": rows,
    }
    return json.dumps(found, indent=2, ensure_ascii=False) + "\n"


def _rows(results: RetrofitResults, layouts: Sequence[Layout]) -> tuple[list[str], list[list[str]]]:
    keys = [f"{each.key} [{each.unit}]" if each.unit else each.key for each in results.varied]
    cost = f"cost [{results.currency}]" if results.currency else "cost"
    header = [cost if results.priced else "steel [kg]", results.target.kind, *keys, "proof"]
    proof = ["falls short" if results.fell_short(each) else "holds" * (each == results.best) for each in layouts]
    return header, [
        [f"{each.objective:.5g}", _reached(each.reached), *(f"{value:.6g}" for value in each.values), said]
        for each, said in zip(layouts, proof, strict=True)
    ]


def _failed_rows(results: RetrofitResults, failed: Sequence[Trial]) -> tuple[list[str], list[list[str]]]:
    header, rows = _rows(results, [each.layout for each in failed])
    names = ("area", "length", "height", "yield_stress")
    return [*header[:-1], *names, "in the proof", "overturn"], [
        [
            *row[:-1],
            *(f"{getattr(each.proof.tolerance, name):g}" for name in names),
            "cannot be built" if each.proof.refused else _reached(each.proof.reached),
            str(each.proof.reached.overturned),
        ]
        for row, each in zip(rows, failed, strict=True)
    ]


def _amount(results: RetrofitResults, layout: Layout) -> str:
    cost = f"cost {layout.objective:.6g} {results.currency}".rstrip()
    return f"{f'{cost}, ' * results.priced}{layout.steel:.4g} kg of steel"


def _reached(reached: Reached | None) -> str:
    value = None if reached is None else reached.value
    return "not known" if value is None else f"{value:.4g}" if isfinite(value) else "overturns"


def _worst(results: RetrofitResults) -> str:
    """Say what the best reaches in its proof, the worst of all tolerances."""
    values = [each.reached.value for each in results.proofs if each.reached.value is not None]
    if results.best is None or not values:
        return " in the search" if results.failed else ""
    worst = min(values) if results.target.rising else max(values)
    return f" in the search and {worst:.4g} at the worst of the proof"
