"""A run of a project can be followed and cancelled."""

from __future__ import annotations

import http.client
import threading
from contextlib import closing

import pytest

from assess.page.jobs import ProjectRun
from tests.support.projects import project_toml

PATIENCE = 120.0  # s


def run_of(folder, text: str, *, cancel: bool = False) -> tuple[ProjectRun, list[str], list[str]]:
    """Run a project; return the run, the lines that it told and how it ended."""
    (folder / "project.toml").write_text(text, encoding="utf-8")
    told, ends, first = [], [], threading.Event()

    def tell(line: str) -> None:
        told.append(line)
        first.set()

    found = ProjectRun(folder / "project.toml", tell=tell, done=ends.append)
    if cancel:
        first.wait(PATIENCE)
        found.cancel()
    found.wait(PATIENCE)
    return found, told, ends


def test_a_run_tells_its_stages_and_writes_where_a_run_does(tmp_path):
    found, told, ends = run_of(tmp_path, project_toml(verdict={"basis": "asce43-05"}))
    assert ends == [""]
    assert any("report" in line for line in told)
    assert (found.folder / "results.json").is_file()
    assert found.folder == tmp_path / "project-results"


def test_a_run_of_a_wrong_project_ends_with_its_reason(tmp_path):
    _, _, (end,) = run_of(tmp_path, project_toml(materials={"brick": {"density": -1}}))
    assert "materials.brick.density" in end


def test_a_run_that_is_cancelled_leaves_no_results(tmp_path):
    text = project_toml(verdict={"basis": "asce43-05"}, records={"synthetic": {"count": 30, "duration": "30 s"}})
    found, _, (end,) = run_of(tmp_path, text, cancel=True)
    assert end.startswith("terminated")
    assert not found.folder.exists()


def test_the_report_of_a_run_is_shown_to_who_may_see_the_page(tmp_path):
    pytest.importorskip("viser", reason="needs viser: .venv/serve of the Makefile")
    from assess.page.server import PageServer

    (tmp_path / "report.pdf").write_bytes(b"%PDF-1.7")
    server = PageServer()
    try:
        server.files["/report.pdf"] = tmp_path / "report.pdf"
        server.files["/report.html"] = tmp_path / "report.html"

        def get(path: str, cookie: str = "") -> tuple[http.client.HTTPResponse, bytes]:
            with closing(http.client.HTTPConnection("127.0.0.1", server.port, timeout=10)) as connection:
                connection.request("GET", path, headers={"Cookie": cookie})
                found = connection.getresponse()
                return found, found.read()

        cookie = get(server.address.partition(str(server.port))[2])[0].headers["Set-Cookie"].partition(";")[0]
        assert get("/report.pdf")[0].status == 403
        shown, body = get("/report.pdf", cookie)
        assert (shown.status, shown.headers["Content-Type"], body) == (200, "application/pdf", b"%PDF-1.7")
        assert get("/report.html", cookie)[0].status == 404
    finally:
        server.close()
