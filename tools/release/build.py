"""Builds the files of a release from a commit: program, archive, wheel, Debian package, manual pages, completions.

The sources are taken from git into a folder of their own, so that nothing else of the working tree enters. Zig is the linker and the C
compiler: it links against the symbols of an old glibc, whatever glibc this machine has.
"""

import os
import shutil
import subprocess
import tarfile
import tomllib
from io import BytesIO
from pathlib import Path

import archive
from paths import REPOSITORY
from toolchain import Tools

# The oldest glibc that program and wheel run with: that of Debian 10, Ubuntu 18.10 and Red Hat Enterprise Linux 8. It is the name of the wheel's
# platform and the Debian package's dependency too; check.py compares them.
GLIBC = "2.28"
TARGET = "x86_64-unknown-linux-gnu"
WHEEL_PLATFORM = f"manylinux_{GLIBC.replace('.', '_')}_x86_64"

SHELLS = ("bash", "zsh", "fish", "powershell", "elvish")
COMMIT_DIGITS = 10


def output(*command: str | Path, cwd: Path | None = None) -> bytes:
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE, cwd=cwd).stdout


def git(*arguments: str) -> str:
    return output("git", *arguments, cwd=REPOSITORY).decode().strip()


def compiler_flags(sources: Path) -> list[str]:
    """The flags of every build of these sources."""
    return tomllib.loads((sources / ".cargo/config.toml").read_text())["build"]["rustflags"]


def environment(folder: Path, commit: str, tools: Tools) -> dict[str, str]:
    """What makes the bytes depend on the commit and the tools alone."""
    sources, target = folder / "sources", folder / "target"
    cargo_home = Path(os.environ.get("CARGO_HOME", Path.home() / ".cargo"))
    places = ((sources, "/loosepin"), (target, "/target"), (cargo_home, "/cargo"))
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("CARGO_PROFILE", "RUSTFLAGS", "CARGO_BUILD_RUSTFLAGS"))}
    return tools.environment(kept) | {
        "CARGO_TARGET_DIR": str(target),
        "CARGO_INCREMENTAL": "0",
        "CARGO_PROFILE_RELEASE_DEBUG": "false",
        "CARGO_PROFILE_RELEASE_STRIP": "symbols",
        # Flags of the environment replace those of the repository.
        "CARGO_ENCODED_RUSTFLAGS": "\x1f".join(compiler_flags(sources) + [f"--remap-path-prefix={place}={name}" for place, name in places]),
        "CFLAGS": " ".join(f"-ffile-prefix-map={place}={name}" for place, name in places),
        "LOOSEPIN_COMMIT": commit[:COMMIT_DIGITS],
        "SOURCE_DATE_EPOCH": git("log", "-1", "--format=%ct", commit),
        "ZERO_AR_DATE": "1",
    }


def built_program(sources: Path, target: Path, variables: dict[str, str]) -> Path:
    command = ("cargo", "zigbuild", "--release", "--locked", "--package", "loosepin-cli", "--target", f"{TARGET}.{GLIBC}")
    subprocess.run(command, cwd=sources, env=variables, check=True)
    return target / TARGET / "release/loosepin"


def built_wheel(sources: Path, wheels: Path, variables: dict[str, str], tools: Tools) -> Path:
    shutil.rmtree(wheels, ignore_errors=True)
    command = [tools.python, "-m", "maturin", "build", "--profile", "wheel", "--locked", "--zig", "--target", TARGET, "--interpreter", tools.python]
    command += ["--compatibility", WHEEL_PLATFORM.removesuffix("_x86_64"), "--out", wheels]
    # Level 6, the default, gives a wheel of 9.2 MB instead of 8.9 MB.
    command += ["--compression-level", "9"]
    subprocess.run([str(part) for part in command], cwd=sources / "crates/loosepin-python", env=variables, check=True)
    [wheel] = wheels.glob("*.whl")
    return wheel


def pages(program: Path) -> dict[str, bytes]:
    """Manual pages and completions, as the program writes them."""
    listed = output(program, "--help").decode().split("Commands:\n")[1].split("\n\n")[0]
    commands = [line.split()[0] for line in listed.splitlines() if line.startswith("  ") and not line.startswith("   ")]
    files = {f"completions/loosepin.{shell}": output(program, "completions", shell) for shell in SHELLS}
    files["man/loosepin.1"] = output(program, "manual")
    return files | {f"man/loosepin-{command}.1": output(program, "manual", command) for command in commands}


def built_package(program: Path, written: dict[str, bytes], sources: Path, variables: dict[str, str], tools: Tools) -> Path:
    """The Debian package; its files are listed in crates/loosepin-cli/Cargo.toml."""
    manual = {f"{name}.gz": archive.compressed(content) for name, content in written.items() if name.startswith("man/")}
    completions = {name: content for name, content in written.items() if name.startswith("completions/")}
    changes = {"CHANGELOG.md.gz": archive.compressed((sources / "CHANGELOG.md").read_bytes())}
    for name, content in (manual | completions | changes).items():
        path = program.parent / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(content)
    packages = program.parents[1] / "packages"
    shutil.rmtree(packages, ignore_errors=True)
    command = [tools.cargo_deb, "--no-build", "--no-strip", "--locked", "--package", "loosepin-cli", "--target", TARGET, "--output", packages]
    subprocess.run([str(part) for part in command], cwd=sources, env=variables, check=True)
    [package] = packages.glob("*.deb")
    return package


def build(folder: Path, commit: str, tools: Tools, quick: bool) -> dict[str, bytes]:
    """The files of a release by their names."""
    sources, target = folder / "sources", folder / "target"
    shutil.rmtree(sources, ignore_errors=True)
    sources.mkdir(parents=True)
    with tarfile.open(fileobj=BytesIO(output("git", "archive", commit, cwd=REPOSITORY))) as committed:
        committed.extractall(sources, filter="data")
    variables = environment(folder, commit, tools)
    if quick:
        variables["CARGO_PROFILE_RELEASE_OPT_LEVEL"] = "0"
    program = built_program(sources, target, variables)
    wheel = built_wheel(sources, folder / "wheels", variables, tools)
    written = pages(program)
    package = built_package(program, written, sources, variables, tools)
    files = {"loosepin": program.read_bytes(), wheel.name: wheel.read_bytes(), package.name: package.read_bytes()} | written
    name = f"loosepin-{package.name.split('_')[1]}-x86_64-linux"
    files[f"{name}.tar.gz"] = archive.of_program(name, files, sources, int(variables["SOURCE_DATE_EPOCH"]))
    files["RUSTC"] = output("rustc", "--version", "--verbose")
    return files
