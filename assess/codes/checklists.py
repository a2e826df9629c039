"""The mechanisms that a building of a type can have, for the engineer to tick: examined, absent, or why not examined.

Houses: the local mechanisms of the Italian survey forms. Churches: the 28 mechanisms of the Italian form A-DC (2006),
which the guidelines of 2011 have too, with its numbers; from memory of the printed form.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

BuildingType = Literal["house", "church"]


@dataclass(frozen=True)
class PossibleMechanism:
    """A mechanism that a building of a type can have.

    number: in the form for churches, None for houses; in_plane: whether walls are damaged in their own plane, which
    rocking mechanisms do not answer.
    """

    key: str
    number: int | None
    name: str
    in_plane: bool = False


CHECKLISTS: Mapping[BuildingType, tuple[PossibleMechanism, ...]] = {
    "house": (
        PossibleMechanism("simple-overturning", None, "simple overturning of walls"),
        PossibleMechanism("compound-overturning", None, "compound overturning, with a wedge of the side walls"),
        PossibleMechanism("vertical-bending", None, "vertical bending between storeys"),
        PossibleMechanism("horizontal-bending", None, "horizontal bending between cross walls"),
        PossibleMechanism("two-way-bending", None, "two-way bending of walls held on three or four sides"),
        PossibleMechanism("corner", None, "overturning of corners"),
        PossibleMechanism("gable", None, "overturning of gables"),
        PossibleMechanism("parapet", None, "overturning of parapets"),
        PossibleMechanism("chimney", None, "overturning of chimneys"),
        PossibleMechanism("outer-leaf", None, "separation of the outer leaf"),
        PossibleMechanism("in-plane", None, "damage of walls in their plane", in_plane=True),
    ),
    "church": (
        PossibleMechanism("facade", 1, "overturning of the façade"),
        PossibleMechanism("facade-top", 2, "overturning of the top of the façade"),
        PossibleMechanism("facade-in-plane", 3, "damage of the façade in its plane", in_plane=True),
        PossibleMechanism("porch", 4, "porch or narthex"),
        PossibleMechanism("nave-transverse", 5, "transverse response of the nave"),
        PossibleMechanism("side-walls-in-plane", 6, "damage of the side walls in their plane", in_plane=True),
        PossibleMechanism("colonnade", 7, "longitudinal response of the colonnade"),
        PossibleMechanism("nave-vaults", 8, "vaults of the nave"),
        PossibleMechanism("aisle-vaults", 9, "vaults of the aisles"),
        PossibleMechanism("transept-end", 10, "overturning of the end walls of the transept"),
        PossibleMechanism("transept-in-plane", 11, "damage of the transept walls in their plane", in_plane=True),
        PossibleMechanism("transept-vaults", 12, "vaults of the transept"),
        PossibleMechanism("triumphal-arch", 13, "triumphal arch"),
        PossibleMechanism("dome", 14, "dome and drum"),
        PossibleMechanism("lantern", 15, "lantern"),
        PossibleMechanism("apse", 16, "overturning of the apse"),
        PossibleMechanism("apse-in-plane", 17, "damage of presbytery and apse walls in their plane", in_plane=True),
        PossibleMechanism("apse-vaults", 18, "vaults of presbytery and apse"),
        PossibleMechanism("roof-side-walls", 19, "roof elements on the side walls"),
        PossibleMechanism("roof-transept", 20, "roof elements on the transept"),
        PossibleMechanism("roof-apse", 21, "roof elements on the apse and presbytery"),
        PossibleMechanism("chapels", 22, "overturning of the chapels"),
        PossibleMechanism("chapels-in-plane", 23, "damage of the chapel walls in their plane", in_plane=True),
        PossibleMechanism("chapel-vaults", 24, "vaults of the chapels"),
        PossibleMechanism("irregularities", 25, "interaction where plan or elevation is irregular"),
        PossibleMechanism("projections", 26, "projections: bell gables, spires, pinnacles, statues"),
        PossibleMechanism("bell-tower", 27, "bell tower"),
        PossibleMechanism("bell-cell", 28, "bell cell"),
    ),
}
"""The list of each type of building, in the order of the report."""


def possible_mechanism(building_type: BuildingType, key: str | int) -> PossibleMechanism | None:
    """Return the item of a list by its key or its number in the form.

    Parameters
    ----------
    building_type : whose list it is
    key : of an item, or its number

    Returns
    -------
    None if the list has none.
    """
    by_name: dict[str, PossibleMechanism] = {}
    for each in CHECKLISTS[building_type]:
        by_name[each.key] = each
        if each.number is not None:
            by_name[str(each.number)] = each
    return by_name.get(str(key))


def item_name(building_type: str, key: str) -> str:
    """Return the English name of an item of a list.

    Parameters
    ----------
    building_type : "house" or "church"
    key : of an item

    Returns
    -------
    The key itself if no list of this program has it.
    """
    items = CHECKLISTS["church"] if building_type == "church" else CHECKLISTS["house"]
    return next((each.name for each in items if each.key == key), key)
