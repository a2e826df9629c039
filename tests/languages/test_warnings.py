"""Every message is known in every language: those of `messages.texts` key by key, and the texts that stand within them.

The latter are read out of the functions that make them. A text is a literal of the source with 7 in its gaps;
`count_noun(n, "hole")` gives "1 hole" and "7 holes". Literals of what is raised, of `where` it would be, and those of
one word, are none. What stands only within others is in COMPOSED, with the sentences that it makes.
"""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from reports.language.translation import Translator

from assess.geometry.mesh import load
from assess.messages.texts import TEXTS
from records.formats import FORMATS
from reports.language.catalogue import FOLDER, catalogue, languages
from tests.support.readings import LINES

ROOT = Path(__file__).parents[2]
FILLED = "7"
MAKERS = ("message", "warning", "note")
SOURCES: Mapping[str, tuple[str, ...]] = {
    "assess/geometry/plausibility.py": ("_likely_unit", "size_warning"),
    "assess/geometry/mesh.py": ("_axis_warnings", "_resolve_unit"),
    "assess/geometry/repair.py": (
        "_drop_double_triangles",
        "_fill_holes",
        "_orient_consistently",
        "_split_edges",
        "_weld_borders",
    ),
    "assess/geometry/shells.py": ("_drop_flat", "_reverse_inverted", "_unite_overlapping", "unify_shells"),
    "assess/geometry/self_overlap.py": ("self_overlap_warnings",),
    "assess/geometry/surface.py": ("volume_change_text",),
    "assess/interfaces/contact.py": ("out_of_plane_warning",),
    "assess/mechanisms/warnings.py": ("loads_across_crack", "loose_hinges", "supports_in_tension"),
    "assess/mechanisms/equivalent_block.py": ("equivalent_block",),
    "assess/mechanisms/impact.py": ("_faster", "no_rebound", "sorrentino_rebound"),
    "assess/mechanisms/single_block.py": ("_off_base",),
    "assess/amplification/natural_frequency.py": ("ASSUMPTIONS",),
    "assess/study/amplification.py": ("RAYLEIGH", "by_first_mode"),
    "assess/model/arches.py": ("hinges_text", "joint_warnings"),
    "assess/model/pieces.py": ("ASKEW", "hinge_warnings", "uneven_base_warnings"),
    "assess/loads/body_loads.py": ("alone", "beside_the_block", "body_loads", "part_of"),
    "assess/model/directions.py": ("CORNER",),
    "assess/model/joints.py": (
        "contact_offset_warnings",
        "eccentricity_warnings",
        "joint_at",
        "outlined_joint",
        "shaped_joint",
    ),
    "assess/loads/loaded_blocks.py": ("_left_out", "as_given"),
    "assess/model/loading.py": ("misplaced_load_warnings", "moving_anchor_warnings"),
    "assess/study/record_set.py": ("_first", "cell_text"),
    "assess/study/coarse_records.py": ("longest_step",),
    "assess/model/walls.py": ("by_formula", "by_search"),
    "records/flatfile_match.py": ("_reason",),
    "records/arrival.py": ("arrival_warning",),
    "records/formats/agreement.py": ("check_integral", "describe_disagreement"),
    "records/formats/corners.py": ("nyquist_warning", "filter_warning"),
    "records/formats/layout.py": ("check_layout",),
    "records/plausibility.py": ("_peak_warning", "_impossible", "_likely", "_of_frequencies", "_of_step", "_of_steps"),
    "spectra/asce7.py": ("mapped_spectrum",),
    "spectra/asce7_editions.py": ("STUDIES_2016",),
    "spectra/nzs1170_5.py": ("_capped",),
    "spectra/spectrum.py": ("plausibility_warnings",),
}
"""Files with the functions and constants in which texts are written that messages take as they are."""

