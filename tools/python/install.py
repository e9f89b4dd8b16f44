"""Installs the package into this Python with the module that cargo has built: `python tools/python/install.py target/debug`.

For tests of this checkout. Maturin, which makes the wheels of a release, chooses the features of dependencies for the Python package
alone, so that they and the library would be compiled once more; here the module is the one of the whole workspace.
"""

import re
import shutil
import sys
import sysconfig
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
MODULES = {"linux": "libloosepin_python.so", "darwin": "libloosepin_python.dylib"}


def main(built: Path) -> None:
    if sys.platform not in MODULES:
        sys.exit(f"error: no module of cargo is known on {sys.platform}; must be one of {', '.join(MODULES)}")
    version = re.search(r'^version = "(.+)"$', (REPOSITORY / "Cargo.toml").read_text(), re.MULTILINE)
    assert version, "Cargo.toml has no version"
    packages = Path(sysconfig.get_path("platlib"))
    for old in (packages / "loosepin", *packages.glob("loosepin-*.dist-info")):
        shutil.rmtree(old, ignore_errors=True)
    sources = REPOSITORY / "crates/loosepin-python/python/loosepin"
    shutil.copytree(sources, packages / "loosepin", ignore=shutil.ignore_patterns("__pycache__", "*.so"))
    shutil.copy2(built / MODULES[sys.platform], packages / "loosepin/_loosepin.abi3.so")
    about = packages / f"loosepin-{version[1]}.dist-info"
    about.mkdir()
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: loosepin\nVersion: {version[1]}\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
