"""The studio over HTTP and a websocket: the page, models, files that are handed out, designs that are handed in."""

from __future__ import annotations

import asyncio
import json
import traceback
from collections.abc import Awaitable
from importlib import resources
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.types import ASGIApp
from starlette.websockets import WebSocket, WebSocketDisconnect, WebSocketState

import studies.studio as here
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from studies.studio.guard import SECRET, Guard, Guarded
from studies.studio.messages import MessageError, packed_signals, read_message, written
from studies.studio.page_words import MOST_UPLOAD, page_words
from studies.studio.sessions import Sessions
from studies.studio.stage import MISTAKE
from studies.studio.workplace import Workplace

#: Largest recording and recognizer that are taken, and largest message of a page, bytes.
MOST_RECORDING, MOST_RECOGNIZER, MOST_MESSAGE = 32 * 1024**2, 16 * 1024**2, 1024**2
#: Largest file of a body that is taken, bytes.
MOST_BODY = 64 * 1024**2
#: Seconds within which a page proves itself over its websocket, and within which a part of an upload follows another.
PROOF_WITHIN, PART_WITHIN = 5.0, 10.0
#: Websockets that may wait for that proof; beyond, the one that has waited longest is closed.
MOST_UNPROVEN = 16
#: Where the secret is put into the page for a browser that has just used the code.
_PLACE = b'<meta charset="utf-8">'
#: Files of the page by their addresses, with what they are.
_PAGE = {
    "/": ("index.html", "text/html; charset=utf-8"),
    "/studio.js": ("studio.js", "text/javascript; charset=utf-8"),
    "/studio.css": ("studio.css", "text/css; charset=utf-8"),
}


def studio_app(design: ArrayDesign, guard: Guard, workplace: Workplace) -> ASGIApp:
    """The application of a studio, behind its guard.

    Args:
        design: that a new page begins with.
        guard: who may speak with it.
        workplace: where jobs are done; whoever made it closes it.
    """
    sessions = Sessions(design, workplace)
    unproven: list[asyncio.Timeout] = []

    async def model(request: Request) -> Response:
        content = workplace.model_file(request.path_params["key"])
        if content is None:
            return PlainTextResponse("no such model\n", 404)
        return Response(content, media_type="model/gltf-binary")

    async def file(request: Request) -> Response:
        session = sessions.find(request.path_params["session"])
        files = session.exports.files if session is not None else {}
        path, name = files.get(request.path_params["key"], (None, ""))
        if path is None or not Path(path).is_file():
            return PlainTextResponse("no such file\n", 404)
        return FileResponse(path, filename=name)

    async def upload(request: Request) -> Response:
        text, name = await _text_file(request, "design.toml")
        if isinstance(text, Response):
            return text
        places = None
        if request.query_params.get("places"):  # the design and its file of places, one behind the other
            try:
                text, own = (str(each) for each in json.loads(text))
            except (ValueError, TypeError, RecursionError):
                return _refused("must be a list of two texts", 400)
            places = (request.query_params["places"][:100], own)
        found = await _handed_in(workplace.upload(text, name, places))
        return found if isinstance(found, Response) else JSONResponse(found)

    async def recording(request: Request) -> Response:
        found = sessions.find(request.query_params.get("session"))
        if found is None:
            return _refused("there is no such session", 404)
        content = await _body(request, MOST_RECORDING, f"the recording must be at most {MOST_RECORDING // 1024**2} MB")
        if isinstance(content, Response):
            return content
        name, scale = (
            request.query_params.get("name", "recording.wav")[:100],
            request.query_params.get("full_scale", "1"),
        )
        try:
            full_scale = float(scale)
        except ValueError:
            return _refused(f"full_scale = {scale[:40]!r} must be a number of pascals", 400)
        revision = found.state.revision
        asked = (content, name, full_scale)
        decoded = await _handed_in(found.touches.replay(found.state.design, revision, asked))
        if isinstance(decoded, Response):
            return decoded
        return Response(
            packed_signals({"stage": "touch", "revision": revision, "touched": None, "kind": name}, decoded)
        )

    async def manifest(request: Request) -> Response:
        text, name = await _text_file(request, "touches.toml")
        if isinstance(text, Response):
            return text
        found = await _handed_in(workplace.manifest_scale(text, name))
        return found if isinstance(found, Response) else JSONResponse({"full_scale": found})

    async def recognizer(request: Request) -> Response:
        found = sessions.find(request.query_params.get("session"))
        if found is None:
            return _refused("there is no such session", 404)
        content = await _body(
            request, MOST_RECOGNIZER, f"the recognizer must be at most {MOST_RECOGNIZER // 1024**2} MB"
        )
        if isinstance(content, Response):
            return content
        about = await _handed_in(workplace.recognizer(content))
        if isinstance(about, Response):
            return about
        found.touches.take_recognizer(about.pop("folder"))
        return JSONResponse(about)

    async def body(request: Request) -> Response:
        found = sessions.find(request.query_params.get("session"))
        if found is None:
            return _refused("there is no such session", 404)
        content = await _body(request, MOST_BODY, f"the body must be at most {MOST_BODY // 1024**2} MB")
        if isinstance(content, Response):
            return content
        path = await _handed_in(workplace.keep_body(content, request.query_params.get("name", "body")))
        if isinstance(path, Response):
            return path
        found.fitting.take_body(path)
        return JSONResponse({"name": path.name})

    async def shape(request: Request) -> Response:
        content = workplace.shape_file(request.path_params["key"])
        if content is None:
            return PlainTextResponse("no such body\n", 404)
        return Response(content, media_type="application/octet-stream")

    async def session(socket: WebSocket) -> None:
        await _hold(socket, sessions, guard, unproven)

    pages = [Route(address, _page(*what), methods=["GET"]) for address, what in _PAGE.items()]
    app = Starlette(
        routes=[
            *pages,
            Route("/models/{key}.glb", model, methods=["GET"]),
            Route("/files/{session}/{key}", file, methods=["GET"]),
            Route("/designs", upload, methods=["POST"]),
            Route("/recordings", recording, methods=["POST"]),
            Route("/manifests", manifest, methods=["POST"]),
            Route("/recognizers", recognizer, methods=["POST"]),
            Route("/bodies", body, methods=["POST"]),
            Route("/bodies/{key}", shape, methods=["GET"]),
            WebSocketRoute("/session", session),
        ]
    )
    return Guarded(app, guard)


