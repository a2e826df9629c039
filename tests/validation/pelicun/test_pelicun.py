"""pelicun 3 itself reads what is exported to it and draws damage: NHERI SimCenter, doi 10.5281/zenodo.2558557.

It needs other versions of pandas and numpy than ours, so it runs in an interpreter of its own: PELICUN_PYTHON names it.
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

from assess.risk.estimates import Lognormal
from assess.risk.exports import ExportedCurve, ExportedState, pelicun_text

PYTHON = os.environ.get("PELICUN_PYTHON", "")
DRAWS = 200_000
PROGRAM = """
import json, sys
import pandas as pd
from pelicun import assessment, file_io
path, demand, unit, value, draws = *sys.argv[1:4], float(sys.argv[4]), int(sys.argv[5])
run = assessment.Assessment({"PrintLog": False, "Seed": 1})
place = pd.MultiIndex.from_tuples([(demand, "0", "1")])
values = {"Theta_0": [value], "Theta_1": [1e-9], "Family": ["lognormal"], "Units": [unit]}
run.demand.load_model({"marginals": pd.DataFrame(values, index=place)})
run.demand.generate_sample({"SampleSize": draws})
model = file_io.load_data(path, reindex=False, unit_conversion_factors=run.unit_conversion_factors)
part = {"Units": "ea", "Location": "0", "Direction": "1", "Theta_0": 1, "Blocks": 1}
run.stories = 1
run.asset.load_cmp_model({"marginals": pd.DataFrame(part, index=list(model.index))})
run.asset.generate_cmp_sample(draws)
run.damage.load_model_parameters([model], set(model.index))
run.damage.calculate()
print(json.dumps(run.damage.ds_model.probabilities().iloc[0].to_list()))
"""


@pytest.mark.study
@pytest.mark.skipif(not Path(PYTHON).is_file(), reason="PELICUN_PYTHON names no interpreter that has pelicun")
@pytest.mark.parametrize(
    ("measure", "period", "unit", "demand"),
    [("pga", None, "g", "PGA g"), ("pgv", None, "m/s", "PGV mps"), ("sa", 0.5, "g", "SA_0.5 g")],
)
def test_pelicun_draws_the_probabilities_of_the_curves(tmp_path, measure, period, unit, demand):
    none, whole = np.zeros(0), np.zeros(0, dtype=np.int64)
    fits = {"rocking": Lognormal(0.15, 0.30), "overturning": Lognormal(0.40, 0.45)}
    states = tuple(ExportedState(name, fit, none, whole, whole, none, none) for name, fit in fits.items())
    export = pelicun_text([ExportedCurve("wall-6", measure, period, unit, states)])
    (tmp_path / "damage.csv").write_text(export.text)
    (tmp_path / "program.py").write_text(PROGRAM)
    command = [PYTHON, "-W", "ignore", "program.py", "damage.csv", *demand.split(), "0.3", str(DRAWS)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    none_reached, first, second = json.loads(done.stdout.splitlines()[-1])
    assert second == pytest.approx(0.2613, abs=4 * np.sqrt(0.2613 * 0.7387 / DRAWS))
    assert first + second == pytest.approx(0.9896, abs=4 * np.sqrt(0.9896 * 0.0104 / DRAWS))
    assert none_reached == pytest.approx(1.0 - first - second)