_LONGEST = 'body "7" measures 7 m at its longest; is its unit right?'
_THICK = 'body "7" measures 7 m at its longest and is about 7 m thick; is its unit right?'
_ALONE, _BESIDE = (
    "nothing else in the project carries it",
    "the hinge lies 7 m 7 the edge of its contact, which is 7 m deep",
)
_HALF = "half of it is taken, since its other foot must stand on something: else give share"
_CRACK = "crack at z = 7 m, 7 of the height, where the uplift multiplier is least, 7"
_HELD = " with the mortar's tension before it opens"
COMPOSED: Mapping[str, tuple[str, ...]] = {
    f"{_LONGEST}7": (_LONGEST,),
    f"{_THICK}7": (_THICK,),
    ' With mesh_unit = "7" it would measure 7 m': tuple(
        f'{measured} With mesh_unit = "7" it would measure 7 m' for measured in (_LONGEST, _THICK)
    ),
    f"7; {_HALF}": (f"{_ALONE}; {_HALF}",),
    "7, so its whole weight is on the block: else give share": (
        f"{_ALONE}, so its whole weight is on the block: else give share",
    ),
    _ALONE: (f"share 1 ({_ALONE})",),
    "; by statics 7": ("share 7 (given; by statics 7)",),
    f"7: {_BESIDE}; pressure is counted from the hinge on": tuple(
        f"interface A: {_BESIDE.replace(' m 7 ', f' m {side} ')}; pressure is counted from the hinge on"
        for side in ("inside", "outside")
    ),
    _HELD: (f"{_CRACK}{_HELD}",),
    " (read in 7; in 7 it would be 7 g)": (
        "its peak is 7 g, below 7 g; check the unit (read in 7; in 7 it would be 7 g)",
    ),
}


def messages() -> Iterator[tuple[str, str]]:
    """Every text that stands alone, with where it is."""
    for file, names in SOURCES.items():
        for text in (text for name in names for text in texts(_definition(file, name))):
            yield from ((file, whole) for whole in COMPOSED.get(text, (text,)))


def texts(node: ast.AST) -> Iterator[str]:
    """The texts within a piece of source."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Raise) or _is_docstring(child) or _is_place(child):
            continue
        if isinstance(child, ast.Call) and isinstance(child.func, ast.Name) and child.func.id == "count_noun":
            noun = ast.literal_eval(child.args[1])
            yield from (f"1 {noun}", f"{FILLED} {noun}s")
        elif (text := _written(child)) is not None:
            yield from (text,) if " " in text.strip() else ()
            yield from (each for value in getattr(child, "values", ()) for each in texts(value))
        else:
            yield from texts(child)


def _written(node: ast.AST) -> str | None:
    """A literal with its gaps filled."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else None
    if not isinstance(node, ast.JoinedStr):
        return None
    return "".join(str(each.value) if isinstance(each, ast.Constant) else FILLED for each in node.values)


def _is_docstring(node: ast.AST) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _is_place(node: ast.AST) -> bool:
    """Whether it says where an error would be."""
    if isinstance(node, ast.keyword):
        return node.arg == "where"
    return isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "where"


def _definition(file: str, name: str) -> ast.AST:
    """The function or the constant of a name. Raises ValueError where the file has none."""
    for node in _tree(file).body:
        targets = node.targets if isinstance(node, ast.Assign) else ()
        named = {node.name} if isinstance(node, ast.FunctionDef) else {ast.unparse(target) for target in targets}
        if name in named:
            return node
    raise ValueError(f"{file}: {name}: not there any more; say where its texts are written now")


@cache
def _tree(file: str) -> ast.Module:
    return ast.parse((ROOT / file).read_text(encoding="utf-8"))


def called() -> set[str]:
    """The keys that the program makes messages by, where they are written at the call."""
    paths = [str(path.relative_to(ROOT)) for path in (ROOT / "assess").rglob("*.py")]
    calls = (node for path in paths for node in ast.walk(_tree(path)) if isinstance(node, ast.Call))
    firsts = [call.args[0] for call in calls if call.args and getattr(call.func, "id", "") in MAKERS]
    return {each.value for each in firsts if isinstance(each, ast.Constant) and isinstance(each.value, str)}


def unknown(text: str, *, language: str, verbatim: frozenset[str] = frozenset()) -> list[str]:
    """The parts of a text that the catalogue of a language does not know."""
    translator = Translator(catalogue(language), verbatim)
    translator.translate(text)
    return list(translator.unknown)


