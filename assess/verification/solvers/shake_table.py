"""Many tests of one block on a shake table, beside the same number of histories: distributions, never single tests."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from pathlib import Path
from typing import Any

QUANTILES = (0.1, 0.25, 0.5, 0.75, 0.9)


def solve_shake_table(folder: Path, given: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return quantiles of the largest |θ|/α measured and computed, and how far their distributions are apart.

    Parameters
    ----------
    folder : of the case, with the motions
    given : `file`, a table of tests as CSV with the columns `motion`, a record file by its path from the case, `scale`
        of it [-] and `max_ratio`, the largest |θ|/α measured, 1 or more where the block overturned; `block` with `p`
        [1/s], `slenderness` [rad], `restitution` [-]; `equation`

    Returns
    -------
    Mapping
        `inputs`, the table and the motions; `measured` and `computed`: `tests`, `overturned` as a share [-] and
        `quantiles` of min(|θ|/α, 1) by percentage; `apart`: `distance`, the largest of their distribution functions
        (Kolmogorov and Smirnov), and `probability` of one as large from equal distributions.
    """
    from os.path import relpath

    import numpy as np
    from scipy.constants import g
    from scipy.stats import ks_2samp

    from assess.dynamics.history import Jobs, peaks
    from assess.oscillator import Oscillator, SingleBlock, plain_branch
    from assess.project.file_digests import file_sha256
    from records.reading import read_records

    with (folder / given["file"]).open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    names = sorted({row["motion"] for row in rows})
    motions = [read_records(folder / name)[0] for name in names]
    block = given["block"]
    side = plain_branch(
        SingleBlock(1.0, 1.0, block["slenderness"], g / block["p"] ** 2), restitution=block["restitution"]
    )
    which = np.array([names.index(row["motion"]) for row in rows], dtype=np.int64)
    jobs = Jobs(np.zeros_like(which), which, np.array([float(row["scale"]) for row in rows]))
    found = peaks([Oscillator(side, side, 1.0)], motions, jobs, equation=given["equation"])
    measured = np.minimum([float(row["max_ratio"]) for row in rows], 1.0)
    computed = np.where(found.overturned, 1.0, np.minimum(found.max_ratio, 1.0))
    apart = ks_2samp(measured, computed)
    table = folder / given["file"]
    files = [(Path(relpath(each, table.parent)), each) for each in (table, *(folder / name for name in names))]
    return {
        "inputs": [{"path": path.as_posix(), "sha256": file_sha256(each)} for path, each in files],
        "measured": _distribution(measured),
        "computed": _distribution(computed),
        "apart": {"distance": float(apart.statistic), "probability": float(apart.pvalue)},
    }


def _distribution(ratios: Any) -> Mapping[str, Any]:
    import numpy as np

    quantiles = {f"{100 * share:g} %": float(np.quantile(ratios, share)) for share in QUANTILES}
    return {"tests": len(ratios), "overturned": float(np.mean(ratios >= 1.0)), "quantiles": quantiles}
