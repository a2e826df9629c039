"""The server of the page: viser on this machine alone, opened by a secret address, without a door to any other host.

viser answers whoever reaches its port, and takes a WebSocket from any page of a browser. So the function of websockets
that it serves with is wrapped while its server is made, on a socket that is bound here:

- A request is answered where its Host is this server, and it carries the cookie that the secret address sets.
- A WebSocket also needs this server as its Origin, which no other page of the browser can have.
- What it sends lets a browser ask no other host for anything (Content-Security-Policy).

Its messages that open a tunnel to another host have no handler.
"""

from __future__ import annotations

import gzip
import os
import secrets
import socket
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from html import escape
from http import HTTPStatus
from mimetypes import guess_type
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

from assess.errors import AssessError

HOST = "127.0.0.1"
PORT_OVERRIDE = "_VISER_PORT_OVERRIDE"
REFUSED = "403: open the address that `assess serve` printed, on the machine where it runs.\n"
POLICY = (
    "default-src 'self' data: blob: 'unsafe-inline' 'unsafe-eval'; connect-src 'self' data: blob: {socket}; "
    "frame-ancestors 'none'; form-action 'none'; base-uri 'none'"
)
"""What a browser may load: what the page brings along, and its own socket."""
LIBRARY_TITLE = b"<title>Viser</title>"
HEADERS = {"Cache-Control": "no-store", "Referrer-Policy": "no-referrer", "X-Content-Type-Options": "nosniff"}


class PageServer:
    """The server of the page.

    viser : the server of the library, by whose `scene` and `gui` the page is drawn
    address : to be opened once in a browser, with the secret
    port : that it listens on
    files : shown beside the page, by their paths on the server
    """

    def __init__(self, *, port: int = 0, label: str = "") -> None:
        """Listen on 127.0.0.1.

        Parameters
        ----------
        port : of the address; any free one where 0
        label : title of the window

        Raises
        ------
        AssessError : viser is not installed, or does not serve as it did; the port is taken; or the environment sets
            another one
        """
        _require_usual_port()
        library = _library()
        self._socket = _bound_socket(port)
        self.port: int = self._socket.getsockname()[1]
        self._secret = secrets.token_urlsafe(32)
        self.address = f"http://{HOST}:{self.port}/?token={self._secret}"
        self.files: dict[str, Path] = {}
        guard = _Guard(self.port, self._secret, self.files, library, label)
        try:
            with _guarded(library, guard, self._socket):
                self.viser = library.ViserServer(host=HOST, port=self.port, verbose=False)
        except BaseException:
            self._socket.close()
            raise
        if not guard.used:
            self.close()
            raise AssessError("viser: its server is not made as in version 1.1.1; install that version")
        for message in (library._messages.ShareUrlRequest, library._messages.ShareUrlDisconnect):
            self.viser._websock_server.unregister_handler(message)

    def close(self) -> None:
        """Stop listening."""
        self.viser.stop()
        self._socket.close()


