"""Clean roots: Debian systems with no more than their essential packages, made once and copied for each check.

A command in a root sees the root's files alone. It has no network unless it asks for it.
"""

import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from errors import ReleaseError
from paths import ROOTS

# What pip needs from this machine to reach its index: addresses, proxies, and files with certificates.
NETWORK_VARIABLES = ("PIP_INDEX_URL", "PIP_EXTRA_INDEX_URL", "PIP_TRUSTED_HOST", "PIP_PROXY", "http_proxy", "https_proxy", "no_proxy")
CERTIFICATE_VARIABLES = ("PIP_CERT", "SSL_CERT_FILE", "REQUESTS_CA_BUNDLE")
NETWORK_FILES = ("/etc/resolv.conf", "/etc/pip.conf")
NETWORK_HINT = "the roots come from the Debian mirror and NumPy from the Python package index: is there a network?"

# The mounts and processes are the command's own: they end with it.
ENTER = 'mount --types proc proc "$1/proc" && mount --rbind /dev "$1/dev" && exec chroot "$@"'


@dataclass(frozen=True)
class Answer:
    text: str
    seconds: float


@dataclass(frozen=True)
class Root:
    """A copy of a clean root that one check may change."""

    folder: Path
    system: str

    def path(self, inside: str) -> Path:
        return self.folder / inside.lstrip("/")

    def copy_in(self, source: Path, inside: str) -> None:
        target = self.path(inside)
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target)
        else:
            shutil.copyfile(source, target)

    def run(self, script: str, network: bool = False) -> Answer:
        """The standard output of a shell script in the home folder of the root."""
        variables = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LANG": "C.UTF-8", "COLUMNS": "100"}
        spaces = ["--mount", "--pid", "--ipc", "--fork", "--kill-child"]
        if network:
            variables |= self._hand_over_network()
        else:
            spaces.append("--net")
        command = ["unshare", *spaces, "--", "sh", "-euc", ENTER, "sh", str(self.folder), "/bin/sh", "-euc", f"cd /root\n{script}"]
        started = time.monotonic()
        done = subprocess.run(command, env=variables, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if done.returncode:
            last = "\n".join((done.stdout + done.stderr).splitlines()[-20:])
            hint = NETWORK_HINT if network else "the last lines of its output stand above"
            raise ReleaseError(f"{self.system}: status {done.returncode} of: {script}\n{last}", hint)
        return Answer(done.stdout, time.monotonic() - started)

    def files(self) -> set[str]:
        """The paths in the root, without those that dpkg and apt write for themselves."""
        own = ("proc/", "dev/", "var/lib/dpkg/", "var/lib/apt/", "var/cache/", "var/log/", "root/")
        paths = (str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))
        return {path for path in paths if not path.startswith(own)}

    def _hand_over_network(self) -> dict[str, str]:
        certificates = {name: os.environ[name] for name in CERTIFICATE_VARIABLES if Path(os.environ.get(name, "")).is_file()}
        for path in (*NETWORK_FILES, *certificates.values()):
            if Path(path).is_file():
                self.path(path).unlink(missing_ok=True)
                self.copy_in(Path(path), path)
        return certificates | {name: os.environ[name] for name in NETWORK_VARIABLES if name in os.environ}


def refuse_without_means() -> None:
    if os.geteuid():
        raise ReleaseError("clean roots are entered by chroot, which only root may do", "run it as root, or leave the roots out: --without-roots")
    for program, package in (("mmdebstrap", "mmdebstrap"), ("unshare", "util-linux"), ("chroot", "coreutils")):
        if shutil.which(program) is None:
            raise ReleaseError(f"{program} is not on the PATH", f"apt-get install {package}, or leave the roots out: --without-roots")


def prepared(suite: str, packages: tuple[str, ...]) -> Path:
    """The clean root of a Debian release with these packages more; made where it is missing."""
    root = ROOTS / "-".join((suite, *packages))
    if not root.is_dir():
        ROOTS.mkdir(parents=True, exist_ok=True)
        unfinished = root.with_suffix(".unfinished")
        shutil.rmtree(unfinished, ignore_errors=True)
        command = ["mmdebstrap", "--variant=minbase", *(f"--include={name}" for name in packages), suite, str(unfinished)]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if done.returncode:
            shutil.rmtree(unfinished, ignore_errors=True)
            last = "\n".join(line for line in done.stderr.splitlines()[-12:] if not line.startswith("I:"))
            raise ReleaseError(f"mmdebstrap made no root of Debian {suite}\n{last}", NETWORK_HINT)
        unfinished.rename(root)
    return root


@contextmanager
def clean_root(suite: str, packages: tuple[str, ...] = ()) -> Iterator[Root]:
    """A copy of the clean root, which is gone afterwards."""
    base = prepared(suite, packages)
    with tempfile.TemporaryDirectory(prefix="copy-", dir=ROOTS) as folder:
        copy = Path(folder) / "root"
        subprocess.run(["cp", "--archive", "--reflink=auto", str(base), str(copy)], check=True)
        root = Root(copy, f"Debian {(base / 'etc/debian_version').read_text(encoding='utf-8').strip()} ({suite})")
        refuse_compilers(root)
        yield root


def refuse_compilers(root: Root) -> None:
    """A root with a compiler would show nothing."""
    found = root.run("for name in cc gcc clang rustc cargo; do command -v $name || true; done").text.split()
    if found:
        raise ReleaseError(f"{root.system} has {' '.join(found)}", f"delete {ROOTS}: it is made again")
