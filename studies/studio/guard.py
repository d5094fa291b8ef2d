"""Access to the studio: for a browser that has used its address once, from its own page, by its own name.

The address that the studio prints holds a code that works once. Whoever uses it gets a cookie and a secret. The cookie
opens the files of the page, which are no secret. Everything else needs the secret too. Browsers send cookies to every
port of a machine, but the secret stays in the storage of the page, which programs at other ports cannot read.
"""

from __future__ import annotations

import hmac
import secrets
from collections.abc import Callable
from typing import Any
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import cookie_parser
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Port that browsers leave out of an address.
_HTTP = 80
#: Methods that change nothing: they need no Origin, which browsers leave out there.
_READING = {"GET", "HEAD"}
#: Header of a request with the secret, and place in a scope of the one that is handed out with the page.
SECRET_HEADER, SECRET = "x-studio-secret", "studio.secret"
#: Files of the page, which the cookie alone opens; made files, whose addresses nobody can guess.
_PAGE, _MADE = {"/", "/studio.js", "/studio.css"}, "/files/"
#: Browsers that are remembered; the one that came first is forgotten first.
_BROWSERS = 64
_LOCKED = "open the address that the studio printed last: it holds the key, which works once"


class Guard:
    """Keys of a studio and the names by which it may be called.

    Args:
        host: address that it listens at.
        port: of it.
        renewed: called when the code was used and there is another one.
    """

    def __init__(self, host: str, port: int, renewed: Callable[[], None] = lambda: None) -> None:
        self.code = secrets.token_urlsafe(32)
        self._renewed = renewed
        self._secrets: dict[str, str] = {}
        self.cookie_name = f"acoustic-fem-studio-{port}"
        names = {host, "127.0.0.1", "localhost", "::1"} if _is_loopback(host) else {host}
        bare = {f"[{name}]" if ":" in name else name for name in names}
        self._hosts = {f"{name}:{port}" for name in bare} | (bare if port == _HTTP else set())
        self._origins = {f"http://{name}" for name in self._hosts}

    def objection(self, scope: Scope) -> str:
        """Why a request is refused; empty where it is not."""
        headers = Headers(scope=scope)
        if headers.get("host", "") not in self._hosts:
            return "this studio is not called by that name"
        origin = headers.get("origin")
        is_reading = scope["type"] == "http" and scope["method"] in _READING
        if (origin is not None or not is_reading) and origin not in self._origins:
            return "another page may not speak with this studio"
        if self.has_code(scope):
            return ""
        if self._secret_of(headers) is None:
            return _LOCKED
        is_open = scope["type"] == "websocket" or scope["path"] in _PAGE or scope["path"].startswith(_MADE)
        # The first message over a websocket holds the secret, because browsers send no header of the page there.
        return "" if is_open or self.is_page(headers, headers.get(SECRET_HEADER)) else _LOCKED

    def has_code(self, scope: Scope) -> bool:
        """True if the page is asked for with the code."""
        if scope["type"] != "http" or scope["path"] != "/" or scope["method"] != "GET":
            return False
        given = parse_qs(scope["query_string"].decode("ascii", "replace")).get("code", [""])[0]
        return _is_same(given, self.code)

    def admit(self) -> tuple[str, str]:
        """The header that gives a cookie to a browser, and the secret of its pages. The code does not work again."""
        key, secret = secrets.token_urlsafe(32), secrets.token_urlsafe(32)
        self._secrets[key] = secret
        if len(self._secrets) > _BROWSERS:
            del self._secrets[next(iter(self._secrets))]
        self.code = secrets.token_urlsafe(32)
        self._renewed()
        return f"{self.cookie_name}={key}; Path=/; HttpOnly; SameSite=Strict", secret

    def is_page(self, headers: Headers, secret: Any) -> bool:
        """True if a request with the cookie holds the secret that belongs to it."""
        own = self._secret_of(headers)
        return own is not None and isinstance(secret, str) and _is_same(secret, own)

    def _secret_of(self, headers: Headers) -> str | None:
        """The secret that belongs to the cookie of a request; None if that is not one of ours."""
        # Other programs of this machine set cookies for the same name, and not only such as the standard knows.
        given = cookie_parser(headers.get("cookie", "")).get(self.cookie_name, "")
        return next((secret for key, secret in self._secrets.items() if _is_same(given, key)), None)

    @property
    def headers(self) -> dict[str, str]:
        """Headers of every answer: nothing from elsewhere, no scripts but ours, in no frame, kept by nobody."""
        # Browsers know no addresses in brackets there; for these 'self' must do.
        sockets = " ".join(f"ws://{name}" for name in sorted(self._hosts) if "[" not in name)
        return {
            "content-security-policy": "default-src 'none'; script-src 'self'; style-src 'self'; "
            f"img-src 'self' data: blob:; connect-src 'self' {sockets}; base-uri 'none'; form-action 'none'; "
            "frame-ancestors 'none'",
            "x-content-type-options": "nosniff",
            "referrer-policy": "no-referrer",
            "cross-origin-opener-policy": "same-origin",
            "cross-origin-resource-policy": "same-origin",
            "cache-control": "no-store",
        }


class Guarded:
    """Application behind a guard: nothing of it is reached by whom the guard refuses.

    Args:
        app: what is guarded.
        guard: who decides.
    """

    def __init__(self, app: ASGIApp, guard: Guard) -> None:
        self._app, self._guard = app, guard

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request, or refuse it: 403 over HTTP, no handshake for a websocket."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        objection = self._guard.objection(scope)
        if objection and scope["type"] == "websocket":
            await receive()
            await send({"type": "websocket.close", "code": 1008, "reason": objection})
            return
        given = self._guard.headers
        if not objection and self._guard.has_code(scope):
            given["set-cookie"], scope[SECRET] = self._guard.admit()

        async def with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                MutableHeaders(scope=message).update(given)
            await send(message)

        answer = PlainTextResponse(f"{objection}\n", 403) if objection else self._app
        await answer(scope, receive, with_headers if scope["type"] == "http" else send)


def _is_same(given: str, own: str) -> bool:
    return hmac.compare_digest(given.encode("utf-8", "replace"), own.encode())


def _is_loopback(host: str) -> bool:
    return host in ("localhost", "::1") or host.startswith("127.")
