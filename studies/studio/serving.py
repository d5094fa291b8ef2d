"""The studio from the command line: a socket on this machine, the address with its code, the browser."""

from __future__ import annotations

import errno
import os
import signal
import socket
import threading
import webbrowser
from collections.abc import Callable
from ipaddress import ip_address
from pathlib import Path

from threadpoolctl import threadpool_limits

import studies
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.extras import check_extras
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.surface.fit_file import open_design

#: Port that is taken where it is free, and how many after it are tried.
USUAL_PORT, _PORTS = 8765, 20
#: Connections that are taken in one step, so that there are files left to close those that are too many.
_BACKLOG = 32
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


def _post(line: str) -> None:
    print(line, flush=True)  # the address is waited for, also behind a pipe


def serve_studio(
    design: DesignLike,
    *,
    port: int | None = None,
    host: str = "127.0.0.1",
    browser: bool = True,
    notify: Callable[[str], None] = _post,
) -> None:
    """Serve the studio until it is interrupted.

    Args:
        design: design that the page shows first: a design, the path of its file, or the name of a prototype.
        port: port to listen at, 0 to 65535, with 0 for any; by default 8765, or the next free port.
        host: address of this machine to listen at. Other machines can reach every address except those of the loopback,
            such as 127.0.0.1.
        browser: open the page in the browser of the user.
        notify: function that is called with each line for the user. The first line has the address of the page. The
            address contains a code that works once. When it was used, a line with another address follows.

    Raises:
        Refusal: a package is missing, no port is free, or the address is not one of this machine.
    """
    check_extras("the server of the page", "studio")
    is_visible = _is_visible(host)
    path = None if isinstance(design, ArrayDesign) or not Path(design).is_file() else Path(design)
    beside = None if path is None else path.resolve().parent
    design = resolve_design(design) if path is None else open_design(path)
    for variable in _THREADS:  # of the processes that follow; this one has its limits below
        os.environ.setdefault(variable, "1")
    import scipy.linalg  # loads BLAS, which is to have one thread
    import uvicorn

    from studies.studio.connections import bounded_protocol
    from studies.studio.server import MOST_MESSAGE, studio_app

    del scipy
    listening = _bound(host, port)
    number = listening.getsockname()[1]
    name = f"[{host}]" if ":" in host else host

    def address() -> str:
        return f"http://{name}:{number}/?code={guard.code}"

    guard = studies.studio.Guard(host, number, lambda: notify(f"Address for another browser: {address()}"))
    workplace = studies.studio.Workplace(beside, design)
    config = uvicorn.Config(
        studio_app(design, guard, workplace),
        http=bounded_protocol(),
        backlog=_BACKLOG,
        log_level="warning",
        server_header=False,
        lifespan="off",
        ws_max_size=MOST_MESSAGE,
        ws_ping_interval=10,
        ws_ping_timeout=20,
        timeout_graceful_shutdown=2,
    )
    server, ended = uvicorn.Server(config), list[int]()

    def end(number: int, frame: object) -> None:
        # Nothing is raised here: in the middle of an import that would leave its lock to nobody.
        ended.append(number)
        server.should_exit = True

    if threading.current_thread() is threading.main_thread():
        # Before the server runs, and when it hands the signal on: then what was written is still to be removed.
        signal.signal(signal.SIGTERM, end)
    try:
        with threadpool_limits(1):
            workplace.warm_up(design)
            notify(f"The studio of {design.name}: {address()}")
            notify("The address works once: give it to nobody. Ctrl-C ends.")
            if is_visible:
                notify("Other machines can reach it and nothing is encrypted: use it only in a network that you trust.")
            if browser:
                # A thread of its own: some browsers return only when the user leaves them, and the server runs below.
                threading.Thread(target=webbrowser.open, args=(address(),), daemon=True).start()
            server.run(sockets=[listening])
    except KeyboardInterrupt:
        pass  # the server also ends without it where Ctrl-C comes in its last steps
    finally:
        workplace.close()
        listening.close()
    if ended:
        raise SystemExit(128 + ended[0])
    notify("The studio has ended; pages keep their designs until it is there again.")


def _is_visible(host: str) -> bool:
    """True if other machines can reach an address.

    Raises:
        Refusal: it is not one address.
    """
    try:
        address = ip_address("127.0.0.1" if host == "localhost" else host)
    except ValueError:
        raise Refusal(
            kind=Kind.OUT_OF_RANGE, field="host", value=host, allowed="an IP address of this machine"
        ) from None
    if address.is_unspecified:
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="host",
            value=host,
            allowed="one address, because the studio answers to one name only",
        )
    return not address.is_loopback


def _bound(host: str, port: int | None) -> socket.socket:
    """A socket that is bound to the port, or to the usual one or one of the next."""
    if port is not None:
        check_range("port", port, 0, 65535, whole=True)
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    tried = [port] if port is not None else range(USUAL_PORT, USUAL_PORT + _PORTS)
    for number in tried:
        found = socket.socket(family)
        found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            found.bind((host, number))
            found.listen()  # whoever has read the address may come before the server does
        except OSError as error:
            found.close()
            if error.errno == errno.EADDRNOTAVAIL:
                raise Refusal(
                    kind=Kind.OUT_OF_RANGE, field="host", value=host, allowed="an IP address of this machine"
                ) from None
            reason = error.strerror
            continue
        return found
    raise Refusal(
        f"of {host} cannot be used: {reason}",
        kind=Kind.EXISTS,
        field="port",
        value=tried[0],
        remedy=("give another ", Field("port"), ", 0 for any"),
    )
