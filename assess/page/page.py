"""The page: a panel beside the drawing, and what happens when something is picked, dragged, typed, written or run.

What is picked and tried is one state for every browser that is open, so that a reload shows the same.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from math import degrees, radians
from pathlib import Path
from typing import Any

import numpy as np

from assess.codes.question import Missing
from assess.errors import AssessError
from assess.model.candidates import Candidate
from assess.page import words
from assess.page.jobs import Newest, ProjectRun
from assess.page.movement import Movement
from assess.page.opened import Number, OpenedProject, ShownMechanism
from assess.page.scene import Drawing
from assess.page.server import PageServer
from assess.results import MechanismResult
from records.errors import RecordError
from spectra.errors import SpectrumError

STEEPEST = 80.0  # deg
MOST_NUMBERS = 16
RANGE = (0.5, 1.5)  # of the value in the file
FILES = (("report.pdf", "report"), ("report.html", "report as a page"), ("results.json", "results"))


class Page:
    """The page of a project that is open."""

    def __init__(self, server: PageServer, opened: OpenedProject) -> None:
        self.opened, self.server, self._gui = opened, server, server.viser.gui
        self._turn = threading.RLock()
        self._quick, self._thorough = Newest("statics"), Newest("outcome")
        self._run: ProjectRun | None = None
        self._of_numbers: list[Any] = []
        self._of_missing: list[Any] = []
        self.picked: str | Candidate = opened.rank()[0] if opened.rank() else ""
        self._options: dict[str, str | Candidate] = {}
        self.drawing = Drawing(server.viser, moved=self._dragged)
        self._lay_out()
        self._show_project()

    def close(self) -> None:
        """End what is being done for the page."""
        self.movement.stop()
        self._quick.close()
        self._thorough.close()
        if self._run is not None:
            self._run.cancel()

    def wait(self, seconds: float) -> bool:
        """Wait until what was asked is shown; return whether it is."""
        return self._quick.wait(seconds) and self._thorough.wait(seconds) and self._quick.wait(seconds)

    def pick(self, chosen: str | Candidate) -> None:
        """Show a mechanism of the file, by its name, or one that was found."""
        with self._turn:
            self.picked = chosen
            self.mechanisms.value = next(
                text for text, each in self._options.items() if each is chosen or each == chosen
            )
            self._show_picked()

    def _lay_out(self) -> None:
        gui, opened = self._gui, self.opened
        gui.set_panel_label(opened.title)
        gui.configure_theme(control_width="large", show_logo=False, show_share_button=False)
        gui.main_panel.dock_right()
        self.status = gui.add_html(words.status("reading"))
        self.building = gui.add_html("")
        self.mechanisms = gui.add_dropdown("Mechanism", ("-",), hint="The worst first.")
        self.facts = gui.add_html("")
        empty = np.zeros(2)
        line = {"label": "restoring moment [kN m]", "stroke": "#0072b2", "width": 2}
        self.curve = gui.add_uplot(
            (empty, empty), ({"label": "rotation [rad]"}, line), title="Capacity curve", aspect=1.8,
            scales={"x": {"time": False}},
        )  # fmt: skip
        self.movement = Movement(
            gui, self.drawing, find=lambda: opened.motion(self.picked) if isinstance(self.picked, str) else None
        )
        with gui.add_folder("Crack"):
            self.elevation = gui.add_number(
                "Elevation [m]", 0.0, step=0.01, hint="Of the crack, or of the point it turns about."
            )
            self.angle = gui.add_slider(
                "Angle [deg]",
                -STEEPEST,
                STEEPEST,
                0.5,
                0.0,
                hint="Where positive, the crack falls towards the direction.",
            )
        with gui.add_folder("Values", expand_by_default=False) as self.numbers:
            pass
        with gui.add_folder("To complete it", expand_by_default=False) as self.missing:
            pass
        with gui.add_folder("Project file"):
            for label, what in (
                ("Undo", opened.undo), ("Write", opened.write),
                ("Add what was found", opened.add_found), ("Read again", self._read_again),
            ):  # fmt: skip
                gui.add_button(label).on_click(partial(self._change_file, what))
            self.run = gui.add_button("Run")
            self.cancel = gui.add_button("Cancel", disabled=True)
            self.links = gui.add_html("")
        with gui.add_folder("Drawing", expand_by_default=False):
            labels = gui.add_checkbox("Names of parts", True)
        self.mechanisms.on_update(
            lambda event: self._if_by_hand(event, lambda: self.pick(self._options[self.mechanisms.value]))
        )
        for each in (self.elevation, self.angle):
            each.on_update(lambda event: self._if_by_hand(event, self._typed_crack))
        labels.on_update(lambda _: self.drawing.label_parts(labels.value))
        self.run.on_click(lambda _: self._start_run())
        self.cancel.on_click(lambda _: None if self._run is None else self._run.cancel())

    def _if_by_hand(self, event: Any, what: Callable[[], None]) -> None:
        """Do something where a browser, and not the page itself, has set a value."""
        if event.client_id is not None:
            with self._told():
                what()

    def _told(self) -> _Told:
        return _Told(self.status)

    def _show_project(self) -> None:
        with self._turn:
            self.drawing.draw_building(self.opened.parts())
            self._list_mechanisms()
            self._show_picked()

    def start(self) -> None:
        """Find beside the page what takes longer than to show it."""
        self._thorough.ask(self._catch_up)

    def _catch_up(self) -> None:
        """Find what is not known yet: parts and mechanisms, the outcome, and that of what is tried."""
        opened = self.opened
        with self._told():
            if not opened.is_searched:
                opened.find_others()
                with self._turn:
                    self.drawing.draw_building(opened.parts())
                    self._list_mechanisms()
            if opened.verdict is None and opened.study.spectrum is not None:
                opened.find_outcome()
                with self._turn:
                    self._list_mechanisms()
                    self._list_missing()
            self._recompute(histories=opened.by_histories and opened.study.spectrum is not None)

    def _list_mechanisms(self) -> None:
        opened, ranked = self.opened, self.opened.rank()
        options: dict[str, str | Candidate] = {
            words.option(number, name, opened, opened.outline(name)): name
            for number, name in enumerate(ranked, start=1)
        }
        options |= {words.option_found(each): each for each in opened.proposed}
        names = [each if isinstance(each, str) else each.name for each in options.values()]
        self._options = options or {"no mechanism": ""}
        picked = self.picked if isinstance(self.picked, str) else self.picked.name
        place = names.index(picked) if picked in names else 0
        self.picked = list(self._options.values())[place]
        self.mechanisms.options = tuple(self._options)
        self.mechanisms.value = list(self._options)[place]

    def _show_picked(self) -> None:
        opened, picked = self.opened, self.picked
        self._list_numbers()
        if isinstance(picked, Candidate):
            parts = [each.name for each in opened.parts()]
            self.drawing.place_plane(None, None)
            self.drawing.mark_parts(place for place, name in enumerate(parts) if name in picked.parts)
            self.facts.content = words.candidate(picked)
            self.elevation.disabled = self.angle.disabled = True
            return
        self.drawing.mark_parts(())
        if not picked:
            return
        self._recompute()
        cut = opened.cut_of(picked)
        self.drawing.place_plane(cut, opened.outline(picked).result)
        for each in (self.elevation, self.angle):
            each.disabled = cut is None
        if cut is not None:
            self._show_crack(cut.point[2], cut.angle)

    def _show_crack(self, elevation: float, angle: float) -> None:
        self.elevation.value = round(elevation, 3)
        self.angle.value = float(np.clip(degrees(angle), -STEEPEST, STEEPEST))

    def _recompute(self, *, histories: bool = False) -> None:
        """Show the mechanism that is picked with what is tried; with histories if nothing else was tried meanwhile."""
        picked, asked = self.picked, self._state()
        if not isinstance(picked, str) or not picked:
            return
        shown = self.opened.examine(picked, histories=histories)
        with self._turn:
            if self._state() == asked:
                self._show(shown)

    def _state(self) -> tuple[object, ...]:
        """Return what an answer is of: it is shown only as long as that is the same."""
        return self.picked, self.opened.changes, id(self.opened.project)

    def _show(self, shown: ShownMechanism) -> None:
        opened = self.opened
        outcome = "fail" if shown.fault else shown.verdict.outcome.value if shown.verdict else "not known"
        with self.server.viser.atomic():
            self.drawing.draw_mechanism(shown, outcome=outcome)
            self.movement.show(shown.mechanism, shown.result, self._state())
            self.facts.content = words.mechanism(opened, shown)
            self.building.content = words.building(
                opened.verdict, has_site=opened.study.spectrum is not None, changed=len(opened.changes)
            )
            if shown.result is not None:
                self.curve.data = _curve(shown.result)
        self.status.content = words.status(shown.fault or "ready")

    def _dragged(self, point: Sequence[float], angle: float, released: bool) -> None:
        if isinstance(self.picked, str):
            self.opened.move_cut(self.picked, point, angle)
            self._show_crack(point[2], angle)
            self._ask(released)

    def _typed_crack(self) -> None:
        cut = self.opened.cut_of(self.picked) if isinstance(self.picked, str) else None
        if cut is not None and isinstance(self.picked, str):
            angle = radians(self.angle.value)
            self.opened.move_cut(self.picked, (*cut.point[:2], self.elevation.value), angle)
            self.drawing.move_plane((*cut.point[:2], self.elevation.value), angle)
            self._ask(True)

    def _ask(self, rests: bool) -> None:
        """Show what is tried, and where it rests find the outcome too."""
        self._quick.ask(self._recompute_told)
        if rests:
            self._thorough.ask(self._catch_up)

    def _recompute_told(self) -> None:
        with self._told():
            self._recompute()

    def _list_numbers(self) -> None:
        _remove(self._of_numbers)
        picked = self.picked
        if not isinstance(picked, str) or not picked:
            return
        with self.numbers:
            for each in self.opened.numbers(picked)[:MOST_NUMBERS]:
                label = f"{each.text} [{each.unit or '-'}]"
                if each.value > 0.0:
                    low, high = (share * each.value for share in RANGE)
                    handle = self._gui.add_slider(label, low, high, each.value / 100.0, each.value)
                else:
                    handle = self._gui.add_number(label, each.value)
                handle.on_update(partial(self._moved_number, each, handle))
                self._of_numbers.append(handle)

    def _moved_number(self, number: Number, handle: Any, event: Any) -> None:
        def change() -> None:
            self.opened.change({number.path: number.file_value(handle.value)})
            self._ask(True)

        self._if_by_hand(event, change)

    def _list_missing(self) -> None:
        _remove(self._of_missing)
        found = () if self.opened.verdict is None else self.opened.verdict.missing
        with self.missing:
            for each in found:
                self._of_missing.append(self._gui.add_html(words.status(f"{each.key}: {each.text}")))
                if each.toml:
                    field = self._gui.add_text("TOML", each.toml, multiline="\n" in each.toml)
                    button = self._gui.add_button("Try it")
                    button.on_click(partial(self._add_lines, each, field))
                    self._of_missing += [field, button]

    def _add_lines(self, missing: Missing, field: Any, _: Any) -> None:
        with self._told():
            self.opened.add_lines(missing, field.value)
            self._ask(True)

    def _change_file(self, what: Callable[[], str], _: Any) -> None:
        with self._told() as told, self._turn:
            before = self.opened.project
            said = what()
            if self.opened.project is not before:
                self._show_project()
                self.start()
            else:
                self._show_picked()
            told.content = said

    def _read_again(self) -> str:
        self.opened.read()
        return "read again"

    def _start_run(self) -> None:
        with self._told():
            if self.opened.changes:
                raise AssessError("values are tried that are not written: write them, or undo, and run then")
            self.run.disabled, self.cancel.disabled = True, False
            self._run = ProjectRun(self.opened.project.path, tell=self._tell_run, done=self._end_run)

    def _tell_run(self, line: str) -> None:
        self.status.content = words.status(f"run: {line}")

    def _end_run(self, fault: str) -> None:
        assert self._run is not None
        self.run.disabled, self.cancel.disabled = False, True
        self.status.content = words.status(f"run: {fault or 'done'}")
        if fault:
            return
        found = [(name, text) for name, text in FILES if (self._run.folder / name).is_file()]
        self.server.files.update({f"/{name}": self._run.folder / name for name, _ in found})
        self.links.content = words.links((f"/{name}", text) for name, text in found)


@contextmanager
def open_page(project: Path, *, port: int = 0, tell: Callable[[str], object] = len) -> Iterator[Page]:
    """Serve the page of a project during the block.

    Parameters
    ----------
    project : its file or folder
    port : of the address; any free one where 0
    tell : called with the address, before anything is read that may keep standard output for itself

    Raises
    ------
    AssessError, SpectrumError or RecordError : the project cannot be read, or the page not be served
    """
    server = PageServer(port=port)
    try:
        page = Page(server, OpenedProject(project))
        try:
            tell(server.address)
            page.start()
            yield page
        finally:
            page.close()
    finally:
        server.close()


class _Told:
    """Says on the page what is wrong in the block, in place of a traceback."""

    def __init__(self, status: Any) -> None:
        self._status, self.content = status, ""

    def __enter__(self) -> _Told:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: object) -> bool:
        told = isinstance(error, AssessError | SpectrumError | RecordError | OSError)
        if told or (error is None and self.content):
            self._status.content = words.status(str(error) if told else self.content)
        return told


def _remove(handles: list[Any]) -> None:
    for each in handles:
        with suppress(KeyError):
            each.remove()
    handles.clear()


def _curve(result: MechanismResult) -> tuple[np.ndarray, np.ndarray]:
    """Return rotation [rad] and restoring moment [kN m] of both branches, the negative one mirrored back."""
    curves = [(1.0, result.curve.positive)] + ([] if result.curve.negative is None else [(-1.0, result.curve.negative)])
    rotation = np.concatenate([sign * np.array(each.rotation_rad) for sign, each in reversed(curves)])
    moment = np.concatenate([sign * np.array(each.restoring_n_m) / 1e3 for sign, each in reversed(curves)])
    order = np.argsort(rotation, kind="stable")
    return rotation[order], moment[order]
