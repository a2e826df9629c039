"""Mechanisms that the engineer strikes out with a reason: they fail no more, and a pass depends on the reason."""

from pathlib import Path

import pytest

from assess.codes.verdict import Decision, Verdict
from assess.errors import ProjectError
from assess.loads.load import TieLoad
from assess.mechanisms.single_block import SingleBlock
from assess.project.build import build
from assess.project.found_mechanisms import find_mechanisms
from assess.project.opened import OpenedProject
from assess.project.project_file import load
from assess.project.site_and_structure import definitions_of
from assess.results import Results
from assess.study.run import find_verdict, run_study
from tests.support.projects import NTC, block, project_toml, wall

REASON = "measured: the parapet was taken down, photograph 7"


def write(folder: Path, *, names: tuple[str, ...] = ("thick", "parapet"), **struck: str) -> Path:
    """Write a project of a thick wall and a slender parapet, of which some are struck out."""
    text = project_toml(
        site={"spectrum": NTC, "limit_state": "SLV"},
        materials={"m": {"density": 1800, "disintegration": "excluded"}},
        report={"sources": {"materials.m.disintegration": "measured: survey"}, "struck_out": struck},
        analysis={"procedures": ["ntc2018-nonlinear"]},
        bodies={
            "thick": wall(2.5, 3.0, 3.0, material="m"),
            "parapet": wall(0.12, 3.0, 1.5, material="m", base=[0.0, 5.0, 0.0]),
        },
        mechanisms={name: block(name, direction=[1, 0, 0], sides="one") for name in names},
    )
    file = folder / "project.toml"
    file.write_text(text, encoding="utf-8")
    return file


def verdict_of(file: Path) -> Verdict:
    return find_verdict(build(load(file)))


def test_what_is_struck_out_fails_no_more_and_a_pass_depends_on_the_reason(tmp_path: Path) -> None:
    whole = verdict_of(write(tmp_path))
    assert whole.outcome == Decision.FAIL
    assert {each.mechanism: each.outcome for each in whole.mechanisms}["thick"] == Decision.PASS
    found = verdict_of(write(tmp_path, parapet=REASON))
    assert found.outcome == Decision.PASS
    assert [each.mechanism for each in found.mechanisms] == ["thick"]
    assert found.mechanisms[0].margin == next(each.margin for each in whole.mechanisms if each.mechanism == "thick")
    (condition,) = (each for each in found.conditions if each.key == "struck-out")
    assert "parapet" in condition.text
    assert REASON in condition.text


def test_what_it_would_come_to_stands_beside_the_pass(tmp_path: Path) -> None:
    without = run_study(build(load(write(tmp_path))), jobs=1).verdict
    found = run_study(build(load(write(tmp_path, parapet=REASON))), jobs=1).verdict
    assert found is not None
    assert without is not None
    (line,) = (each for each in found.overrides if each.key == "report.struck_out.parapet")
    assert (line.outcome_instead, line.source) == (Decision.FAIL, REASON)
    assert line.margin_instead == min(each.margin for each in without.mechanisms if each.margin is not None)
    assert found.outcome == Decision.PASS
    harmless = run_study(build(load(write(tmp_path, thick=REASON))), jobs=1).verdict
    assert harmless is not None
    assert "report.struck_out.thick" not in [each.key for each in harmless.overrides]


TIE = {
    "kind": "tie",
    "area": 113e-6,
    "young_modulus": 210e9,
    "yield_stress": 235e6,
    "length": 9.0,
    "fracture_strain": 0.1,
    "plate": {"width": 0.4, "height": 0.4, "thickness": 0.03, "yield_stress": 235e6, "far_strength": 60e3},
}


def test_bars_of_what_is_struck_out_pull_and_punch_beside_the_others(tmp_path: Path) -> None:
    """A mechanism that cannot occur leaves its ties where they are: the others' cones and far walls share with them."""
    walls = {"thick": (1.0, 2.0), "parapet": (1.5, 1.0)}
    text = project_toml(
        bodies={"front": wall(0.5, 6.0, 4.0), "rear": wall(0.6, 6.0, 4.0, base=[9.0, 0.0, 0.0])},
        mechanisms={
            name: block("front", direction=[-1, 0, 0], sides="one", cut=f"{cut} m")
            | {"loads": [TIE | {"at": [-0.25, y, 3.0], "anchor": [9.0, y, 3.0]}]}
            for name, (y, cut) in walls.items()
        },
    )

    def others(more: str) -> list[object]:
        (tmp_path / "project.toml").write_text(text + more, encoding="utf-8")
        definition = definitions_of(load(tmp_path).content)["thick"]
        assert isinstance(definition, SingleBlock)
        return [each.at for tie in definition.loads if isinstance(tie, TieLoad) for each in tie.others]

    assert others("") == [(-0.25, 1.5, 3.0)]
    assert others(f'[report.struck_out]\nparapet = "{REASON}"\n') == [(-0.25, 1.5, 3.0)]


