"""The programs that build a release, in target/release-tools: nothing outside the repository is touched.

maturin, Zig and cargo-zigbuild come as Python packages (requirements.txt); cargo-deb is compiled, in about a minute.
"""

import platform
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from errors import ReleaseError
from paths import REPOSITORY, TOOLS

REQUIREMENTS = Path(__file__).with_name("requirements.txt")
CARGO_DEB_VERSION = "3.8.0"


@dataclass(frozen=True)
class Tools:
    python: Path
    cargo_deb: Path

    def environment(self, variables: dict[str, str]) -> dict[str, str]:
        """`variables`, with these tools first on the PATH and the caches of Zig among them."""
        return variables | {
            "PATH": f"{self.python.parent}:{variables.get('PATH', '')}",
            "ZIG_GLOBAL_CACHE_DIR": str(TOOLS / "zig-cache"),
            "CARGO_ZIGBUILD_CACHE_DIR": str(TOOLS / "zigbuild-cache"),
        }


def install_python_tools() -> Path:
    python = TOOLS / "python/bin/python"
    # The stamp holds what was installed and for which interpreter, so that a second run costs nothing.
    stamp, wanted = TOOLS / "python/installed", sys.version + REQUIREMENTS.read_text(encoding="utf-8")
    if not stamp.is_file() or stamp.read_text(encoding="utf-8") != wanted:
        subprocess.run([sys.executable, "-m", "venv", "--clear", str(TOOLS / "python")], check=True)
        subprocess.run([str(python), "-m", "pip", "install", "--quiet", "--requirement", str(REQUIREMENTS)], check=True)
        stamp.write_text(wanted, encoding="utf-8")
    return python


def install_cargo_deb() -> Path:
    program = TOOLS / "bin/cargo-deb"
    if program.is_file():
        found = subprocess.run([str(program), "--version"], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
        if found == CARGO_DEB_VERSION:
            return program
    command = ["cargo", "install", "cargo-deb", "--quiet", "--locked", "--version", CARGO_DEB_VERSION, "--no-default-features", "--debug"]
    command += ["--root", str(TOOLS), "--target-dir", str(TOOLS / "cargo-deb-target"), "--force"]
    subprocess.run(command, cwd=REPOSITORY, check=True)
    return program


def prepare() -> Tools:
    if (platform.system(), platform.machine()) != ("Linux", "x86_64"):
        raise ReleaseError(
            f"a release is built on Linux on x86-64; this is {platform.system()} on {platform.machine()}",
            "docs/release.md says what is known of other platforms",
        )
    for program, hint in (("cargo", "install Rust from https://rustup.rs"), ("cc", "apt-get install gcc libc6-dev"), ("git", "apt-get install git")):
        if shutil.which(program) is None:
            raise ReleaseError(f"{program} is not on the PATH", hint)
    TOOLS.mkdir(parents=True, exist_ok=True)
    return Tools(install_python_tools(), install_cargo_deb())
