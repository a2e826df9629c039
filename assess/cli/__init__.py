"""The command line: one file per command, without logic. `main` is the entry point. It reduces every error to
one line, and what else is wrong with the input to a line each.

Exit codes: 0 success; of `run` 1 for a fail and 3 for an incomplete verdict; of `retrofit` 1 where no layout
is proved; 2 the input is wrong; 70 a bug in the program; 128 plus the number of the signal that ended it.
"""

from __future__ import annotations

import gc
import signal
import sys
from collections.abc import Sequence
from string import ascii_letters
from typing import NoReturn

from assess.cli.stderr import log_to_stderr
from assess.errors import AssessError, other_faults
from assess.outputs.signals import Terminated, raise_on_signals
from records.errors import RecordError
from spectra.errors import SpectrumError

INPUT_IS_WRONG = 2
BY_SIGNAL = 128
BUG = 70
MADE_BETWEEN_COLLECTIONS = 2_000_000  # objects: collecting garbage more often takes a twentieth of a run


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run one command with `arguments`, those of the process if None, and end the process."""
    gc.set_threshold(MADE_BETWEEN_COLLECTIONS)
    log_to_stderr()
    try:
        _refuse_other_digits(sys.argv[1:] if arguments is None else arguments)
        with raise_on_signals():
            from assess.cli.app import app

            code = app(args=arguments, prog_name="assess", standalone_mode=False)
    except (AssessError, RecordError, SpectrumError) as error:
        _end(f"error: {error}", INPUT_IS_WRONG, others=[f"error: {each}" for each in other_faults(error)])
    except OSError as error:
        _end(f"error: {_file_error(error)}", INPUT_IS_WRONG)
    except Terminated as signalled:
        what = "interrupted" if signalled.number == signal.SIGINT else "terminated"
        _end(_with_notes(what, signalled), BY_SIGNAL + signalled.number)
    except KeyboardInterrupt as interrupt:
        _end(_with_notes("interrupted", interrupt), BY_SIGNAL + signal.SIGINT)
    except Exception as error:
        from assess.cli.options import usage_error

        wrong = usage_error(error)
        if wrong:
            _end(f"error: {wrong}", INPUT_IS_WRONG)
        _end(f"internal error: {type(error).__name__}: {error} (log: {_log()})", BUG)
    sys.exit(code or 0)


def _refuse_other_digits(arguments: Sequence[str]) -> None:
    """Raise AssessError for a number in other digits than 0 to 9, which would be read without a word."""
    for each in arguments:
        joined = each[1:].lstrip(ascii_letters) if each.startswith("-") else ""  # -j2, a short option with its value
        other = any(c.isdecimal() and not c.isascii() for c in each)
        if other and any(map(_is_number, (each.rpartition("=")[2], joined))):
            raise AssessError(f'"{each:.40}": a number is written with the digits 0 to 9')


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _with_notes(what: str, stop: BaseException) -> str:
    """Return what ended the command, and what then stands as far as it has said so."""
    return "; ".join((what, *getattr(stop, "__notes__", ())))


def _end(line: str, code: int, *, others: Sequence[str] = ()) -> NoReturn:
    """Print one line on stderr and one for each of the others, whatever the texts contain, and exit."""
    for each in (line, *others):
        text = "".join(c if c.isprintable() else " " for c in each)
        print(f"assess: {text}", file=sys.stderr)
    sys.exit(code)


def _file_error(error: OSError) -> str:
    where = f"{error.filename}: " if error.filename else ""
    from assess.outputs.writing import is_full

    if is_full(error):
        return f"{where}no space is left on the disk; make room there"
    return f"{where}{error.strerror or error}; check the path and its permissions"


def _log() -> str:
    """Write the traceback to a new temporary file and return its path."""
    import tempfile
    import traceback

    try:
        with tempfile.NamedTemporaryFile("w", prefix="assess-", suffix=".log", delete=False, encoding="utf-8") as log:
            log.write(traceback.format_exc())
    except OSError as error:
        return f"not written, {error.strerror}"
    return log.name
