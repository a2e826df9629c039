"""The last step that all kinds of mechanism share: what their impacts keep."""

from __future__ import annotations

from collections.abc import Iterable

from assess.geometry.outline import Outline
from assess.mechanisms.chain import Chain, require_movable
from assess.mechanisms.doubts import pulling_supports
from assess.mechanisms.impact import RestitutionChoice, impact
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.virtual_work import require_stable
from assess.restitution import Restitution


def assembled(
    name: str,
    kind: str,
    positive: Chain,
    negative: Chain | None,
    *,
    label: str,
    restitution: tuple[RestitutionChoice, RestitutionChoice],
    outlines: tuple[Outline, ...],
    notices: Iterable[str] = (),
) -> Mechanism:
    """The mechanism of the chains of one kind, with its coefficients of restitution resolved.

    Raises MechanismError for a chain that cannot move or already falls, and for a restitution that is not for it.
    """
    chains = {"": positive} if negative is None else {"": positive, "'": negative}
    for chain in chains.values():
        require_movable(chain, name=name)
        require_stable(chain, name=name)
    pulling = [text for mark, chain in chains.items() for text in pulling_supports(chain, mark=mark)]
    kept = impact(restitution[0], ending=positive, starting=negative, kind=kind, name=name)
    back = (
        kept if negative is None else impact(restitution[1], ending=negative, starting=positive, kind=kind, name=name)
    )
    return Mechanism(
        name=name,
        label=label or name,
        kind=kind,
        sides="one" if negative is None else "two",
        positive=positive,
        negative=negative,
        restitution=(kept.value, back.value),
        restitution_source=_sources(kept, back),
        elevation=positive.hinges[0][1],
        outlines=outlines,
        notices=(*notices, *pulling, *sorted({kept.notice, back.notice} - {""})),
    )


def _sources(positive: Restitution, negative: Restitution) -> str:
    if positive.source == negative.source:
        return positive.source
    return f"positive: {positive.source}; negative: {negative.source}"
