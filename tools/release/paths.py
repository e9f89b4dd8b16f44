"""The folders of a release."""

from pathlib import Path

from errors import ReleaseError

REPOSITORY = Path(__file__).resolve().parents[2]
FILES = REPOSITORY / "target/release-files"
TOOLS = REPOSITORY / "target/release-tools"
ROOTS = REPOSITORY / "target/release-roots"


def released(pattern: str) -> Path:
    """The one file of a release whose name has this pattern."""
    found = sorted(FILES.glob(pattern))
    if len(found) != 1:
        raise ReleaseError(f"{FILES} has {len(found)} files {pattern}; must be 1", "build them first: just release --without-roots")
    return found[0]
