"""Access to the studio: for whoever had its address with the token, from its own page, by its own name."""

from __future__ import annotations

import hmac
import secrets
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import cookie_parser
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Port that browsers leave out of an address.
_HTTP = 80
#: Methods that change nothing: they need no Origin, which browsers leave out there.
_READING = {"GET", "HEAD"}


class Guard:
    """Keys of a studio and the names by which it may be called.

    Args:
        host: address that it listens at.
        port: of it.
        token: that the address of the page holds; by default one that nobody can guess.
    """

    def __init__(self, host: str, port: int, token: str | None = None) -> None:
        self.token = token or secrets.token_urlsafe(32)
        self._key = secrets.token_urlsafe(32)
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
        if not self.is_known(headers) and not self.has_token(scope):
            return "open the address that the studio printed when it was started: it holds the key"
        return ""

    def has_token(self, scope: Scope) -> bool:
        """True if the page is asked for with the token."""
        if scope["type"] != "http" or scope["path"] != "/" or scope["method"] != "GET":
            return False
        given = parse_qs(scope["query_string"].decode("ascii", "replace")).get("token", [""])[0]
        return hmac.compare_digest(given.encode(), self.token.encode())

    def is_known(self, headers: Headers) -> bool:
        """True if a request has the cookie."""
        # Other programs of this machine set cookies for the same name, and not only such as the standard knows.
        given = cookie_parser(headers.get("cookie", "")).get(self.cookie_name, "")
        return hmac.compare_digest(given.encode(), self._key.encode())

    @property
    def cookie(self) -> str:
        """The header that gives the cookie to a page."""
        return f"{self.cookie_name}={self._key}; Path=/; HttpOnly; SameSite=Strict"

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

        async def with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                headers.update(self._guard.headers)
                if not objection and self._guard.has_token(scope):
                    headers["set-cookie"] = self._guard.cookie
            await send(message)

        answer = PlainTextResponse(f"{objection}\n", 403) if objection else self._app
        await answer(scope, receive, with_headers if scope["type"] == "http" else send)


def _is_loopback(host: str) -> bool:
    return host in ("localhost", "::1") or host.startswith("127.")
