"""The English text of messages on the mechanisms that are found on a building, by key."""

from __future__ import annotations

from collections.abc import Mapping

CANDIDATE_TEXTS: Mapping[str, str] = {
    "candidate-title": "{part}: {what}",
    # why a mechanism can form
    "reason-and": "{one}; {other}",
    "reason-facade": "free façade, {length} long, above z = {z}",
    "reason-inner-wall": "wall with rooms on both sides, {length} long, above z = {z}",
    "reason-meets": "met by {walls}, whose bond is not known",
    "reason-no-return": "no wall meets it",
    "reason-bears": "{body} bears on it at z = {z}",
    "reason-tied": "by its shape {bodies} would push it over, yet it stands: that something takes the thrust is to be "
    "confirmed",
    "reason-path": "the drawing does not tell which walls carry {bodies}: the share of the lower static multiplier is "
    "taken; give the one surveyed",
    "reason-path-none": "the drawing does not tell whether it carries {bodies}: without that the static multiplier is "
    "lower, so that it is no load here; give the share surveyed",
    "reason-ties": "{ties} may hold it and is left out",
    "reason-wedges": "a wedge of {walls} may come with it, cracked at up to 30 degrees from the vertical",
    "reason-corner": "outer corner of {one} and {other}, whose bond is not known",
    "reason-spans": "taken as held at z = {low} and at z = {high} by what bears there, which only a survey can "
    "confirm; free between",
    "reason-bay": "bay of {span} between {one} and {other}, with masonry beyond both to thrust against",
    "reason-cap": "stands free above z = {z}",
    "reason-apse": "bends in plan over {length}; it may break outwards above a crack of any height and inclination",
    "reason-shaft": "free-standing, {height} high; a crack may run at any height and inclination",
    "reason-arch": "arch that spans {span}",
    "reason-portal": "{over} stands on {one} and {other}, which may sway",
    # what is possible and not looked for
    "gap-stopped": "above z = {z} {walls} would stop it where it turns as a whole; what turns beside them is not "
    "looked for",
    "gap-unpressed": "held at z = {low} and z = {high}, and what presses on it from above is not drawn in full",
    "gap-bay-ends": "no masonry of the wall lies beyond one or both of the cross walls, so that nothing that is drawn "
    "holds the thrust of an arch; where a tie or a neighbour holds it, state a horizontal-arch with its ends",
    "gap-no-wedge": "without a bond that a survey has found it is weakest without a wedge, as it turns alone; with "
    "one, state a façade with wedges and its side_walls",
    "gap-inner-wedges": "a wall with rooms on both sides, whose wedges are not looked for",
    "gap-bell-cell": "{number} piers stand on it; the sway of more than two is not looked for",
    "gap-caps": "{parts} would fall with it and is no part of what is looked for",
    "gap-tower-corners": "the corners of its shaft are not looked for",
    "gap-facade-top": "it may be the façade, and nothing is found that turns above its foot",
    "gap-which-arch": "the drawing does not tell which arch is the triumphal arch",
    # what cannot form, as it is drawn
    "no-storey": "it rises less than {height} above any level at which it may crack",
    "no-side-wall": "no wall meets it from behind",
    "no-outer-corner": "it has no outer corner with another façade",
    "no-wedge-between-rooms": "walls on both sides stop it",
    "no-upper-hold": "nothing that is drawn holds it above its foot, so that it turns as a whole",
    "no-span": "the levels that hold it are less than {height} apart",
    "no-bay": "it has no two cross walls {span} apart or more",
    # parts without a mechanism
    "no-mechanism": "{part}: no mechanism found; nothing is free to turn, and no two levels hold it with a load above",
    "no-mechanism-built": "{part}: its mechanisms have no multiplier: {why}",
}
