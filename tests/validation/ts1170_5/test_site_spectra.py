"""Site spectra of TS 1170.5:2025 against published values of a grid point and a settlement; accelerations in g."""

import numpy as np
import pytest
from scipy.constants import g

from spectra.errors import SpectrumError
from spectra.registry import spectrum
from spectra.ts1170_5 import site_spectrum

WELLINGTON = {"pga": 1.27 * g, "s_as": 2.93 * g, "t_c": 0.81, "t_d": 2.8}  # -41.3~174.8, 1/2500, class IV
CLASSES = ("I", "II", "III", "IV", "V", "VI")
HEADER = ["location", "location_ascii", "apoe", "M", "D"]
HEADER += [f"{site}-{name}" for site in CLASSES for name in ("PGA", "Sas", "Tc", "Td")]
# Table 3.1 as GNS Science publishes it (TS1170.5-SDP, deliverables/v2): Kaitaia; of the second row only D is another
KAITAIA = "0.13,0.29,0.35,3.1,0.16,0.33,0.43,3.0,0.18,0.38,0.52,2.8,0.2,0.44,0.6,2.8,"
KAITAIA += "0.19,0.48,0.68,2.7,0.2,0.53,0.79,2.6"
TABLE = f'{",".join(HEADER)}\n"Ōpua","Opua"," 1/500",6.3,">20",{KAITAIA}\n"Near","Near"," 1/1000",6.3,5,{KAITAIA}\n'


def test_wellington():
    """As the tests of a public implementation have it: PGA, half way to the plateau, it, S_a,s T_c, and eq. 3.5."""
    found = site_spectrum(**WELLINGTON).acceleration([0.0, 0.05, 0.5, 1.0, 4.0]) / g
    expected = [1.27, (1.27 + 2.93) / 2, 2.93, 2.93 * 0.81, 2.93 * (0.81 / 4.0) * (2.8 / 4.0) ** 0.5]
    np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_the_published_table_is_read_by_place(tmp_path):
    (tmp_path / "table.csv").write_text(TABLE, encoding="utf-8")
    given = {"file": tmp_path / "table.csv", "site_class": "III"}
    found = spectrum("ts1170.5", **given, location="opua", return_period=500.0)
    np.testing.assert_allclose(found.acceleration([0.0, 0.3, 1.0]) / g, [0.18, 0.38, 0.38 * 0.52], rtol=1e-12)
    assert found.parameters["near_fault_distance"] == "none"
    assert not found.warnings
    near = spectrum("ts1170.5", **given, location="Near", return_period=1000.0)
    assert near.parameters["near_fault_distance"] == 5e3
    assert [each.key for each in near.warnings] == ["ts1170-near-fault"]
    for change, said in (
        ({"location": "Opau", "return_period": 500.0}, 'no place "Opau"; the nearest names are opua'),
        ({"location": "Ōpua", "return_period": 475.0}, "no return period of 475 years; choose one of 500"),
        ({"location": "Ōpua", "return_period": 500.0, "site_class": "VII"}, "VII has no row"),
        ({"location": "Ōpua", "return_period": 500.0, "near_fault_distance": 5e3}, "were not read"),
    ):
        with pytest.raises(SpectrumError, match=said):
            spectrum("ts1170.5", **{**given, **change})


@pytest.mark.parametrize(("change", "said"), [({"s_as": 1.0}, "exchanged"), ({"t_d": 0.5}, "T_c < T_d")])
def test_values_that_make_no_spectrum_are_refused(change, said):
    with pytest.raises(SpectrumError, match=said):
        site_spectrum(**{**WELLINGTON, **change})