@pytest.mark.parametrize("language", languages()[1:])
def test_every_text_of_a_warning_is_known(language: str) -> None:
    found = list(messages())
    assert len(found) > 100
    assert [(file, text) for file, text in found if unknown(text, language=language)] == []


@pytest.mark.parametrize("language", languages()[1:])
@pytest.mark.parametrize("key", TEXTS)
def test_every_message_is_known(language: str, key: str) -> None:
    assert unknown(re.sub(r"\{\w+\}", FILLED, TEXTS[key]), language=language) == []


@pytest.mark.parametrize("language", languages()[1:])
def test_no_message_is_translated_that_is_no_more(language: str) -> None:
    entries = tomllib.loads((FOLDER / f"{language}.toml").read_text(encoding="utf-8"))["sentences"]["messages"]
    written = {re.sub(r"\{\w+\}", "{}", text) for text in TEXTS.values()}
    assert [text for text in entries if re.sub(r"\{\d+\}", "{}", text) not in written] == []


@pytest.mark.parametrize("language", languages()[1:])
@pytest.mark.parametrize("name", FORMATS)
def test_the_format_a_record_was_read_from_is_known(language: str, name: str) -> None:
    left = unknown(f"read from {name}" + " numbers" * (name == "plain"), language=language)
    assert left == [], f"add {name}, a proper name, to the list `unchanged` at the top of {language}.toml"


@pytest.mark.parametrize("language", languages()[1:])
def test_formulas_that_are_words_and_values_of_reasons_are_known(language: str) -> None:
    """Of every procedure, whatever the project: those of few sheets and of outcomes that the examples do not have."""
    words = {*LINES, *(text for path in (ROOT / "assess/codes").rglob("*.py") for text in _values_of_reasons(path))}
    assert len(words) > 50
    left = [text for text in sorted(words) if unknown(text, language=language)]
    assert left == [], f"add each to reports/language/catalogues/{language}.toml"


def _values_of_reasons(path: Path) -> Iterator[str]:
    """The literals that stand in the gaps of reasons as they are."""
    for call in ast.walk(_tree(str(path.relative_to(ROOT)))):
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "reason_message":
            yield from (text for each in call.keywords if (text := _written(each.value)) is not None)


def test_every_key_that_is_written_has_a_text() -> None:
    assert len(called()) > 20
    assert called() <= TEXTS.keys()


def test_what_stands_within_others_is_still_there() -> None:
    """If not: it is written in a function that SOURCES does not name yet, or in other words; or it is no more."""
    written = {text for file, names in SOURCES.items() for name in names for text in texts(_definition(file, name))}
    assert COMPOSED.keys() <= written


@pytest.mark.parametrize("name", ["floor", "the wall", "overturned"])
def test_names_that_are_words_of_the_catalogue_are_kept(name: str) -> None:
    text = (
        f'load "{name}": nothing else in the project carries it, so its whole weight is on the block: else give share'
    )
    translator = Translator(catalogue("it"), frozenset({name}))
    assert translator.translate(text).startswith(f'carico "{name}": nient’altro')
    assert translator.translate(f'share 0.5 (statics; the rest on "{name}", "{name}")').endswith(f'"{name}", "{name}")')
    assert not translator.unknown


@pytest.mark.parametrize("language", languages()[1:])
def test_the_warning_of_a_mended_mesh_is_known_whole(language: str, tmp_path: Path) -> None:
    """Two cubes apart, one inside out and with a hole: what was done to it, after the name of its file."""
    corners = np.array(np.meshgrid([0.0, 1.0], [0.0, 1.0], [0.0, 1.0], indexing="ij")).reshape(3, -1).T
    cube = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                     [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip
    faces = np.vstack([cube, cube[:-1, ::-1] + 8])
    lines = [f"v {x} {y} {z}" for x, y, z in np.vstack([corners, corners + 3.0])]
    lines += [f"f {a} {b} {c}" for a, b, c in faces + 1]
    file = tmp_path / "my wall.obj"
    file.write_text("\n".join(lines))
    trail = load(file, name="wall", density=1.0).history
    assert "hole" in str(trail)
    assert "reversed" in str(trail)
    text = f"{file.name}: {'; '.join(trail)}"
    assert unknown(text, language=language, verbatim=frozenset({file.name})) == []
