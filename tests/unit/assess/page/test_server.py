"""Who may open the page: whoever has the secret address, from this machine's own page and no other."""

from __future__ import annotations

import gzip
import http.client
import socket
from collections.abc import Iterator
from contextlib import closing, nullcontext

import pytest

pytest.importorskip("viser", reason="needs viser: .venv/serve of the Makefile")

import msgspec
import viser
import viser._messages
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from assess.errors import AssessError
from assess.page import server as room
from assess.page.server import PageServer

VERSION = [f"viser-v{viser.__version__}"]


@pytest.fixture(scope="module")
def server() -> Iterator[PageServer]:
    found = PageServer(label="<b>Casa & C.</b>")
    yield found
    found.close()


def get(server: PageServer, path: str, **headers: str) -> http.client.HTTPResponse:
    with closing(http.client.HTTPConnection("127.0.0.1", server.port, timeout=10)) as connection:
        connection.request("GET", path, headers={"Host": f"127.0.0.1:{server.port}", **headers})
        found = connection.getresponse()
        found.read()
        return found


def cookie(server: PageServer) -> str:
    return get(server, server.address.partition(str(server.port))[2]).headers["Set-Cookie"].partition(";")[0]


def dial(server: PageServer, *, host: str = "", origin: str | None = "", cookie: str = ""):
    """Open a WebSocket as a page of some origin does, to a server of some name."""
    here = f"127.0.0.1:{server.port}"
    return connect(
        f"ws://{host or here}",
        origin=f"http://{here}" if origin == "" else origin,
        additional_headers={"Cookie": cookie} if cookie else {},
        subprotocols=VERSION,
        sock=socket.create_connection(("127.0.0.1", server.port)),
    )


def test_the_secret_address_sets_a_cookie_that_no_other_site_and_no_script_gets(server):
    found = get(server, server.address.partition(str(server.port))[2])
    assert (found.status, found.headers["Location"]) == (303, "/")
    assert found.headers["Set-Cookie"].split("; ")[1:] == ["Path=/", "HttpOnly", "SameSite=Strict"]
    page = get(server, "/", Cookie=found.headers["Set-Cookie"].partition(";")[0])
    assert page.status == 200
    assert "default-src 'self'" in page.headers["Content-Security-Policy"]
    assert get(server, "/", Cookie=cookie(server), Host=f"localhost:{server.port}").status == 200


@pytest.mark.parametrize("coding", ["gzip", "identity"])
def test_the_window_has_the_title_of_the_project_as_text(server, coding):
    with closing(http.client.HTTPConnection("127.0.0.1", server.port, timeout=10)) as connection:
        connection.request("GET", "/", headers={"Cookie": cookie(server), "Accept-Encoding": coding})
        found = connection.getresponse()
        body = found.read()
    assert int(found.headers["Content-Length"]) == len(body)
    text = (gzip.decompress(body) if coding == "gzip" else body).decode()
    assert "<title>&lt;b&gt;Casa &amp; C.&lt;/b&gt;</title>" in text


@pytest.mark.parametrize("path", ["/", "/index.html", "/?token=", "/?token=wrong", "/?token=%ff", "/?other=1"])
def test_without_the_secret_nothing_is_answered(server, path):
    assert get(server, path).status == 403
    assert get(server, path, Cookie=f"assess_{server.port}=wrong").status == 403
    assert get(server, path, Cookie=f"assess_{server.port + 1}={cookie(server).partition('=')[2]}").status == 403


@pytest.mark.parametrize(
    "host", ["evil.example", "127.0.0.1", "127.0.0.1:1", "0.0.0.0:{port}", "localhost.evil:{port}"]
)
def test_another_name_of_this_machine_is_refused(server, host):
    """As of a host whose name an attacker lets point to this machine."""
    name = host.format(port=server.port)
    assert get(server, "/", Host=name, Cookie=cookie(server)).status == 403
    assert get(server, server.address.partition(str(server.port))[2], Host=name).status == 403


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1", "https://127.0.0.1", None])
def test_a_socket_from_another_page_is_refused(server, origin):
    with pytest.raises(InvalidStatus) as caught:
        dial(server, origin=origin, cookie=cookie(server))
    assert caught.value.response.status_code == 403


def test_a_socket_needs_cookie_and_host(server):
    with pytest.raises(InvalidStatus):
        dial(server)
    with pytest.raises(InvalidStatus):
        dial(server, cookie=f"assess_{server.port}=wrong")
    with pytest.raises(InvalidStatus):
        dial(server, host=f"evil.example:{server.port}", cookie=cookie(server))
    with dial(server, cookie=cookie(server)) as found:
        assert found.recv(timeout=10)


def test_no_client_can_open_a_tunnel_to_another_host(server, monkeypatch):
    asked = []
    for name in ("request_share_url", "disconnect_share_url"):
        monkeypatch.setattr(type(server.viser), name, lambda *_: asked.append("tunnel"))
    with dial(server, cookie=cookie(server)) as found:
        found.recv(timeout=10)
        for name in ("ShareUrlRequest", "ShareUrlDisconnect"):
            found.send(message_of(name))
        found.send(message_of("ShareUrlRequest"))
        assert found.ping().wait(10)
    handlers = server.viser._websock_server._incoming_handlers
    assert not {each.__name__ for each in handlers} & {"ShareUrlRequest", "ShareUrlDisconnect"}
    assert (asked, server.viser._share_tunnel) == ([], None)


def message_of(name: str) -> bytes:
    """Return a message without values as the client of viser sends it."""
    packed = msgspec.msgpack.encode({"type": name})
    assert type(viser._messages.Message.deserialize(packed)).__name__ == name
    return packed


def test_it_listens_on_this_machine_alone(server):
    assert server._socket.getsockname() == ("127.0.0.1", server.port)


def test_a_port_that_is_taken_is_an_error(server):
    with pytest.raises(AssessError, match=rf"--port {server.port}: cannot be had .*name another, or 0"):
        PageServer(port=server.port)
    with pytest.raises(AssessError, match="--port 70000"):
        PageServer(port=70000)


def test_an_environment_that_sets_the_port_is_an_error(monkeypatch):
    monkeypatch.setenv("_VISER_PORT_OVERRIDE", "8080")
    with pytest.raises(AssessError, match=r"_VISER_PORT_OVERRIDE: .*unset it"):
        PageServer()


def test_a_version_that_serves_otherwise_is_refused(monkeypatch):
    """Its server would answer everybody."""
    monkeypatch.setattr(room, "_guarded", lambda *_: nullcontext())
    with pytest.raises(AssessError, match=r"not made as in version 1\.1\.1"):
        PageServer()


def test_an_installation_without_viser_names_the_extra(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "viser", None)
    with pytest.raises(AssessError, match=r"rocking-assess\[serve\]"):
        PageServer()
