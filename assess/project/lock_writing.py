"""The lock of a suite as it is: files, factors and target, as text and as a file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from scipy.constants import g

from assess.errors import OutputError
from assess.outputs.single import replace_file
from assess.project.file_digests import file_sha256
from assess.project.suite_lock import (
    HEAD,
    LockedArtificial,
    LockedChoice,
    LockedRecord,
    LockedTarget,
    is_replaceable,
    lock_text,
)
from assess.study.motions import ScaledRecord
from assess.study.study import Artificial, Fitting
from records.candidates import Candidate
from records.fingerprints import samples_sha256, target_mark
from records.formats.header_overrides import NO_OVERRIDES, HeaderOverrides
from records.paths import relative_path
from records.reading import read_with
from records.record import Record
from records.selection import ScaleTo
from spectra.spectrum import Spectrum

DIGITS = 12  # after the point, of a peak ground acceleration in g
COMMAND = "records select --lock"


def suite_text(
    motions: Sequence[ScaledRecord],
    spectrum: Spectrum,
    fitting: Fitting,
    *,
    place: Path,
    folder: Path,
    scale_to: ScaleTo,
    further_factor: float = 1.0,
    overrides: HeaderOverrides = NO_OVERRIDES,
    recipe: tuple[Artificial, tuple[float, float]] | None = None,
) -> str:
    """Return the text of the lock of a suite.

    Parameters
    ----------
    motions : the suite, as scaled to the spectrum
    spectrum : the target
    fitting : how the records were chosen and scaled
    place : folder of the lock
    folder : that the paths of the records are relative to
    scale_to, further_factor : as in [records]
    overrides : what files do not state themselves, where the records were not selected out of a catalogue
    recipe : of the artificial records, with the range of periods that they fit [s]
    """
    mark = target_mark(spectrum)
    recorded = [motion for motion in motions if not motion.record.artificial]
    chosen = () if fitting.selection is None else fitting.selection.choices
    candidates: Sequence[Candidate | None] = [one for choice in chosen for one in choice.components]
    numbers = dict(fitting.nga)
    records = [
        _locked(
            motion,
            folder / motion.record.path,
            place=place,
            overrides=overrides if candidate is None else candidate.overrides,
            nga=numbers.get(motion.record.id),
        )
        for motion, candidate in zip(recorded, candidates or [None] * len(recorded), strict=True)
    ]
    return lock_text(
        LockedTarget(code=mark.code, pga_g=round(mark.pga / g, DIGITS), sha256=mark.sha256),
        _chosen(fitting, scale_to, further_factor),
        artificial=None if recipe is None else _recipe(*recipe, [m for m in motions if m.record.artificial]),
        records=records,
    )


def write_lock(path: Path, text: str) -> None:
    """Write a lock, whole or not at all; only a lock as it was written before is replaced.

    Raises
    ------
    OutputError : the file that is there is another, or a lock that was edited
    """
    if path.is_file() and not is_replaceable(path) and path.read_bytes() != text.encode():
        raise OutputError(f"{path}: {_found(path)}; move it away, and a new one is written")
    with replace_file(path, command=COMMAND, is_replaceable=is_replaceable) as made:
        made.write_text(text, encoding="utf-8", newline="\n")


def _found(path: Path) -> str:
    """Return what a file is that is not a lock as it was written."""
    start = path.read_bytes().startswith(HEAD.encode())
    return "the lock was edited since it was written" if start else "not written by `assess records select --lock`"


def _locked(
    motion: ScaledRecord, file: Path, *, place: Path, overrides: HeaderOverrides, nga: int | None
) -> LockedRecord:
    record, response = motion.record, overrides.response
    return LockedRecord(
        id=record.id,
        file=relative_path(file, place),
        position=_position(record, read_with(file, overrides)),
        component=record.component,
        sha256=file_sha256(file),
        scale_factor=motion.scaling.factor,
        event=record.event,
        date=record.earthquake.time,
        station=record.station,
        magnitude=record.earthquake.magnitude,
        distance_m=record.distance,
        vs30_m_per_s=record.site.vs30,
        nga=nga,
        unit=overrides.unit,
        step_s=overrides.step,
        response=None if response is None else relative_path(response, place),
        response_sha256=None if response is None else file_sha256(response),
    )


def _position(record: Record, found: Sequence[Record]) -> int:
    """Return the place of a record among those of its file, from 1."""
    return next(
        place
        for place, one in enumerate(found, start=1)
        if one.component == record.component and np.array_equal(one.acceleration, record.acceleration)
    )


def _chosen(fitting: Fitting, scale_to: ScaleTo, further_factor: float) -> LockedChoice:
    low, high = fitting.band.ends
    code = None if fitting.given is None or not fitting.given.code else fitting.given.code
    found = fitting.selection
    if found is None:
        return LockedChoice(how="all", scale_to=scale_to, further_factor=further_factor, periods_s=(low, high))
    weight = fitting.band.weight
    pairs = zip(fitting.band.period.tolist(), weight.tolist(), strict=True)
    of = found.criteria
    return LockedChoice.model_validate(
        {
            "how": "selected",
            "scale_to": scale_to,
            "further_factor": further_factor,
            "periods_s": (low, high),
            "weights": () if np.all(weight == weight[0]) else tuple(pairs),
            "for": code,
            "fit": of.fit,
            "components": of.components,
            "one_per_event": of.one_per_event,
            "scale_limits": of.scale_limits,
            "misfit": found.misfit,
            "greedy_misfit": found.greedy,
            "remaining": found.counted,
        }
    )


def _recipe(made: Artificial, band: tuple[float, float], motions: Sequence[ScaledRecord]) -> LockedArtificial:
    return LockedArtificial(
        count=made.count,
        seed=made.seed,
        duration_s=made.duration,
        periods_s=band,
        scale_factor=motions[0].scaling.factor,
        sha256=tuple(samples_sha256(motion.record) for motion in motions),
    )
