"""The folders of a release."""

from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
FILES = REPOSITORY / "target/release-files"
TOOLS = REPOSITORY / "target/release-tools"
ROOTS = REPOSITORY / "target/release-roots"
