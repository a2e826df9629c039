"""What moves on the page: the mechanism at rest, displaced, or rocking in true time as the governing record plays."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from html import escape
from typing import Any

from assess.errors import AssessError
from assess.mechanisms.mechanism import Mechanism
from assess.page.scene import Drawing
from assess.page.words import STYLE
from assess.results import MechanismResult
from assess.study.rocking_motion import RockingMotion, block_places
from records.errors import RecordError
from spectra.errors import SpectrumError

AT_REST, DISPLACED, ROCKING = POSITIONS = ("at rest", "displaced", "rocking")
DRAWN = {"as it is": 1.0, "x 5": 5.0, "x 20": 20.0}  # factors on rotations
FRAME = 1.0 / 30.0  # s
SAID_EVERY = 0.5  # s
NO_HISTORY = "no history of it is answered, so none is played"


class Movement:
    """The position of the mechanism that is picked, and the player of its history.

    find : returns how it moves under the record that governs, with what is tried; None where no history is answered
    """

    def __init__(self, gui: Any, drawing: Drawing, *, find: Callable[[], RockingMotion | None]) -> None:
        self._drawing, self._find = drawing, find
        self._mechanism: Mechanism | None = None
        self._displaced = 0.0
        self._state: object = None
        self._thread: threading.Thread | None = None
        self._stopped, self._drawing_frame = threading.Event(), threading.Lock()
        with gui.add_folder("Movement"):
            self.position = gui.add_dropdown("Position", POSITIONS, hint="Rocking plays the record that governs.")
            self.drawn = gui.add_dropdown("Rotation drawn", tuple(DRAWN), hint="What is shown, over what is computed.")
            self.button = gui.add_button("Play")
            self.said = gui.add_html("")
        for each in (self.position, self.drawn):
            each.on_update(lambda event: None if event.client_id is None else self._place())
        self.button.on_click(lambda _: self.play() if self._thread is None else self.rest())

    def show(self, mechanism: Mechanism | None, result: MechanismResult | None, state: object) -> None:
        """Put a mechanism in its position; what plays goes on as long as the state that it is of is the same."""
        if state == self._state and self._thread is not None:
            return
        drawn = result is not None and result.view is not None
        self._state, self._mechanism = state, mechanism if drawn else None
        self._displaced = 0.0 if result is None else result.drawing.displaced.rotation_rad
        if self.position.value == ROCKING:
            self.position.value = AT_REST
        self._place()

    def play(self) -> None:
        """Play the history that governs, from its beginning."""
        self.stop()
        self.position.value, self.button.label = ROCKING, "Stop"
        self._say("finding the record that governs")
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._play, args=(self._stopped,), name="rocking", daemon=True)
        self._thread.start()

    def rest(self) -> None:
        """Stop what plays, and put the mechanism at rest."""
        self.position.value = AT_REST
        self._place()

    def stop(self) -> None:
        """Stop what plays: no frame of it is drawn from now on."""
        with self._drawing_frame:
            self._stopped.set()
        self._thread, self.button.label = None, "Play"

    def wait(self, seconds: float) -> None:
        """Wait until what plays is over."""
        if self._thread is not None:
            self._thread.join(seconds)

    def _place(self) -> None:
        if self.position.value == ROCKING:
            if self._thread is None:
                self.play()
            return
        self.stop()
        self._say("")
        self._turn(self._mechanism, self._displaced if self.position.value == DISPLACED else 0.0)

    def _turn(self, mechanism: Mechanism | None, rotation: float) -> None:
        """Draw a mechanism after a rotation [rad], times the factor on what is drawn."""
        factor = DRAWN[self.drawn.value]
        self._drawing.place_blocks(
            () if mechanism is None or rotation == 0.0 else block_places(mechanism, factor * rotation)
        )

    def _play(self, stopped: threading.Event) -> None:
        try:
            motion = self._find()
            said = NO_HISTORY if motion is None else self._play_motion(motion, stopped)
        except (AssessError, SpectrumError, RecordError) as error:
            said = str(error)
        if not stopped.is_set():
            self._thread = None
            self.button.label = "Play"
            self._say(said)

    def _play_motion(self, motion: RockingMotion, stopped: threading.Event) -> str:
        """Play a history by the clock, in which a frame that is late is left out; return what it is and how it ends."""
        of, begun, next_said = motion.title, time.monotonic(), 0.0
        while not stopped.wait(FRAME):
            now = time.monotonic() - begun
            with self._drawing_frame:
                if not stopped.is_set():
                    self._turn(motion.mechanism, motion.rotation_at(min(now, motion.duration)))
            if now >= motion.duration:
                break
            if now >= next_said:
                drawn = "" if DRAWN[self.drawn.value] == 1.0 else f"; rotations drawn {self.drawn.value}"
                self._say(f"{of}: {now:.1f} of {motion.duration:.1f} s{drawn}")
                next_said = now + SAID_EVERY
        return f"{of}: {motion.ending} {motion.duration:.1f} s"

    def _say(self, text: str) -> None:
        self.said.content = f'<p style="{STYLE}">{escape(text)}</p>' if text else ""
