"""Kill `assess run`, `fragility`, `verify` and `records index --jobs 2` many times, at random and at aimed moments.

python tools/kill/study.py [KILLS] [SEED]: 120 and 1 if absent; a third are of runs, a third of indexes. After each kill
no process may be left, and the folder must hold, after the next command, all of the old outputs or all of the new byte
for byte; the catalogue must become what an index that is not killed makes. Ends with 1 where anything is lost.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from assess.outputs.lock import LOCK
from assess.outputs.manifest import MANIFEST, RECORDS
from assess.outputs.writing import output_folder, recover_for_reading
from records.catalogue import catalogue_candidates, open_catalogue

STRIKE = Path(__file__).with_name("strike.py")
SIGNALS = (signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
WALL = """
[materials.brick]
density = 1800
[bodies.wall]
material = "brick"
box = {{ thickness = 0.6, length = 3.0, height = {height} }}
[mechanisms.wall-{height}]
kind = "single-block"
blocks = ["wall"]
restitution = 0.9
[site.spectrum]
code = "asce7-16"
s_ds = "0.5 g"
s_d1 = "0.2 g"
t_l = "6 s"
[analysis]
procedures = ["asce43-05-spectrum"]
"""
STUDY = """
[mechanisms.parapet]
kind = "equivalent-block"
p = {height}
uplift = 0.2
radius = 0.6
[records]
synthetic = {{ count = 2, duration = "20 s", seed = 1 }}
[site.spectrum]
code = "asce7-16"
s_ds = "0.5 g"
s_d1 = "0.2 g"
t_l = "6 s"
[analysis.fragility]
measures = ["pga"]
states = ["rocking", "overturning"]
samples = 8
draws = 100
"""
WRITTEN = {"run": WALL, "fragility": STUDY, "verify": ""}  # projects of the commands that are killed
CASES = {4: "housner_1963", 5: "oppenheim_1992"}  # of `verify`
FILES = 60  # of records
Outputs = dict[str, str]


@dataclass
class Count:
    """What became of the kills."""

    ends: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Blow:
    """A kill: the signal, and the step it comes at, or the seconds after which it comes if that is 0."""

    number: int
    at: int
    after: float

    def __str__(self) -> str:
        when = f"step {self.at}" if self.at else f"{self.after:.2f} s"
        return f"{signal.Signals(self.number).name} at {when}"


def say(line: str) -> None:
    """Print a line at once."""
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


def struck(arguments: list[str], folder: Path, blow: Blow | None) -> tuple[int, str, float]:
    """Run a command in a session of its own until it ends, by the blow or by itself: exit code, stderr, seconds."""
    at, number = (blow.at, int(blow.number)) if blow else (0, 0)
    command = [sys.executable, str(STRIKE), str(folder), str(at), str(number), *arguments]
    start = time.monotonic()
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as process:
        if blow and not blow.at:
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(blow.after)
            if process.poll() is None:
                if blow.number == signal.SIGINT:  # as a terminal does
                    os.killpg(process.pid, blow.number)
                else:
                    process.send_signal(blow.number)
        _, told = process.communicate(timeout=300)
    left = orphans(process.pid)
    took = time.monotonic() - start
    return process.returncode, told if not left else f"{told}ORPHANS {left}", took


def orphans(session: int) -> list[int]:
    """Processes of a session that are left 5 s after it should have ended."""
    deadline = time.monotonic() + 5.0
    while (left := [*members(session)]) and time.monotonic() < deadline:
        time.sleep(0.05)
    return left


def members(session: int) -> Iterator[int]:
    """Processes of a session that have not ended."""
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            words = stat.read_text().rpartition(")")[2].split()
            if int(words[3]) == session and words[0] != "Z":
                yield int(stat.parent.name)


def judged(count: Count, what: str, blow: Blow, code: int, told: str) -> None:
    """Count how a killed command ended, and what is wrong with how it did."""
    orderly = blow.number != signal.SIGKILL
    count.ends[f"{what}, {signal.Signals(blow.number).name}, {'aimed' if blow.at else 'random'}: {code}"] += 1
    if "ORPHANS" in told:
        count.faults.append(f"{what} {blow}: {told[-200:]}")
    if "Traceback" in told or (orderly and code == 128 + blow.number and told.count("\n") != 1):
        count.faults.append(f"{what} {blow}: says {told[-500:]!r}")
    if code not in (0, 1, 3, -signal.SIGKILL, 128 + blow.number, -blow.number):
        count.faults.append(f"{what} {blow}: ends with {code}: {told[-300:]!r}")


def outputs(folder: Path) -> Outputs:
    """The SHA-256 of every file of the outputs, but what the program keeps for itself."""
    files = (path for path in folder.rglob("*") if path.is_file() and path.name not in (LOCK, MANIFEST))
    return {
        path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in files
        if ".assess-partial-" not in path.as_posix()
    }


def kill_writers(what: str, place: Path, kills: int, dice: random.Random, count: Count) -> None:
    """Kill a command that replaces its outputs of one wall, or case, by those of another."""
    whole, out, asked = list[Outputs](), place / what, list[list[str]]()
    out.mkdir()
    (out / "mine.txt").write_text("mine")
    for height in (4, 5):
        project = place / f"{what}-{height}.toml"
        project.write_text(WRITTEN[what].format(height=height))
        asked.append([what, CASES[height] if what == "verify" else str(project), "-o", str(out), "--jobs", "2"])
        whole.append({})
    steps = seconds = 0.0
    for turn in (0, 1, 0):
        code, told, seconds = struck(asked[turn], out, None)
        assert code in (0, 1, 3), told
        steps = int(told.split()[-2])
        whole[turn] = outputs(out)
    say(f"{what}: {len(whole[0])} files, {steps:.0f} steps, {seconds:.1f} s")
    for number in range(kills):
        now = 0 if outputs(out) == whole[0] else 1
        near_the_end = dice.randrange(max(1, int(steps) - 4 * len(whole[0]) - 20), int(steps) + 1)
        aimed = (0, near_the_end, near_the_end, dice.randrange(1, int(steps) + 1))[number % 4]
        blow = Blow(dice.choice(SIGNALS), aimed, dice.uniform(0.1, 1.1 * seconds))
        code, told, _ = struck(asked[1 - now], out, blow)
        judged(count, what, blow, code, told)
        recover_for_reading(out, tell=lambda _: None)
        found = outputs(out)
        if found not in whole:
            count.faults.append(f"{what} {blow}: neither the old outputs nor the new: {sorted(found)}")
        count.ends[f"{what}: {'old' if found == whole[now] else 'new'} outputs after it"] += 1
        with output_folder(out, command="the study", owner=RECORDS):
            pass  # a command that writes clears what is left
        if left := [path.name for path in out.iterdir() if path.name.startswith(".assess") and path.name != MANIFEST]:
            count.faults.append(f"{what} {blow}: left behind: {left}")
        say(f"{number + 1}: {blow}: ended with {code}")


def kill_indexes(place: Path, kills: int, dice: random.Random, count: Count) -> None:
    """Kill indexes of a folder that has none yet, by two processes."""
    folder, seconds = place / "records", 0.0
    folder.mkdir()
    for number in range(FILES):
        values = np.random.default_rng(number).normal(0.0, 0.1, 3000) * np.hanning(3000)
        head = f"PEER\nEvent {number}, 1/1/2000, Station, 0\nACCELERATION TIME SERIES IN UNITS OF G\n"
        rows = "".join(f" {value:.7E}\n" for value in values)
        (folder / f"r{number:03d}.AT2").write_text(f"{head}NPTS= 3000, DT= .0100 SEC\n{rows}")
    arguments = ["records", "index", str(folder), "--jobs", "2", "--catalogue"]
    code, told, seconds = struck([*arguments, str(place / "whole.sqlite")], folder, None)
    assert code == 0, told
    expected = listed(place / "whole.sqlite")
    say(f"an index: {len(expected)} records, {seconds:.1f} s")
    for number in range(kills):
        catalogue = place / f"{number}.sqlite"
        aimed = dice.randrange(1, FILES // 5 + 1) if number % 2 else 0
        blow = Blow(dice.choice(SIGNALS), aimed, dice.uniform(0.3, 1.1 * seconds))
        code, told, _ = struck([*arguments, str(catalogue)], folder, blow)
        judged(count, "index", blow, code, told)
        again, said, _ = struck([*arguments, str(catalogue)], folder, None)
        if again != 0 or listed(catalogue) != expected:
            count.faults.append(f"index {blow}: the next ends with {again} and another catalogue: {said[-300:]!r}")
        say(f"{number + 1}: {blow}: ended with {code}")


def listed(catalogue: Path) -> dict[str, tuple[float, ...]]:
    """The measures and ordinates of every record of a catalogue."""
    with open_catalogue(catalogue) as connection:
        return {
            each.path: (*each.measures.values(), *each.spectrum.tolist()) for each in catalogue_candidates(connection)
        }


def main(kills: int = 120, seed: int = 1) -> int:
    """Kill, print the counts, and say whether anything was lost."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background it is ignored, by children too
    count, dice = Count(), random.Random(seed)
    with TemporaryDirectory(prefix="assess-kill-") as place:
        kill_writers("run", Path(place), kills // 3, dice, count)
        kill_writers("fragility", Path(place), kills // 6, dice, count)
        kill_writers("verify", Path(place), kills // 6, dice, count)
        kill_indexes(Path(place), kills - 2 * (kills // 3), dice, count)
    say("\n".join(f"{number:5}  {end}" for end, number in sorted(count.ends.items())))
    say("\n".join(count.faults))
    say(f"{kills} kills, {len(count.faults)} faults")
    return 1 if count.faults else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3])))
