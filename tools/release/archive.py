"""The archive of the program with what belongs to it, the same bytes for the same files."""

import gzip
import tarfile
from io import BytesIO
from pathlib import Path

NOTICES = ("LICENSE-APACHE", "LICENSE-MIT", "THIRD_PARTY_NOTICES.md", "README.md", "CHANGELOG.md")
PROGRAM = "loosepin"


def compressed(content: bytes) -> bytes:
    """In gzip's format, without a name and a time in its header."""
    packed = BytesIO()
    with gzip.GzipFile(filename="", fileobj=packed, mode="wb", mtime=0) as file:
        file.write(content)
    return packed.getvalue()


def of_program(name: str, files: dict[str, bytes], sources: Path, time_s: int) -> bytes:
    """A .tar.gz with one folder: program, manual pages, completions, licences."""
    contents = {path: content for path, content in files.items() if path == PROGRAM or path.startswith(("man/", "completions/"))}
    contents |= {notice: (sources / notice).read_bytes() for notice in NOTICES}
    packed = BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for path in sorted(contents):
            entry = tarfile.TarInfo(f"{name}/{path}")
            entry.size, entry.mtime, entry.mode = len(contents[path]), time_s, 0o755 if path == PROGRAM else 0o644
            tar.addfile(entry, BytesIO(contents[path]))
    return compressed(packed.getvalue())