def test_what_cannot_be_built_is_told_as_not_known(tmp_path: Path) -> None:
    file = write(tmp_path, parapet=REASON)
    file.write_text(file.read_text(encoding="utf-8").replace('blocks = ["parapet"]', 'blocks = ["nobody"]'), "utf-8")
    (line,) = (each for each in verdict_of(file).overrides if each.key == "report.struck_out.parapet")
    assert (line.outcome_instead, line.margin_instead) == (Decision.INCOMPLETE, None)


def test_a_key_of_a_mechanism_with_a_longer_name_is_not_struck_out(tmp_path: Path) -> None:
    """Names may hold dots: "a" is struck out, "a.b" is not, and a misspelt key of it is still refused."""
    text = project_toml(mechanisms={name: block() for name in ("a", "a.b")}, report={"struck_out": {"a": REASON}})
    (tmp_path / "project.toml").write_text(text, encoding="utf-8")
    content = load(tmp_path).content
    assert content.is_struck_out("mechanisms.a.direction")
    assert not content.is_struck_out("mechanisms.a.b.direction")
    assert not content.is_struck_out("mechanisms.ab.direction")


def test_what_the_file_says_of_it_besides_may_stay(tmp_path: Path) -> None:
    file = write(tmp_path, parapet=REASON)
    text = file.read_text(encoding="utf-8")
    source = '[report.sources]\n"mechanisms.parapet.direction" = "measured: survey"'
    file.write_text(text.replace("[report.sources]", source, 1), encoding="utf-8")
    assert source in file.read_text(encoding="utf-8")
    assert verdict_of(file).outcome == Decision.PASS


def test_results_name_it_among_what_is_not_examined(tmp_path: Path) -> None:
    found: Results = run_study(build(load(write(tmp_path, parapet=REASON))), jobs=1)
    assert found.report.struck_out == (("parapet", REASON),)
    assert found.report.number_left_out == 1


@pytest.mark.parametrize("reason", ["", "  ", "assumed: it will hold", "…"])
def test_without_a_reason_nothing_is_struck_out(tmp_path: Path, reason: str) -> None:
    with pytest.raises(ProjectError, match=r"report\.struck_out\.parapet.*no reason"):
        load(write(tmp_path, parapet=reason))


def test_one_mechanism_is_kept(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="every mechanism of the file is struck out"):
        load(write(tmp_path, parapet=REASON, thick=REASON))


def test_a_name_that_the_file_has_not_strikes_nothing_of_it(tmp_path: Path) -> None:
    """It may be of a mechanism that is found on the bodies; it stands in the report all the same."""
    found = verdict_of(write(tmp_path, parapett=REASON))
    assert found.outcome == Decision.FAIL
    assert {each.mechanism for each in found.mechanisms} == {"thick", "parapet"}
    assert "struck-out" in [each.key for each in found.conditions]


def test_what_is_struck_out_is_not_proposed_again(tmp_path: Path) -> None:
    """Neither as it stands in the file nor, where it does not, by the name under which it is found."""

    def proposed(names: tuple[str, ...], **struck: str) -> set[str]:
        return {each.name for each in find_mechanisms(load(write(tmp_path, names=names, **struck))).new}

    found = proposed(("thick",))
    assert found
    assert proposed(("thick", "parapet"), parapet=REASON) == proposed(("thick", "parapet")) == set()
    assert proposed(("thick",), **dict.fromkeys(found, REASON)) == set()


def test_on_the_page_it_is_tried_taken_back_and_written(tmp_path: Path) -> None:
    file = write(tmp_path)
    opened = OpenedProject(file)
    with pytest.raises(ProjectError, match="no reason"):
        opened.edited.strike_out("parapet", "")
    opened.edited.strike_out("parapet", REASON)
    assert opened.examine("parapet").fault == f"struck out: {REASON}"
    found = opened.find_outcome()
    assert found is not None
    assert found.outcome == Decision.PASS
    opened.edited.undo()
    assert opened.find_outcome().outcome == Decision.FAIL  # type: ignore[union-attr]
    opened.edited.strike_out("parapet", REASON)
    opened.write()
    assert verdict_of(file) == found
