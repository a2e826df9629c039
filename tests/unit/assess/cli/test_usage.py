"""What a command says that was typed wrongly: one line of plain English, with the value."""

import pytest
import typer

from assess.cli.app import app
from assess.cli.options import WRONG_USAGE, usage_error
from tests.support.command import ended


@pytest.mark.parametrize(
    ("typed", "told"),
    [
        ("run x --jobs two", "Invalid value for '--jobs': \"two\" is not a whole number; see `assess run"),
        ("run x --jobs 0", "Invalid value for '--jobs': 0: must be at least 1; see `assess run"),
        (
            "geometry x --up q",
            "Invalid value for '--up' / '--mesh-up': 'q' is not one of 'y', 'z'; see `assess geometry",
        ),
        (
            "records spectra f --damping a\nb",
            "Invalid value for '--damping': \"a\\nb\" is not a number; see `assess records",
        ),
        ("run x --jbs", "No such option: --jbs; did you mean --jobs? See `assess run"),
        ("records slect", "No such command 'slect'; did you mean 'select', 'spectra', 'scale'? See `assess records"),
        ("run", "Missing argument 'PROJECT'; see `assess run"),
    ],
)
def test_a_wrong_command_is_told_in_plain_words(typed: str, told: str) -> None:
    with pytest.raises(WRONG_USAGE) as caught:
        app(typed.split(" "), standalone_mode=False, prog_name="assess")
    assert str(usage_error(caught.value)).startswith(told)


@pytest.mark.parametrize("typed", ["٢", "１２", "-٠.٥", "०.१"])
def test_a_number_in_other_digits_is_refused(typed: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("run", "x", "--jobs", typed) == 2
    assert f'"{typed}": a number is written with the digits 0 to 9' in capsys.readouterr().err
    for joined in (f"--jobs={typed}", f"-j{typed}", f"-vj{typed}"):
        assert ended("run", "x", joined) == 2
        assert f'"{joined}": a number is written with the digits 0 to 9' in capsys.readouterr().err


def test_a_name_may_end_in_any_digits(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("run", "villa٢") == 2
    assert "digits 0 to 9" not in capsys.readouterr().err


def _commands(group, names=()):
    """Every command that can be typed, with its names."""
    for name, command in getattr(group, "commands", {}).items():
        yield from _commands(command, (*names, name))
    if not hasattr(group, "commands"):
        yield " ".join(names), group


def test_every_option_says_what_it_is() -> None:
    silent = [
        f"{name}: {option.opts}"
        for name, command in _commands(typer.main.get_command(app))
        for option in command.params
        if not getattr(option, "help", "help")
    ]
    assert silent == []


def test_help_names_the_ways_to_fit_that_there_are() -> None:
    commands = dict(_commands(typer.main.get_command(app)))
    (fit,) = (option for option in commands["records select"].params if option.name == "fit")
    for known in ("suite", "each"):
        assert f'"{known}"' in fit.help
