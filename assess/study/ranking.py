"""Mechanisms ranked by what an earthquake does to them: the PGA at which a suite overturns each in half of its runs."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor

from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.study.histories import overturning_scan, rocking_case
from assess.study.study import Study, require_spectrum
from assess.study.suites import motions_of
from assess.workers import available_cores
from spectra.gravity import g


def median_overturning_pga(study: Study, *, jobs: int = 0) -> Mapping[str, float | None]:
    """Return the PGA [g] of the target at which the suite first overturns each mechanism in half of its runs, by name.

    None where it does not at any PGA of the scan, and of mechanisms of which no history is answered, or that fall at
    rest without actions that are not shown to last.

    Parameters
    ----------
    study : with a spectrum, and records or what makes them
    jobs : threads, 0 for all cores

    Raises
    ------
    ProjectError : it has no spectrum, or no suite
    """
    spectrum = require_spectrum(study)
    motions = motions_of(study, spectrum, jobs=jobs)
    if not motions:
        raise ProjectError("records: no suite to rank by; name files of records, or synthetic = { count = 7 }")

    def pga_of(mechanism: Mechanism) -> float | None:
        if not mechanism.rocks or mechanism.variants.collapse is None:
            return None
        last = overturning_scan(rocking_case(study, mechanism, motions), motions, site_pga=spectrum.pga, threads=1)[-1]
        return last.pga / g if 2 * last.overturned >= len(last.ratio) else None

    with ThreadPoolExecutor(jobs or available_cores()) as pool:
        found = pool.map(pga_of, study.mechanisms)
        return dict(zip((each.name for each in study.mechanisms), found, strict=True))