async def _body(request: Request, most: int, too_long: str) -> bytes | Response:
    """Content that is handed in, or a refusal as soon as it is more than ``most`` bytes or does not go on."""
    content, parts = bytearray(), request.stream()
    while True:
        try:
            async with asyncio.timeout(PART_WITHIN):
                content += await anext(parts)
        except StopAsyncIteration:
            return bytes(content)
        except TimeoutError:
            return _refused(f"the upload did not go on for {PART_WITHIN:g} s", 408)
        if len(content) > most:
            return _refused(too_long, 413)


async def _text_file(request: Request, usual: str) -> tuple[str | Response, str]:
    """Text of a file that is handed in, or a refusal, and its name."""
    name = request.query_params.get("name", usual)[:100]
    content = await _body(request, MOST_UPLOAD, f"the file must be at most {MOST_UPLOAD // 1024} kB")
    if isinstance(content, Response):
        return content, name
    try:
        return content.decode("utf-8"), name
    except UnicodeDecodeError:
        return _refused(f"{name}: is not a text in UTF-8", 400), name


async def _handed_in(work: Awaitable[Any]) -> Any:
    """Result of some uploaded content, or an answer that says why there is none."""
    try:
        return await work
    except Refusal as error:
        return _refused(str(error), 400)
    except OSError as error:  # such as a full disk
        return _refused(f"what was handed in could not be kept: {error.strerror or error}; the design is kept", 507)
    except Exception:
        traceback.print_exc()
        return _refused(MISTAKE, 500)


def _refused(message: str, status: int) -> Response:
    return JSONResponse({"message": message}, status)


def _page(name: str, kind: str) -> Any:
    content = (resources.files(here) / "static" / name).read_bytes()

    async def answer(request: Request) -> Response:
        secret = request.scope.get(SECRET)
        shown = content
        if secret is not None:
            shown = content.replace(_PLACE, _PLACE + f'\n<meta name="secret" content="{secret}">'.encode(), 1)
        return Response(shown, headers={"content-type": kind})

    return answer


async def _first_message(socket: WebSocket, guard: Guard, unproven: list[asyncio.Timeout]) -> dict[str, Any] | None:
    """The first message of a page, which holds its secret; None if it does not come soon or the secret is wrong."""
    try:
        async with asyncio.timeout(PROOF_WITHIN) as waits:
            unproven.append(waits)
            if len(unproven) > MOST_UNPROVEN:
                unproven[0].reschedule(0.0)
            try:
                message = read_message(await _text(socket))
            finally:
                unproven.remove(waits)
    except (TimeoutError, MessageError):
        return None
    return message if guard.is_page(socket.headers, message.get("secret")) else None


async def _hold(socket: WebSocket, sessions: Sessions, guard: Guard, unproven: list[asyncio.Timeout]) -> None:
    """One page from its first message to its last."""
    await socket.accept()
    try:
        first = await _first_message(socket, guard, unproven)
    except WebSocketDisconnect:
        return
    if first is None:
        await socket.close(1008, "the first message must hold the secret of the page")
        return

    async def send(message: str | bytes) -> None:
        try:
            if isinstance(message, bytes):
                await socket.send_bytes(message)
            else:
                await socket.send_text(message)
        except (WebSocketDisconnect, RuntimeError):  # gone; its session finds out when it reads next
            pass

    session = None
    try:
        # A message that could not be sent closes the link here, with nothing more to be read.
        while socket.application_state == WebSocketState.CONNECTED:
            try:
                message = read_message(await _text(socket)) if first is None else first
                first = None
                if message.get("do") == "ping":
                    await send('{"type":"pong"}')
                elif session is None:
                    session, new = sessions.enter(message.get("session"), message.get("page"))
                    await send(written({"type": "words", **page_words(), "new": new}))
                    values = message.get("values")
                    if new and isinstance(values, dict):
                        await session.restore_quietly(values, message.get("saved") is True, send)
                    await session.join(send)
                else:
                    await session.take(message)
            except MessageError as error:
                await send(written({"type": "error", "message": str(error)}))
            except WebSocketDisconnect:
                raise
            except Exception:  # the page would send again and again what ended its link
                traceback.print_exc()
                await send(written({"type": "error", "message": MISTAKE}))
    except WebSocketDisconnect:
        pass
    finally:
        if session is not None:
            session.leave(send)


async def _text(socket: WebSocket) -> str:
    try:
        return await socket.receive_text()
    except KeyError:
        raise MessageError("a message must be a text", kind=Kind.WRONG_TYPE) from None
