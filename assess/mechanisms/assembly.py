"""The last step that all kinds of mechanism share: what their impacts keep."""

from __future__ import annotations

from collections.abc import Iterable

from assess.geometry.outline import Outline
from assess.mechanisms.chain import Chain, require_movable
from assess.mechanisms.doubts import pulling_supports
from assess.mechanisms.flexible import FlexibleChain
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
    hit, other = turning_about(positive, name=name), negative and turning_about(negative, name=name)
    kept = impact(restitution[0], ending=hit, starting=other, kind=kind, name=name)
    back = kept if other is None else impact(restitution[1], ending=other, starting=hit, kind=kind, name=name)
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


def turning_about(chain: Chain, *, name: str) -> Chain:
    """The rigid chain of an impact: with joints, about their fixed hinges a_SF inside the edges (6.60, 6.67, 6.72)."""
    return FlexibleChain(chain, name).fixed if chain.joints else chain


def _sources(positive: Restitution, negative: Restitution) -> str:
    if positive.source == negative.source:
        return positive.source
    return f"positive: {positive.source}; negative: {negative.source}"