class _Guard:
    """What may be asked of the server, and by whom."""

    def __init__(self, port: int, secret: str, files: Mapping[str, Path], library: Any, title: str) -> None:
        self.used, self._files, self._title = False, files, f"<title>{escape(title or 'assess')}</title>".encode()
        self._hosts = (f"{HOST}:{port}", f"localhost:{port}")
        self._cookie, self._secret = f"assess_{port}", secret
        self._response, self._headers = library.infra._infra.Response, library.infra._infra.Headers

    def wrap(self, process: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
        """Return a handler of requests that passes on to `process` those that may be answered."""

        def guarded(connection: Any, request: Any) -> Any:
            host = self._only(request, "Host")
            if host not in self._hosts:
                return self._refusal()
            upgraded = bool(request.headers.get_all("Upgrade"))
            if not upgraded and self._is_secret(parse_qs(urlsplit(request.path).query).get("token", [""])[0]):
                cookie = f"{self._cookie}={self._secret}; Path=/; HttpOnly; SameSite=Strict"
                return self._answer(HTTPStatus.SEE_OTHER, "", {"Location": "/", "Set-Cookie": cookie})
            if not self._has_cookie(request):
                return self._refusal()
            if upgraded and self._only(request, "Origin") not in [f"http://{each}" for each in self._hosts]:
                return self._refusal()
            file = None if upgraded else self._files.get(urlsplit(request.path).path)
            response = process(connection, request) if file is None else self._file(file)
            if response is not None:
                if file is None:
                    self._entitle(response)
                response.headers.update(HEADERS)
                response.headers["Content-Security-Policy"] = POLICY.format(socket=f"ws://{host}")
            return response

        return guarded

    def _entitle(self, response: Any) -> None:
        """Put the title of the window in place of the library's."""
        if not response.headers.get("Content-Type", "").startswith("text/html"):
            return
        packed = response.headers.get("Content-Encoding") == "gzip"
        plain = gzip.decompress(response.body) if packed else response.body
        if LIBRARY_TITLE in plain:
            body = plain.replace(LIBRARY_TITLE, self._title, 1)
            response.body = gzip.compress(body) if packed else body
            del response.headers["Content-Length"]
            response.headers["Content-Length"] = str(len(response.body))

    def _is_secret(self, text: str) -> bool:
        return secrets.compare_digest(text.encode("utf-8", "replace"), self._secret.encode())

    def _has_cookie(self, request: Any) -> bool:
        pairs = (pair.strip().partition("=") for line in request.headers.get_all("Cookie") for pair in line.split(";"))
        return any(name == self._cookie and self._is_secret(value) for name, _, value in pairs)

    @staticmethod
    def _only(request: Any, name: str) -> str | None:
        """Return a header that is there once; None otherwise."""
        found = request.headers.get_all(name)
        return found[0] if len(found) == 1 else None

    def _refusal(self) -> Any:
        return self._answer(HTTPStatus.FORBIDDEN, REFUSED, {})

    def _file(self, file: Path) -> Any:
        try:
            body = file.read_bytes()
        except OSError:
            return self._answer(HTTPStatus.NOT_FOUND, f"404: {file.name} is no longer there.\n", {})
        kind = guess_type(file.name)[0] or "application/octet-stream"
        return self._answer(HTTPStatus.OK, body, {"Content-Type": kind})

    def _answer(self, status: HTTPStatus, text: str | bytes, headers: dict[str, str]) -> Any:
        body = text.encode() if isinstance(text, str) else text
        always = {"Content-Type": "text/plain; charset=utf-8", "Content-Length": str(len(body)), **HEADERS, **headers}
        return self._response(status, status.phrase, self._headers(**always), body)


@contextmanager
def _guarded(library: Any, guard: _Guard, listening: socket.socket) -> Iterator[None]:
    """Let what viser serves with in the block be guarded, on a socket that is bound already."""
    asked = library.infra._infra.websockets.asyncio.server
    serve = asked.serve

    def guarded(handler: Any, host: str, port: int, *, process_request: Any, **options: Any) -> Any:
        guard.used = True
        return serve(handler, sock=listening, process_request=guard.wrap(process_request), **options)

    asked.serve = guarded
    try:
        yield
    finally:
        asked.serve = serve


def _require_usual_port() -> None:
    if PORT_OVERRIDE in os.environ:
        raise AssessError(f"{PORT_OVERRIDE}: set in the environment, where it takes the port's place; unset it")


def _library() -> Any:
    """Return viser, which then prints nothing of its own."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of the libraries that it imports
            import viser
            import viser._messages
            import viser.infra._infra
    except ImportError as error:
        raise AssessError(
            f'assess serve: viser is not here ({error}); install the extra: pip install "rocking-assess[serve]"'
        ) from None
    import rich

    rich.get_console().quiet = True
    return viser


def _bound_socket(port: int) -> socket.socket:
    """Return a socket that is bound to a port of this machine."""
    found = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    if os.name == "posix":
        found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # a port just left is free at once
    try:
        found.bind((HOST, port))
    except (OSError, OverflowError) as error:
        found.close()
        reason = getattr(error, "strerror", None) or error
        raise AssessError(f"--port {port}: cannot be had ({reason}); name another, or 0 for any that is free") from None
    return found
