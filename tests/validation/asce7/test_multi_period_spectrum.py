"""The multi-period spectrum of ASCE 7-22 against the example that the USGS published with its service; in g."""

import json
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from scipy.constants import g

from assess.codes.asce41_13 import Asce41Options, s_x1_over_pga
from assess.codes.context import Context
from spectra import asce7_22
from spectra.asce7_22 import site_ordinates
from spectra.errors import SpectrumError
from spectra.registry import spectrum

# code.usgs.gov/ghsc/hazdev/earthquake-design-ws, merge request 520: 34 N, 118 W, class C, 7 June 2022
EXAMPLE = Path(asce7_22.__file__).parents[1] / "assess/verification/cases/asce7/usgs_reply.json"
STATED = json.loads(EXAMPLE.read_bytes())["response"]["data"]
PERIODS, ORDINATES = STATED["multiPeriodDesignSpectrum"].values()


def test_the_example_of_the_usgs():
    """S_DS and S_D1 of §21.4 are those that the reply states: 0.9 x 1.62 = 1.458, and S_a(1 s) = 0.7 above 0.63."""
    found = spectrum("asce7-22", file=EXAMPLE)
    np.testing.assert_allclose(found.acceleration(PERIODS) / g, ORDINATES, rtol=1e-12)
    assert found.acceleration(1.25) / g == pytest.approx((0.7 + 0.44) / 2, rel=1e-12)
    assert found.pga / g == pytest.approx(0.65, rel=1e-12)
    assert found.parameters["pga_m"] == pytest.approx(0.9 * g, rel=1e-12)
    assert found.parameters["s_ds"] == pytest.approx(STATED["sds"] * g, abs=0.005 * g)
    assert found.parameters["s_x1"] == found.parameters["s_d1"] == pytest.approx(STATED["sd1"] * g, rel=1e-12)
    assert found.warnings == ()
    assert found.acceleration(2.0, damping=0.2) / g == pytest.approx(0.31 / 1.5, rel=1e-12)  # B = 1.5
    with pytest.raises(SpectrumError, match="outside"):
        found.acceleration(12.0)


def test_h_over_t_takes_s_x1_of_the_clause():
    """Not S_a(1 s): with S_X1 = 0.8 g beside 0.7 g at 1 s and a PGA of 0.65 g, whatever the ordinates are scaled to."""
    found = spectrum("asce7-22", file=EXAMPLE, pga=0.13 * g)
    raised = replace(found, parameters={**found.parameters, "s_x1": 0.8 * g})
    context = cast(Context, SimpleNamespace(spectrum=raised))
    assert s_x1_over_pga(context, Asce41Options()) == pytest.approx(0.8 / 0.65, rel=1e-12)


def test_soft_ground_looks_up_to_5_s():
    """A plateau of velocity to 3 s: T S_a = 0.9 at 3 s counts on soft ground, and not up to 2 s."""
    T, S_a = np.array([0.0, 0.2, 1.0, 2.0, 3.0, 5.0]), np.array([0.4, 1.0, 0.5, 0.3, 0.3, 0.1])
    assert site_ordinates(T, S_a, site_class="C") == pytest.approx((0.9, 0.54), rel=1e-12)
    assert site_ordinates(T, S_a, site_class="Default") == pytest.approx((0.9, 0.81), rel=1e-12)


def test_what_is_no_whole_reply_is_refused_and_an_edited_one_warned_of(tmp_path):
    def given(**data):
        content = json.loads(EXAMPLE.read_bytes())
        content["response"]["data"] |= data
        (tmp_path / "reply.json").write_text(json.dumps(content))
        return {"file": tmp_path / "reply.json"}

    assert [each.key for each in spectrum("asce7-22", **given(sd1=0.5)).warnings] == ["reply-differs"]
    (tmp_path / "page.html").write_text("<html>")
    for data, more, said in (
        ({}, {"file": tmp_path / "page.html"}, "not a reply of the design-maps service"),
        ({}, {"hazard": "mce"}, "multiPeriodMCErSpectrum: no periods"),
        ({"multiPeriodDesignSpectrum": {"periods": [0, 1], "ordinates": [1]}}, {}, "is the reply whole"),
        ({"multiPeriodDesignSpectrum": {"periods": [0, 1], "ordinates": [1, 1]}}, {}, "not 0 to 5 s"),
        ({}, {"s_s": 1.0}, "11.4.5.2, was not read"),
    ):
        with pytest.raises(SpectrumError, match=said):
            spectrum("asce7-22", **{**given(**data), **more})
