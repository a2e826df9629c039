"""Every cell of the tables of site coefficients, against those of the USGS design web services.

ASCE 7-05, 7-10 and 7-16 as in github.com/usgs/earthquake-design-ws, src/lib/component/site-amplification-factory.js.
Where ASCE 7-16 refers class E to its 11.4.8 that service repeats the last value; here stand the values of the NEHRP
Provisions of 2015, in the table that the USGS shows for them (SiteAmplification.js: `E` and `supInfo`).
"""

import pytest
from scipy.constants import g

from spectra.asce7 import mapped_spectrum

F_A = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.2, 1.2, 1.1, 1.0, 1.0),
    "D": (1.6, 1.4, 1.2, 1.1, 1.0),
    "E": (2.5, 1.7, 1.2, 0.9, 0.9),
}
F_V = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.7, 1.6, 1.5, 1.4, 1.3),
    "D": (2.4, 2.0, 1.8, 1.6, 1.5),
    "E": (3.5, 3.2, 2.8, 2.4, 2.4),
}
F_A_16 = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (0.9, 0.9, 0.9, 0.9, 0.9, 0.9),
    "B-unmeasured": (1.0, 1.0, 1.0, 1.0, 1.0, 1.0),  # B-estimated
    "C": (1.3, 1.3, 1.2, 1.2, 1.2, 1.2),
    "D": (1.6, 1.4, 1.2, 1.1, 1.0, 1.0),
    "D-default": (1.6, 1.4, 1.2, 1.2, 1.2, 1.2),
    "E": (2.4, 1.7, 1.3, 1.2, 1.2, 1.2),
}
F_V_16 = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B-unmeasured": (1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.5, 1.5, 1.5, 1.5, 1.5, 1.4),
    "D": (2.4, 2.2, 2.0, 1.9, 1.8, 1.7),
    "D-default": (2.4, 2.2, 2.0, 1.9, 1.8, 1.7),
    "E": (4.2, 3.3, 2.8, 2.4, 2.2, 2.0),
}
S_S, S_1 = (0.25, 0.5, 0.75, 1.0, 1.25, 1.5), (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)  # g


@pytest.mark.parametrize(
    ("code", "site_class"),
    [(code, row) for code, rows in (("asce7-05", F_A), ("asce7-10", F_A), ("asce7-16", F_A_16)) for row in rows],
)
def test_every_cell(code: str, site_class: str) -> None:
    f_a, f_v = (F_A_16, F_V_16) if code == "asce7-16" else (F_A, F_V)
    for s_s, s_1, short, long in zip(S_S, S_1, f_a[site_class], f_v[site_class], strict=False):
        spectrum = mapped_spectrum(code=code, s_s=s_s * g, s_1=s_1 * g, site_class=site_class, t_l=8.0)
        found = spectrum.parameters["f_a"], spectrum.parameters["f_v"]
        assert found == pytest.approx((short, long), rel=1e-12), (s_s, s_1)
