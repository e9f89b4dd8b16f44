"""What the files of a release must be: their sizes, the glibc that they need, what their names say of it."""

import re
import shutil
import subprocess
import tempfile
import zipfile
from pathlib import Path

from build import GLIBC, WHEEL_PLATFORM
from errors import ReleaseError
from paths import released

# In bytes. The wheel's is a promise to those who download it; the others are a tenth more than was measured (docs/release.md).
MAX_BYTES = {
    "loosepin-*.whl": 9_000_000,
    "loosepin-*.tar.gz": 14_000_000,
    "loosepin_*.deb": 10_000_000,
    "loosepin": 28_000_000,
}


def sizes() -> list[tuple[str, int, int]]:
    """Name, size and limit of each file that has one."""
    files = [(released(pattern), limit) for pattern, limit in MAX_BYTES.items()]
    found = [(path.name, path.stat().st_size, limit) for path, limit in files]
    for name, size, limit in found:
        if size > limit:
            raise ReleaseError(f"{name} has {size} bytes; must be at most {limit}", "find what has grown; the limits stand in tools/release/check.py")
    return found


def printed_by(*command: str | Path) -> str:
    if shutil.which(command[0]) is None:
        raise ReleaseError(f"{command[0]} is not on the PATH", "apt-get install binutils dpkg")
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE, text=True).stdout


def glibc_needed(binary: Path) -> tuple[int, ...]:
    """The highest version of glibc whose symbols a binary asks for."""
    versions = re.findall(r"\(GLIBC_([\d.]+)\)", printed_by("objdump", "-T", binary))
    return max(tuple(int(part) for part in version.split(".")) for version in versions)


def require_glibc(name: str, binary: Path) -> str:
    needed, stated = glibc_needed(binary), tuple(int(part) for part in GLIBC.split("."))
    shown = ".".join(str(part) for part in needed)
    if needed > stated:
        raise ReleaseError(f"{name} needs glibc {shown}; must be at most {GLIBC}", "which symbols: objdump -T")
    return shown


def glibc() -> dict[str, str]:
    """The version of glibc that the program and the module of the wheel need; the names of wheel and package must say no other."""
    wheel, package, program = released("loosepin-*.whl"), released("loosepin_*.deb"), released("loosepin")
    if f"-{WHEEL_PLATFORM}." not in wheel.name:
        raise ReleaseError(f"the wheel's name is {wheel.name}; must end with {WHEEL_PLATFORM}.whl", "maturin names it: tools/release/build.py")
    depends = printed_by("dpkg-deb", "--field", package, "Depends").strip()
    if depends != f"libc6 (>= {GLIBC})":
        raise ReleaseError(f"{package.name} depends on {depends}; must be libc6 (>= {GLIBC})", "it stands in crates/loosepin-cli/Cargo.toml")
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(wheel) as packed:
        [module] = [name for name in packed.namelist() if name.endswith(".so")]
        return {
            "loosepin": require_glibc("loosepin", program),
            wheel.name: require_glibc(wheel.name, Path(packed.extract(module, folder))),
        }
