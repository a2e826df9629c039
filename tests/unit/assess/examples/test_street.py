"""The street: a table whose every row is a valid project, other than its neighbours."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from assess import cli
from assess.examples import copy_example
from assess.portfolio.projects import find_tasks, project_tree
from assess.project.build import build
from assess.project.project_file import load_tree
from assess.study.run import find_outcome


def test_every_facade_of_the_street_has_a_verdict(tmp_path: Path) -> None:
    template = copy_example("street", tmp_path / "street")
    found = {path.name for path in template.parent.iterdir()}
    assert found == {"README.md", "project.schema.json", "street.csv", "template.toml"}
    tasks = find_tasks(template.parent / "street.csv", template)
    studies = [build(load_tree(project_tree(task), task.path, sha256=task.sha256)) for task in tasks]
    found = [find_outcome(study) for study in studies]
    assert [task.key for task in tasks] == [f"V{number:02}" for number in range(1, 41)]
    assert len({task.sha256 for task in tasks}) == len({each.mechanisms[0].margin for each in found}) == 40
    assert set(Counter(each.outcome.value for each in found)) == {"pass", "fail"}
    assert not any(message.severity == "warning" for study in studies for message in study.messages)


def test_new_prints_the_command_for_its_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        cli.main(["new", str(tmp_path / "street"), "--example", "street"])
    file, command = capsys.readouterr().out.splitlines()
    assert file == str(tmp_path / "street" / "template.toml")
    assert command == f"assess batch {tmp_path / 'street' / 'street.csv'} --template {file}"
