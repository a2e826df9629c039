"""A lock on a folder that names its holder, held as long as a command writes there.

The kernel releases it when its holder ends, however that happens: a lock file left behind blocks nobody, and it does
not matter that process numbers are reused. Kernels do not see each other's locks on every network folder, so a lock
file signed on another machine counts as held; so does one on a disk without locks, as long as its process lives.
"""

from __future__ import annotations

import errno
import json
import os
import socket
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path

from assess.errors import HeldError

LOCK = ".assess-lock"
PATIENCE = 10.0  # s, within which the children of a killed command end
_PAUSE = 0.02  # s
_BOOT = Path("/proc/sys/kernel/random/boot_id")
_BYTE = 1 << 30  # Windows hides what is locked from others: a byte far behind the text
_REFUSED = (errno.EWOULDBLOCK, errno.EACCES, errno.EDEADLK)
_OPENED = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)


@dataclass(frozen=True)
class Holder:
    """The process that holds a lock; boot: id of the running kernel, "" if there is none."""

    pid: int
    host: str
    boot: str
    command: str
    since: str

    def __str__(self) -> str:
        return f"{self.command} (process {self.pid} on {self.host}, since {self.since})"

    @property
    def elsewhere(self) -> bool:
        """Whether it is on a machine whose locks this kernel may not see."""
        return self.host != socket.gethostname() and (self.boot == "" or self.boot != _boot())

    @property
    def has_ended(self) -> bool:
        """Whether it is known to have ended."""
        return self.host == socket.gethostname() and (self.boot != _boot() or not _runs(self.pid))


@contextmanager
def hold_lock(folder: Path, *, command: str, patient: bool = False, name: str = LOCK) -> Iterator[None]:
    """Hold the lock of `folder` while the block runs.

    Parameters
    ----------
    folder : the folder
    command : what holds it, named to other commands
    patient : whether to wait a while for a living holder
    name : of the lock file: another one than the folder's for a part of it

    Raises
    ------
    HeldError : another command holds it; the text names that
    """
    file = folder / name
    handle = _acquire(file, patient=patient)
    try:
        _sign(handle, command)
        yield
    finally:
        _release(handle, file)


def is_abandoned(file: Path, *, unsigned: bool = True) -> bool:
    """Return whether nobody holds the lock `file`; raise OSError if there is no such file.

    unsigned : the answer for a lock that is neither signed nor held, whose holder may be about to sign it
    """
    handle = os.open(file, _OPENED & ~os.O_CREAT)
    try:
        granted = _try_lock(handle)
        holder = _holder(handle)
        if holder is None:
            return unsigned and granted is not False
        return granted or (granted is None and holder.has_ended)
    finally:
        os.close(handle)


def _acquire(file: Path, *, patient: bool) -> int:
    """Return the handle of the lock file, locked."""
    deadline = time.monotonic() + PATIENCE
    while True:
        handle = os.open(file, _OPENED, 0o644)
        granted, holder = _try_lock(handle), _holder(handle)
        if granted and not _is(handle, file):  # its last holder has just removed it
            os.close(handle)
            continue
        if granted and (holder is None or not holder.elsewhere):
            return handle
        if granted is None and (holder is None or holder.has_ended):
            return handle
        os.close(handle)
        waits = patient or holder is None or holder.has_ended
        if granted or not waits or time.monotonic() > deadline:
            raise HeldError(_held_text(file, holder, certain=granted is False))
        time.sleep(_PAUSE)


def _held_text(file: Path, holder: Holder | None, *, certain: bool) -> str:
    who = "another command" if holder is None else str(holder)
    unless = "" if certain else f"; if it is certain that it has ended, delete {file.name} in that folder"
    return f"{file.parent}: is being written by {who}; wait until that has ended, or give another folder{unless}"


def _try_lock(handle: int) -> bool | None:
    """Return whether the kernel grants the lock; None on a disk without locks."""
    try:
        if sys.platform == "win32":
            import msvcrt

            os.lseek(handle, _BYTE, os.SEEK_SET)
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        return False if error.errno in _REFUSED else None
    return True


def _is(handle: int, file: Path) -> bool:
    """Return whether the open file is still the one at its path."""
    try:
        return os.path.samestat(os.fstat(handle), file.stat())
    except OSError:
        return False


def _sign(handle: int, command: str) -> None:
    since = datetime.now().astimezone().isoformat(" ", "seconds")
    mine = Holder(os.getpid(), socket.gethostname(), _boot(), command, since)
    os.ftruncate(handle, 0)
    os.lseek(handle, 0, os.SEEK_SET)
    os.write(handle, json.dumps(asdict(mine)).encode())


def _holder(handle: int) -> Holder | None:
    """Return who signed the lock; None if nobody has yet."""
    try:
        os.lseek(handle, 0, os.SEEK_SET)
        found = json.loads(os.read(handle, 10_000))
        return Holder(int(found["pid"]), *(str(found[key]) for key in ("host", "boot", "command", "since")))
    except (OSError, ValueError, TypeError, KeyError):
        return None


def _release(handle: int, file: Path) -> None:
    """Remove the lock file, while it is held where the system allows."""
    if sys.platform == "win32":
        os.close(handle)
        with suppress(OSError):
            file.unlink()
        return
    with suppress(OSError):
        if _is(handle, file):
            file.unlink()
    os.close(handle)


def _boot() -> str:
    try:
        return _BOOT.read_text(encoding="ascii").strip()
    except (OSError, UnicodeDecodeError):
        return ""


def _runs(pid: int) -> bool:
    """Return whether a process of this number runs on this machine; True if that is not known."""
    if sys.platform == "win32":  # where signal 0 would end it
        return True
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        return True
    return True
