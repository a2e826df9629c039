"""The page: a panel beside the drawing, and what happens when something is picked, dragged, typed, written or run.

What is picked and tried is one state for every browser that is open, so that a reload shows the same.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial
from math import degrees, radians
from pathlib import Path
from typing import Any

from assess.codes.question import SOURCES, Missing
from assess.errors import AssessError
from assess.model.candidates import Candidate
from assess.page import words
from assess.page.jobs import ProjectRun
from assess.page.movement import Movement
from assess.page.scene import Drawing
from assess.page.server import PageServer
from assess.project.edited import Number
from assess.project.evidence import meaning_of
from assess.project.key_errors import KeyPath
from assess.project.opened import OpenedProject
from assess.project.trials import ShownMechanism
from assess.study import curves
from assess.workers import Newest
from records.errors import RecordError
from spectra.errors import SpectrumError

STEEPEST = 80.0  # deg
MOST_NUMBERS = 16
ONE_STEP = 0.8  # s: a value that is set again so soon is still being slid or typed
SOURCE_HINT = "“measured: …” or “literature: …”, by whom and when; “assumed: …” is no source."
FRONT_MATTER = ("author", "licence_number", "office", "client", "address", "date", "status")
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
        self._order = opened.rank()
        self._is_sorted = self._is_picked_by_hand = False
        self.picked: str | Candidate = next(iter(self._order), "")
        self._options: dict[str, str | Candidate] = {}
        self._last_moved: tuple[object, float] = (None, 0.0)
        self._done = ""
        self.drawing = Drawing(server.viser, moved=self._dragged, moved_end=self._dragged_end)
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
        self.fault = gui.add_html("")
        self.building = gui.add_html("")
        self.mechanisms = gui.add_dropdown("Mechanism", ("-",), hint="The worst first.")
        self.facts = gui.add_html("")
        self.shown_curve = gui.add_dropdown("Curve", (curves.CAPACITY, curves.PGA, curves.ENVELOPE))
        empty = curves.capacity(None)
        self.curve = gui.add_uplot(empty.data, empty.series, aspect=1.8, scales={"x": {"time": False}})
        self.movement = Movement(
            gui, self.drawing, find=lambda: opened.motion(self.picked) if isinstance(self.picked, str) else None
        )
        with gui.add_folder("Crack"):
            turns = "Of the crack, or of the point it turns about."
            self.elevation = gui.add_number("Elevation [m]", 0.0, step=0.01, hint=turns)
            self.elevation.precision = 3
            towards = "Where positive, the crack falls towards the direction."
            self.angle = gui.add_number("Angle [deg]", 0.0, step=0.5, hint=towards)
            self.angle.precision = 2
            self.weakest = gui.add_button("Find the weakest crack", hint="Tries elevations and angles.")
        with gui.add_folder("Values") as self.numbers:
            pass
        with gui.add_folder("To complete it") as self.missing:
            pass
        with gui.add_folder("Report"):
            self.front = {key: gui.add_text(key, "", hint=meaning_of(f"report.{key}")) for key in FRONT_MATTER}
        with gui.add_folder("Strike out"):
            hint = "Why it cannot occur, by whom and when; a pass depends on it."
            self.reason = gui.add_text("Reason", "", hint=hint)
            self.strike = gui.add_button("Strike out")
        with gui.add_folder("Project file"):
            self.undo, self.write, self.add, again = (
                gui.add_button(label) for label in ("Undo", "Write", "Add what was found", "Read again")
            )
            self.run = gui.add_button("Run")
            self.cancel = gui.add_button("Cancel", disabled=True)
            self.links = gui.add_html("")
        with gui.add_folder("Drawing"):
            self.labels = gui.add_checkbox("Names of parts", False, hint="Those of parts that move are always shown.")
        for button, what in (
            (self.undo, opened.edited.undo), (self.write, opened.write),
            (self.add, opened.add_found), (again, opened.read),
        ):  # fmt: skip
            button.on_click(partial(self._change_file, what))
        self.mechanisms.on_update(lambda event: self._if_by_hand(event, self._pick_by_hand))
        for each in (self.elevation, self.angle):
            each.on_update(lambda event: self._if_by_hand(event, partial(self._typed_crack, event.target)))
        for key, field in self.front.items():
            state = partial(self._state_front, key, field)
            field.on_update(lambda event, state=state: self._if_by_hand(event, state))
        self.strike.on_click(lambda _: self._strike_out())
        self.weakest.on_click(lambda _: self._thorough.ask(self._find_weakest))
        self.shown_curve.on_update(lambda event: self._if_by_hand(event, lambda: self._ask(True)))
        self.labels.on_update(lambda _: self._label_parts())
        self.run.on_click(lambda _: self._start_run())
        self.cancel.on_click(lambda _: None if self._run is None else self._run.cancel())

    def _if_by_hand(self, event: Any, what: Callable[[], None]) -> None:
        """Do something where a browser, and not the page itself, has set a value."""
        if event.client_id is not None:
            with self._told(by_hand=True):
                what()

    @contextmanager
    def _told(self, *, by_hand: bool = False) -> Iterator[None]:
        """Say what is wrong in the block; what was wrong before is left until something is done by hand."""
        if by_hand:
            self.fault.content = self._done = ""
        try:
            yield
        except (AssessError, SpectrumError, RecordError, OSError) as error:
            self.fault.content = words.fault(str(error))
            self.status.content = words.status("stopped, as follows")

    def _pick_by_hand(self) -> None:
        self._is_picked_by_hand = True
        self.pick(self._options[self.mechanisms.value])

    def _show_project(self) -> None:
        with self._turn:
            self._order, self._is_sorted = self.opened.rank(), False
            self.drawing.draw_building(self.opened.parts())
            self._list_mechanisms()
            self._list_missing()
            self._show_picked()

    def start(self) -> None:
        """Find beside the page what takes longer than to show it."""
        self._thorough.ask(self._catch_up)

    def _catch_up(self) -> None:
        """Find what is not known yet: parts and mechanisms, and the outcome with what is tried."""
        opened = self.opened
        if not opened.is_searched:
            with self._told():
                opened.find_others()
            with self._turn:
                self.drawing.draw_building(opened.parts())
                self._label_parts()
                self._list_mechanisms()
        if opened.has_site and not opened.is_decided:
            self._say("finding what a run decides")
            revision = opened.edited.revision
            with self._told():
                opened.find_outcome()
            if opened.edited.revision != revision:
                return  # what is tried now has been asked
            with self._turn:
                self._sort_once()
                self._list_mechanisms()
                self._list_missing()
        with self._told():
            self._recompute(at_rest=True)

    def _sort_once(self) -> None:
        """Put the worst first once the outcome of a project is known, and pick it unless another was picked by hand."""
        if self._is_sorted or not self.opened.is_decided:
            return
        self._order, self._is_sorted = self.opened.rank(), True
        if not self._is_picked_by_hand and not self.opened.edited.changes and self._order:
            self.picked = self._order[0]
            self._list_mechanisms()
            self._show_picked()

    def _list_mechanisms(self) -> None:
        opened = self.opened
        options: dict[str, str | Candidate] = {words.option(name, opened): name for name in self._order}
        sought = self.picked  # one that was found stays until what the file has now is searched
        if not isinstance(sought, str) and not opened.is_searched and sought.name not in self._order:
            options[words.option_found(sought)] = sought
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
        self._show_state()
        self._label_parts()
        cut = opened.cut_of(picked) if isinstance(picked, str) and picked else None
        self.elevation.disabled = cut is None
        self.angle.disabled = cut is None or not cut.turns
        self.weakest.disabled = cut is None or not cut.turns or cut.aside != 0.0
        if isinstance(picked, Candidate):
            parts = [each.name for each in opened.parts()]
            self.drawing.place_plane(None, None)
            self.drawing.place_ties({}, None)
            self.drawing.mark_parts(place for place, name in enumerate(parts) if name in picked.parts)
            self.facts.content = words.candidate(picked)
            return
        self.drawing.mark_parts(())
        if not picked:
            return
        self._recompute()
        result = opened.outline(picked).result
        self.drawing.place_plane(cut, result)
        self.drawing.place_ties(opened.tie_ends(picked), result)
        if cut is not None:
            self._show_crack(cut.point[2], cut.angle)
        if self.shown_curve.value == curves.ENVELOPE:
            self._thorough.ask(self._catch_up)

    def _label_parts(self) -> None:
        picked = self.picked
        moving = self.opened.study.moving.get(picked, ()) if isinstance(picked, str) else picked.parts
        self.drawing.label_parts(self.labels.value or not picked, moving=moving)

    def _show_state(self) -> None:
        """Show the building's verdict, of what it is, and which buttons have something to do."""
        edited = self.opened.edited
        self.building.content = words.building(self.opened)
        self.undo.disabled, self.write.disabled = not edited.can_undo, not edited.changes
        self.add.disabled = not self.opened.proposed
        for key, field in self.front.items():
            field.value = str(edited.tried_value(("report", key)) or "")

    def _show_crack(self, elevation: float, angle: float) -> None:
        self.elevation.value = round(elevation, 3)
        self.angle.value = round(degrees(angle), 2)

    def _recompute(self, *, at_rest: bool = False) -> None:
        """Show the mechanism that is picked with what is tried, unless something else was tried meanwhile."""
        picked, asked, known = self.picked, self._state(), self.opened.decided_of
        if not isinstance(picked, str) or not picked:
            with self._turn:
                self._show_state()
            return
        shown = self.opened.examine(picked)
        curve = self._curve(shown, at_rest=at_rest)
        with self._turn:
            if (self._state(), self.opened.decided_of) == (asked, known):
                self._show(shown, curve)

    def _curve(self, shown: ShownMechanism, *, at_rest: bool) -> curves.Curve | None:
        """Return the curve that is asked for; None where that which is shown stays until the mechanism rests."""
        if self.shown_curve.value == curves.CAPACITY or shown.result is None or shown.fault:
            return curves.capacity(None if shown.fault else shown.result)
        if self.shown_curve.value == curves.PGA:
            return curves.pga(shown.checks)
        return curves.envelope(self.opened.envelope(shown.name)) if at_rest else None

    def _state(self) -> tuple[object, ...]:
        """Return what an answer is of: it is shown only as long as that is the same."""
        return self.picked, self.opened.edited.revision

    def _show(self, shown: ShownMechanism, curve: curves.Curve | None) -> None:
        known = shown.verdict is not None and not (shown.as_typed and shown.verdict.outcome.value == "pass")
        outcome = "fail" if shown.fault else shown.verdict.outcome.value if known and shown.verdict else "not known"
        with self.server.viser.atomic():
            self.drawing.draw_mechanism(shown, outcome=outcome)
            self.movement.show(shown.mechanism, shown.result, self._state())
            self.facts.content = words.mechanism(self.opened, shown)
            self._show_state()
            if curve is not None:
                self.curve.series, self.curve.data = curve.series, curve.data
        waits = self.opened.has_site and not self.opened.is_decided and not shown.fault
        undecided = "not decided" if self.opened.why_undecided else "finding what a run decides"
        self._say(undecided if waits else "ready")

    def _say(self, text: str) -> None:
        """Say what the page is doing, after what was done by hand last."""
        self.status.content = words.status("; ".join(filter(None, (self._done, self.opened.edited.outlived, text))))

    def _goes_on(self, moved: object) -> bool:
        """Return whether what is moved now was moved just before: it is then one step of undo."""
        (last, then), now = self._last_moved, time.monotonic()
        self._last_moved = moved, now
        return last is moved and now - then < ONE_STEP

    def _dragged(self, point: Sequence[float], angle: float, released: bool) -> None:
        if isinstance(self.picked, str):
            self._drag(partial(self.opened.move_cut, self.picked, point, angle), self.drawing, released)
            self._show_crack(point[2], angle)

    def _dragged_end(self, key: KeyPath, at: Sequence[float], released: bool) -> None:
        self._drag(partial(self.opened.move_end, key, at), key, released)

    def _drag(self, move: Callable[..., None], what: object, released: bool) -> None:
        """Try where something is dragged to; from when it is taken until it is let go this is one step."""
        self.fault.content = self._done = ""
        goes_on = self._last_moved[0] == what
        self._last_moved = (None if released else what), time.monotonic()
        move(goes_on=goes_on)
        self._ask(released)

    def _typed_crack(self, field: Any) -> None:
        """Try the elevation or the angle that was typed, and leave the other as it is."""
        cut = self.opened.cut_of(self.picked) if isinstance(self.picked, str) else None
        if cut is not None and isinstance(self.picked, str):
            x, y, z = cut.point
            point = (x, y, self.elevation.value if field is self.elevation else z)
            if field is self.angle and abs(self.angle.value) > STEEPEST:
                raise AssessError(f"angle: {self.angle.value:g} deg was not tried; give -{STEEPEST:g} to {STEEPEST:g}")
            angle = radians(self.angle.value) if field is self.angle else cut.angle
            self.opened.move_cut(self.picked, point, angle, goes_on=self._goes_on(field))
            self.drawing.move_plane(replace(cut, point=point, angle=angle))
            self._ask(True)

    def _strike_out(self) -> None:
        """Try the project without the mechanism that is picked."""
        name = self.picked if isinstance(self.picked, str) else self.picked.name
        with self._told(by_hand=True), self._turn:
            self._last_moved = (None, 0.0)
            self.opened.edited.strike_out(name, self.reason.value)
            self.reason.value, self._done = "", f"{name} is struck out"
            self._show_picked()
            self.start()

    def _find_weakest(self) -> None:
        """Find the weakest crack of the mechanism that is picked, and try it."""
        picked, asked = self.picked, self._state()
        if not isinstance(picked, str):
            return
        with self._told(by_hand=True):
            found = self.opened.find_weakest_crack(picked, self._tell_search)
            with self._turn:
                if self._state() != asked:
                    return
                self._last_moved, before = (None, 0.0), self._margin()
                self.opened.move_cut(picked, found.cut.point, found.cut.angle)
                revision = self.opened.edited.revision
                self._show_picked()
            self._done = words.weakest(found)
            self._catch_up()
            if (rise := words.rise(before, self._margin())) and self._state()[1] == revision:
                self._done = f"{self._done}; {rise}"
                self._say("ready")

    def _margin(self) -> float | None:
        """Return what the mechanism that is picked holds over the action; None where that is not decided."""
        known = self.opened.verdict if self.opened.is_decided else None
        of = {} if known is None else {each.mechanism: each.margin for each in known.mechanisms}
        return of.get(self.picked) if isinstance(self.picked, str) else None

    def _tell_search(self, tried: int) -> None:
        self.status.content = words.status(f"looking for the weakest crack: {tried} tried")

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
                handle = self._gui.add_number(label, each.value, step=abs(each.value) / 100.0 or 0.01)
                handle.precision = each.decimals
                handle.on_update(partial(self._moved_number, each, handle))
                self._of_numbers.append(handle)

    def _moved_number(self, number: Number, handle: Any, event: Any) -> None:
        def change() -> None:
            value = number.file_value(handle.value)
            self.opened.edited.change({number.path: value}, goes_on=self._goes_on(handle))
            self._ask(True)

        self._if_by_hand(event, change)

    def _list_missing(self) -> None:
        _remove(self._of_missing)
        with self.missing:
            for each in self.opened.missing:
                self._of_missing.append(self._gui.add_html(words.missing_input(each)))
                if each.toml:
                    field = self._gui.add_text("TOML", each.toml, multiline="\n" in each.toml)
                    source = None if each.key == SOURCES else self._gui.add_text("Source", "", hint=SOURCE_HINT)
                    button = self._gui.add_button("Try it")
                    button.on_click(partial(self._add_lines, each, field, source))
                    self._of_missing += [made for made in (field, source, button) if made is not None]

    def _add_lines(self, missing: Missing, field: Any, source: Any, _: Any) -> None:
        with self._told(by_hand=True):
            self._last_moved = (None, 0.0)
            self.opened.edited.add_lines(missing, field.value, source=source.value.strip() if source else "")
            self._ask(True)

    def _state_front(self, key: str, field: Any) -> None:
        self.opened.state_front(key, field.value)
        self._ask(False)

    def _change_file(self, what: Callable[[], str], _: Any) -> None:
        with self._told(by_hand=True), self._turn:
            self._last_moved = (None, 0.0)
            outlived = self.opened.edited.outlived
            self._done = what()
            self._done += f"; {outlived}" if outlived and self._done.startswith("written") else ""
            self._is_picked_by_hand = True
            if self.opened.edited.project is not self.opened.built_of:
                self.opened.refresh()
            if self.opened.decision is None:
                self._show_project()
            else:
                self._show_picked()
            self.start()

    def _start_run(self) -> None:
        with self._told(by_hand=True):
            if self.opened.edited.changes:
                raise AssessError("values are tried that are not written: write them, or undo, and run then")
            self.run.disabled, self.cancel.disabled = True, False
            self._run = ProjectRun(self.opened.edited.project.path, tell=self._tell_run, done=self._end_run)

    def _tell_run(self, line: str) -> None:
        self.status.content = words.status(f"run: {line}")

    def _end_run(self, fault: str) -> None:
        assert self._run is not None
        self.run.disabled, self.cancel.disabled = False, True
        self.status.content = words.status(f"run: {fault or 'done'}")
        if fault:
            self.fault.content = words.fault(f"run: {fault}")
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
    server = PageServer(port=port, label=(project.parent if project.is_file() else project).resolve().name)
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


def _remove(handles: list[Any]) -> None:
    for each in handles:
        with suppress(KeyError):
            each.remove()
    handles.clear()
