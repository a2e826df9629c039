"""The hazard of a site by the four nodes around it, against the weights of NTC 2008, Annex A, worked by hand."""

import numpy as np
import pytest
from scipy.constants import g

from spectra.errors import SpectrumError
from spectra.ntc_grid import site_hazard
from spectra.registry import spectrum

LATITUDE, LONGITUDE, STEP = 45.0, 9.0, 0.05
KEYS = {"nominal_life": 50.0, "use_class": "II", "soil": "A"}


def write_grid(path, turn=0.0, without=()):
    """Write 4 by 4 nodes, sides of 0.05 degrees of latitude, the site 0.3 and 0.4 of a side into the middle mesh."""
    lines = ["ID;LON;LAT;ag_30 [g/10];F0_30;Tc_30 [s];ag_475 [g/10];F0_475;Tc_475 [s]"]
    c, s = np.cos(turn), np.sin(turn)
    for number, (i, j) in enumerate((i, j) for i in range(-1, 3) for j in range(-1, 3)):
        if number in without:
            continue
        x, y = STEP * (i - 0.3), STEP * (j - 0.4)
        place = LONGITUDE + (c * x - s * y) / np.cos(np.radians(LATITUDE)), LATITUDE + s * x + c * y
        values = (0.5 + 0.1 * i, 2.4, 0.25, 1.5 + 0.1 * i + 0.2 * j, 2.5, 0.3 + 0.01 * j)
        lines.append(";".join([str(number), *(f"{value:.9f}".replace(".", ",") for value in (*place, *values))]))
    path.write_text("\n".join(lines))
    return path


@pytest.mark.parametrize("turn", [0.0, 0.1, -0.5])
def test_four_corners_by_hand(turn, tmp_path):
    """Distances 0.5, 0.80623, 0.67082, 0.92195 of a side: weights 2, 1.24035, 1.49071, 1.08465, sum 5.81571."""
    hazard = site_hazard(write_grid(tmp_path / "grid.csv", turn), latitude=LATITUDE, longitude=LONGITUDE)
    east, north = (1.24035 + 1.08465) / 5.81571, (1.49071 + 1.08465) / 5.81571  # weights of i = 1 and of j = 1
    assert [row.return_period for row in hazard] == [30.0, 475.0]
    assert hazard[0].a_g == pytest.approx((0.5 + 0.1 * east) * g / 10, rel=1e-5)
    assert hazard[1].a_g == pytest.approx((1.5 + 0.1 * east + 0.2 * north) * g / 10, rel=1e-5)
    assert (hazard[1].f_0, hazard[1].t_c_star) == pytest.approx((2.5, 0.3 + 0.01 * north), rel=1e-5)


def test_a_site_on_a_node_has_its_values(tmp_path):
    node = {"latitude": LATITUDE - 0.4 * STEP, "longitude": LONGITUDE - 0.3 * STEP / np.cos(np.radians(LATITUDE))}
    assert site_hazard(write_grid(tmp_path / "grid.csv"), **node)[1].a_g == pytest.approx(0.15 * g, rel=1e-6)


def test_the_spectrum_is_that_of_the_rows(tmp_path):
    place = {"latitude": LATITUDE, "longitude": LONGITUDE}
    grid = write_grid(tmp_path / "grid.csv")
    rows = [vars(row) for row in site_hazard(grid, **place)]
    by_grid, by_rows = spectrum("ntc2018", grid=grid, **place, **KEYS), spectrum("ntc2018", hazard=rows, **KEYS)
    np.testing.assert_array_equal(by_grid.acceleration([0.0, 0.3, 2.0]), by_rows.acceleration([0.0, 0.3, 2.0]))


def test_a_site_without_four_nodes_around_it_is_refused(tmp_path):
    whole, place = write_grid(tmp_path / "grid.csv"), {"latitude": LATITUDE, "longitude": LONGITUDE}
    with pytest.raises(SpectrumError, match=r"no four nodes of its grid surround 45\.2 N"):
        site_hazard(whole, latitude=45.2, longitude=LONGITUDE)
    for corner in (5, 6, 9, 10):
        with pytest.raises(SpectrumError, match="no four nodes"):
            site_hazard(write_grid(tmp_path / f"{corner}.csv", without=(corner,)), **place)
    whole.write_text(whole.read_text().replace("ag_475 [g/10]", "ag_475"))
    with pytest.raises(SpectrumError, match='"ag_475" has no unit'):
        site_hazard(whole, **place)
