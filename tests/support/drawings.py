"""Model files of buildings of boxes, and a project that was drawn from one, filled in."""

from collections.abc import Sequence
from pathlib import Path

from assess.model.structure import Part

HEADINGS = (
    "The site",
    "A tie",
    "Who says",
    "The masonry",
    "The storeys",
    "The cracks",
    "The direction",
    "Storeys whose",
    "The kind",
    "each mechanism",
    "---- To fill",
)
EXAMPLES = ("    ", *HEADINGS)


def obj_of(parts: Sequence[Part], *, named: bool = True) -> str:
    """Return parts as an OBJ file, an object each, or all in one."""
    lines, first = [] if named else ["o building"], 1
    for part in parts:
        lines += [f"o {part.name.replace(' ', '_')}"] if named else []
        lines += ["v " + " ".join(f"{x:.9g}" for x in corner) for corner in part.solid.vertices]
        lines += ["f " + " ".join(str(first + i) for i in triangle) for triangle in part.solid.triangles]
        first += len(part.solid.vertices)
    return "\n".join(lines) + "\n"


def fill_in(file: Path) -> int:
    """Remove the # of what the survey fills in, and return how many lines that is."""
    head, block = file.read_text(encoding="utf-8").split("# ---- To fill in", 1)
    lines, filled = ["# ---- To fill in" + block.split("\n")[0]], 0
    for line in block.split("\n")[1:]:
        key = line.removeprefix("# ")
        if line.startswith("# ") and not key.startswith(EXAMPLES):
            line, filled = key.replace("…, by whom and when", "two openings, A. Rossi, 2026-05-04"), filled + 1
        lines.append(line)
    file.write_text(head + "\n".join(lines), encoding="utf-8")
    return filled
