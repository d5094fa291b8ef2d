"""Hosts of a cluster on one machine: network namespaces with an address each, joined by a bridge.

All but the first have folders of their own for homes and temporary files too, and share with the others the programs,
which nobody writes to, and one folder. They are made without privileges, in a user namespace, end with this process,
and change nothing of the machine's own network.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

PATIENCE = 600.0
"""Time for what takes seconds on an idle machine, s."""
ROOT = Path(__file__).parents[2]
#: Folders beside those of the user that programs write to, and one of the system's that is empty.
_WRITTEN, _ASIDE = ("/tmp", "/var/tmp", "/dev/shm"), "/mnt"
_QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}


class NoHosts(Exception):
    """The machine makes no network namespaces; the reason."""


def wait_for(condition: Callable[[], object], *needed: subprocess.Popen[bytes]) -> None:
    """Wait until something is so, for as long as the processes live that it needs."""
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "waited too long"
        for process in needed:
            assert process.poll() is None, f"{process.args!r} ended by itself"
        time.sleep(0.02)


def _own_folders(shared: Path) -> str:
    """Commands of a shell that lay empty folders over all that is written to, but for what hosts share."""
    own = [path for path in {Path.home(), Path(tempfile.gettempdir()), *map(Path, _WRITTEN)} if path.is_dir()]
    kept = [path for path in (Path(sys.base_prefix), Path(sys.prefix), ROOT, shared) if not path.is_relative_to(_ASIDE)]
    lines = [f"mount -t tmpfs tmpfs {_ASIDE}"]
    for number, path in enumerate(kept):
        lines += [f"mkdir {_ASIDE}/{number}", f"mount --rbind {shlex.quote(str(path))} {_ASIDE}/{number}"]
    lines += [f"mount -t tmpfs tmpfs {shlex.quote(str(path))}" for path in sorted(own) if path != Path("/")]
    for number, path in enumerate(kept):
        if any(path.is_relative_to(each) for each in own):
            place = shlex.quote(str(path))
            lines += [f"mkdir -p {place}", f"mount --rbind {_ASIDE}/{number} {place}"]
    return "\n".join([*lines, "exec cat"])


class Host:
    """Namespace with its own address.

    Args:
        inside: what runs a command in its namespace.
        address: IPv4.
    """

    def __init__(self, inside: list[str], address: str) -> None:
        self.inside, self.address = inside, address

    def start(self, *arguments: str, told: bool = False, **more: str) -> subprocess.Popen[bytes]:
        """A Python program on this host, with more variables in its environment; what it tells is kept or lost."""
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} if told else _QUIET
        paths = [path for path in (more.pop("PYTHONPATH", ""), str(ROOT)) if path]
        environment = {**os.environ, **more, "PYTHONPATH": os.pathsep.join(paths)}
        return subprocess.Popen([*self.inside, sys.executable, *arguments], env=environment, **streams)


class Hosts:
    """Bridge with hosts, the first of which holds it.

    Args:
        count: of hosts.
        shared: the folder that all see.

    Raises:
        NoHosts: this machine makes none.
    """

    def __init__(self, count: int, shared: Path) -> None:
        missing = [name for name in ("unshare", "nsenter", "ip", "mount") if shutil.which(name) is None]
        if missing:
            raise NoHosts(f"{' and '.join(missing)} not found")
        allowed = ["unshare", "--user", "--map-root-user", "--net", "--mount", "mount", "-t", "tmpfs", "tmpfs", _ASIDE]
        if subprocess.run(allowed, check=False, **_QUIET).returncode:
            raise NoHosts(f"not allowed here: {' '.join(allowed)}")
        self._held: list[subprocess.Popen[bytes]] = []
        self.hosts: list[Host] = []
        try:
            first = self._namespace([], "exec cat", "--user", "--map-root-user")
            self._inside(first, "ip", "link", "set", "lo", "up")
            self._inside(first, "ip", "link", "add", "bridge", "type", "bridge")
            self._inside(first, "ip", "addr", "add", "10.77.0.1/24", "dev", "bridge")
            self._inside(first, "ip", "link", "set", "bridge", "up")
            self.hosts.append(Host(first, "10.77.0.1"))
            for number in range(2, count + 1):
                own, address = self._namespace(first, _own_folders(shared)), f"10.77.0.{number}"
                place = str(self._held[-1].pid)
                self._inside(first, *f"ip link add port{number} type veth peer name eth0 netns {place}".split())
                self._inside(first, *f"ip link set port{number} master bridge up".split())
                for line in ("link set lo up", f"addr add {address}/24 dev eth0", "link set eth0 up"):
                    self._inside(own, "ip", *line.split())
                self.hosts.append(Host(own, address))
        except (NoHosts, RuntimeError):
            self.close()
            raise

    def link(self, host: Host, state: str) -> None:
        """Set the cable of a host, not the first, "up" or "down"."""
        self._inside(self.hosts[0].inside, "ip", "link", "set", f"port{self.hosts.index(host) + 1}", state)

    def close(self) -> None:
        """End all hosts."""
        for process in self._held:
            process.kill()
            process.wait()

    def _namespace(self, inside: list[str], prepare: str, *more: str) -> list[str]:
        """What runs a command in a new namespace, which lasts until this process ends or closes it."""
        words = [*inside, "unshare", "--net", "--mount", *more, "sh", "-ec", prepare]
        holder = subprocess.Popen(words, stdin=subprocess.PIPE, **_QUIET)
        self._held.append(holder)
        own, place = os.readlink("/proc/self/ns/net"), Path(f"/proc/{holder.pid}/comm")
        others = {own, *(os.readlink(f"/proc/{each.pid}/ns/net") for each in self._held[:-1])}
        while place.read_text().strip() != "cat" or os.readlink(f"/proc/{holder.pid}/ns/net") in others:
            if holder.poll() is not None:
                raise RuntimeError(f"a host ended while it was prepared, with {holder.returncode}:\n{prepare}")
            time.sleep(0.01)
        return ["nsenter", "--target", str(holder.pid), "--user", "--net", "--mount", "--preserve-credentials"]

    def _inside(self, inside: list[str], *command: str) -> None:
        done = subprocess.run([*inside, *command], capture_output=True, text=True, check=False)
        if done.returncode:
            raise NoHosts(f"{' '.join(command)}: {done.stderr.strip()}")
