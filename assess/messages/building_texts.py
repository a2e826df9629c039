"""The English text of messages on the parts of a building read from a model, by key."""

from __future__ import annotations

from collections.abc import Mapping

BUILDING_TEXTS: Mapping[str, str] = {
    "density-assumed": "the model states no density for {number} of its parts: {masonry} are assumed for masonry and "
    "{covering} for floors, roofs and vaults",
    "split-body": "{body} is one closed body: it is split into {number} parts between opposite faces, and where its "
    "floors bear is not drawn",
    "lying-by-names": "parts that lie where their names or classes say that they stand, or stand where these say that "
    "they lie: {number}, as {part}; does the model lie on its side? check the axis that points up (--up, mesh_up)",
    "lying-by-thickness": "what lies level is {level} thick and what stands upright {upright}, as of a model that lies "
    "on its side; check the axis that points up (--up, mesh_up)",
    "one-shell": "most of the building is one closed body that had to be split: towers, apses and the kind of building "
    "cannot be told from it, so that no list of mechanisms is ticked; draw its parts apart, or fill in what it is",
    "bears-on-nothing": "floors, roofs or vaults that bear on no wall, so that no mechanism has their weight: {number} "
    "({names}); draw them down to what carries them, within 5 cm, or give their loads",
    "layers-of-finish": "walls of which some layers are no masonry, as insulation, air or plaster: {number} ({names}); "
    "their thickness and mass are those of all layers, so give that of the masonry",
    # what is not read as masonry
    "left-out-without-body": "it has no body: {why}",
    "left-out-not-closed": "its surface is no closed body: {why}",
    "left-out-splinters": "closed shells too small for masonry: {number}, {volume} in all",
    "left-out-furniture": "furniture",
    "left-out-joinery": "a window, a door or glazing",
    "left-out-railing": "a railing",
    "left-out-finish": "a finish: plaster, insulation or cladding",
    "left-out-stairs": "stairs or a ramp, which no part is for",
    "left-out-lettering": "lettering",
    "left-out-terrain": "terrain",
    "left-out-foundation": "a foundation",
    "left-out-services": "services",
    "left-out-fastener": "a fastener or reinforcement",
    "left-out-opening": "an opening or another feature of an element",
    "left-out-room": "a room",
    "left-out-material": "its material is no masonry: {material}",
    "left-out-thin": "too thin for masonry: {thickness}",
    "left-out-frame": "a beam, a lintel or a member of a frame",
    "left-out-twice": "{share} of its volume lies in other parts: it is drawn twice, or in the wrong place",
    "left-out-unknown": "its shape is none of a wall, a floor, a roof, a vault, an arch, a pier or a tower",
}
