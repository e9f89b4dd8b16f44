"""Where the processor time of a batch of runs goes: the shares in `measured/performance.md`.

    python3 tools/profile/profile.py [--case NAME] [--runs N] [--frequency F]

Runs `slider_crank_batch` under `perf record`, finds the source lines of every sample with `addr2line`, functions that were put
into others included, and adds up by what they are there for. Samples in memory that no file backs are in the machine code that
batches run. Needs Linux, perf, binutils and Rust; no hardware counters.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
BINARY = REPOSITORY / "target/profiling/examples/slider_crank_batch"
MAPPING = re.compile(r"PERF_RECORD_MMAP2 .*: \[0x([0-9a-f]+)\(0x([0-9a-f]+)\) @ (?:0x)?([0-9a-f]+) .*\]: (\S+) (.*)$")
SAMPLE = re.compile(r"^\s*([0-9a-f]{6,16}) (.*) \(([^()]*)\)$")

MACHINE_CODE = "machine code, all lanes at once"
SYSTEM = "the operating system, memory, the C library"

# What a sample is there for: the first row that names a part of the path of one of the source lines it stands for.
PURPOSES: list[tuple[str, tuple[str, ...]]] = [
    ("poses, lane by lane", ("simulate/src/follow/", "simulate/src/lanes/batch/follow.rs", "math/src/quintic.rs")),
    (
        "events searched, and steps decided about",
        tuple(f"simulate/src/{name}.rs" for name in ("gap", "lane", "lane_step", "slot_end", "depth_limit"))
        + ("simulate/src/lanes/batch/switch.rs", "simulate/src/lanes/batch/depth.rs"),
    ),
    ("runs begun and ended", ("loosepin-bench/src/", "mechanics/src/", "simulate/src/lanes/batch/queue.rs", "simulate/src/lanes/batch/seats.rs")),
    ("calls of the programs", ("tape/src/native/", "simulate/src/lanes/recorded.rs")),
    ("the rest of a pass, lane by lane", ("simulate/src/",)),
]


def purpose(lines: Iterable[str]) -> str:
    """What a sample at these source lines is there for."""
    lines = list(lines)
    for name, parts in PURPOSES:
        if any(part in line for line in lines for part in parts):
            return name
    return SYSTEM


def output(*command: str | Path, text: str | None = None) -> str:
    """What `command` prints."""
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout


def record(case: str, runs: int, frequency: int, data: Path) -> None:
    """Builds the program and takes samples of it."""
    build = ["cargo", "build", "--profile", "profiling", "--locked", "-p", "loosepin-bench", "--example", BINARY.name]
    subprocess.run(build, cwd=REPOSITORY, check=True)
    command = ["perf", "record", "-q", "-e", "cpu-clock", "-F", str(frequency), "-o", str(data), "--"]
    printed = output(*command, BINARY, "--runs", str(runs), "--case", case)
    print(printed.strip(), file=sys.stderr)


def shares(data: Path) -> Counter[str]:
    """Samples by purpose."""
    file_maps: list[tuple[int, int, int]] = []
    found: Counter[str] = Counter()
    addresses: Counter[int] = Counter()
    for line in output("perf", "script", "-i", str(data), "--show-mmap-events", "-F", "ip,sym,dso").splitlines():
        if mapping := MAPPING.search(line):
            start, length, offset = (int(mapping[k], 16) for k in (1, 2, 3))
            if mapping[5].endswith(BINARY.name):
                file_maps.append((start, length, offset))
        elif sample := SAMPLE.match(line):
            address, library = int(sample[1], 16), sample[3]
            if library.endswith(BINARY.name):
                addresses[address] += 1
            elif library.endswith(".map") or library.startswith("//anon"):
                found[MACHINE_CODE] += 1
            else:
                found[SYSTEM] += 1
    segments = [line.split() for line in output("readelf", "-lW", BINARY).splitlines()]
    loads = [tuple(int(part, 16) for part in words[1:5]) for words in segments if words[:1] == ["LOAD"]]

    def in_file(address: int) -> int:
        offset = next(address - start + begin for start, size, begin in file_maps if start <= address < start + size)
        return next(offset - begin + virtual for begin, virtual, _, size in loads if begin <= offset < begin + size)

    places = {address: in_file(address) for address in addresses}
    text = "\n".join(hex(place) for place in places.values())
    lines: dict[int, list[str]] = {}
    for line in output("addr2line", "-a", "-i", "-e", BINARY, text=text).splitlines():
        if line.startswith("0x"):
            lines[int(line, 16)] = current = []
        else:
            current.append(line)
    for address, count in addresses.items():
        found[purpose(lines[places[address]])] += count
    return found


def main() -> int:
    """Prints the shares, the largest first."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--case", default="slider_crank_5000", help="a folder of cases/ (default: slider_crank_5000)")
    parser.add_argument("--runs", type=int, default=8192, help="runs to take samples of (default: 8192)")
    parser.add_argument("--frequency", type=int, default=2000, help="samples a second (default: 2000)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        data = Path(folder) / "perf.data"
        record(arguments.case, arguments.runs, arguments.frequency, data)
        found = shares(data)
    total = found.total()
    print(f"{total} samples")
    for name, count in found.most_common():
        print(f"{100 * count / total:5.1f} %  {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
