"""Programs that `make peers` measures answer the same question: their values agree before their times are compared."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from scipy.stats import norm

from assess.dynamics.packing import Equation
from assess.risk.estimates import fit_lognormal, holm
from records.record import make_record
from tools.benchmarks.bench_dynamics import swings_by_scipy, violent
from tools.benchmarks.bench_records import COARSE, T, by_eqsig, by_pyrotd, ours
from tools.benchmarks.peers import engines, opensees, page
from tools.benchmarks.peers.blocks import by_us
from tools.benchmarks.peers.body import RESTITUTION, pulse, swings
from tools.benchmarks.peers.histories import largest_by_scipy, largest_by_us, largest_in_one_go
from tools.benchmarks.peers.installed import find


def installed(package: str, module: str | None = None) -> ModuleType:
    """Return a program, or skip with the reason why it does not load."""
    peer = find(package, module)
    if peer.module is None:
        pytest.skip(f"{package} is measured by `make peers` only: {peer.said}")
    return peer.module


@pytest.mark.parametrize("equation", ["linearised", "exact"])
def test_histories(equation: Equation) -> None:
    record = make_record("part", violent().acceleration[650:950], 0.005)  # 1.5 s about the peak
    wanted = largest_by_scipy(equation, record, 1e-10)
    assert wanted > 0.01
    assert largest_by_us(equation, record, 1e-10) == pytest.approx(wanted, rel=1e-8)
    assert largest_in_one_go(equation, record, 1e-6, "RK45") == pytest.approx(wanted, rel=1e-4)


def test_swings_of_the_block() -> None:
    wanted = np.abs(swings_by_scipy("exact", pulse(), 1e-8, restitution=RESTITUTION)[:3])
    np.testing.assert_allclose(by_us(pulse()).swings[:3], wanted, rtol=1e-4)  # at samples of 5 ms, not at the peaks


def test_rattling_is_no_swing() -> None:
    assert swings([0.0, 0.5, 1.0, -1e-3, 1e-3, -0.4, -0.8, 0.0]) == (1.0, 0.8)


def test_mujoco() -> None:
    found = engines.by_mujoco(installed("mujoco"), pulse(), 1e-3)
    np.testing.assert_allclose(found.swings[:3], by_us(pulse()).swings[:3], rtol=0.01)


def test_bullet() -> None:
    found = engines.by_bullet(installed("pybullet"), pulse(), 1e-3)
    np.testing.assert_allclose(found.swings[:3], by_us(pulse()).swings[:3], rtol=0.02)


def test_opensees() -> None:
    found = opensees.by_fibres(installed("openseespy", "openseespy.opensees"), pulse(), 1e-3)
    np.testing.assert_allclose(found.swings[:3], by_us(pulse()).swings[:3], rtol=0.02)


def test_spectra() -> None:
    record = make_record("padded", np.pad(violent().acceleration, (1, 4000)), 0.005)  # rest, for pyrotd
    some = (COARSE * record.dt < T) & (T < 1.0)
    eqsig, pyrotd = find("eqsig", "eqsig.sdof"), find("pyrotd")
    found = [by_eqsig(eqsig.module, record)] if eqsig.module is not None else []
    found += [by_pyrotd(pyrotd.module, record)] if pyrotd.module is not None else []
    if not found:
        pytest.skip(f"measured by `make peers` only: eqsig ({eqsig.said}), pyrotd ({pyrotd.said})")
    for each in found:
        np.testing.assert_allclose(each[some], ours(record)[some], rtol=0.05)  # motions differ between samples


def test_lognormals_are_the_probit_of_statsmodels() -> None:
    models = installed("statsmodels", "statsmodels.api")
    im, rng = np.geomspace(0.05, 2.0, 12), np.random.default_rng(3)
    for _ in range(5):
        records = rng.integers(5, 40, im.size)
        reached = rng.binomial(records, norm.cdf(np.log(im / 0.4) / 0.45))
        family = models.families.Binomial(models.families.links.Probit())
        counts = np.column_stack([reached, records - reached])
        a, b = models.GLM(counts, models.add_constant(np.log(im)), family=family).fit(tol=1e-14, maxiter=200).params
        fit = fit_lognormal(im, reached, records)
        assert fit is not None
        np.testing.assert_allclose([fit.median, fit.dispersion], [np.exp(-a / b), 1.0 / b], rtol=1e-8)


def test_holm_is_that_of_statsmodels() -> None:
    multitest = installed("statsmodels", "statsmodels.stats.multitest")
    p = np.random.default_rng(4).uniform(0.0, 0.2, 18)
    np.testing.assert_allclose(holm(p), multitest.multipletests(p, method="holm")[1], rtol=1e-12)


def test_page_has_a_place_for_what_is_measured(tmp_path) -> None:
    copy = tmp_path / "speed.md"
    copy.write_text(page.PAGE.read_text(encoding="utf-8"), encoding="utf-8")
    page.write("a table", copy)
    page.write("another", copy)
    text = copy.read_text(encoding="utf-8")
    assert f"{page.BEGIN}\n\nanother\n{page.END}" in text
    assert "a table" not in text
