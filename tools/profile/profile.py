"""Where the processor time of the reference case goes: the shares in `docs/performance.md`.

    python3 tools/profile/profile.py [--runs N] [--frequency F]

Runs `slider_crank_batch` under `perf record`, finds the source lines of every sample with `addr2line`, functions that were put
into others included, and adds up by what they are there for. Samples in memory that no file backs are in the machine code of
the equations. Needs Linux, perf, binutils and Rust; no hardware counters.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable
from functools import cache
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
BINARY = REPOSITORY / "target/profiling/slider_crank_batch"
FUNCTION = re.compile(r"\s*(?:pub(?:\([a-z ]+\))? )?(?:const )?(?:unsafe )?fn ([a-z_0-9]+)")
MAPPING = re.compile(r"PERF_RECORD_MMAP2 .*: \[0x([0-9a-f]+)\(0x([0-9a-f]+)\) @ (?:0x)?([0-9a-f]+) .*\]: (\S+) (.*)$")
SAMPLE = re.compile(r"^\s*([0-9a-f]{6,16}) (.*) \(([^()]*)\)$")

# The kernels of a mechanism in the order in which they are compiled.
KERNELS = ["equations within a step", "equations at the end of a step and after an event"]

# What a sample is there for: the first row that names a file and function among the lines it stands for.
PURPOSES: list[tuple[str, list[tuple[str, set[str] | None]]]] = [
    ("reading 1,000 positions a turn", [("loosepin-bench/src/batch.rs", {"step"}), ("simulate/observer.rs", None)]),
    (
        "making a run and taking it back",
        [
            ("loosepin-bench/src/batch.rs", None),
            ("simulate/batch/mod.rs", {"start", "refill"}),
            ("simulate/machine.rs", {"load", "new", "with_fixed", "numbers", "fixed"}),
            ("contact/restitution.rs", None),
            ("log1p.rs", None),
            ("mechanism/", None),
            ("model/", None),
            ("units/", None),
        ],
    ),
    (
        "events: search for their place, contacts begin and end",
        [
            ("simulate/gap.rs", None),
            ("simulate/lane.rs", {"earliest_event", "decide", "go_on_searching"}),
            ("simulate/batch/switch.rs", None),
            ("simulate/batch/mod.rs", {"decide", "read_gaps", "note_penetrations"}),
        ],
    ),
    (
        "may an event lie in the step, on all lanes",
        [("simulate/core.rs", {"look_at_gaps", "highest_control_value", "halves"})],
    ),
    ("sums of the stages", [("integrate/stepper.rs", {"set_trial", "set_group"})]),
    (
        "calls of the kernels, copies of the state",
        [("simulate/machine.rs", None), ("native/memory.rs", None), ("native/program.rs", None)],
    ),
    (
        "error of the step and next step",
        [
            ("integrate/stepper.rs", {"squares", "combine", "attempt"}),
            ("simulate/core.rs", {"growth", "set_root_tolerances"}),
        ],
    ),
    (
        "accepted steps taken over, energy account",
        [
            ("integrate/stepper.rs", None),
            ("simulate/core.rs", {"accept", "close_accounts", "take_reads", "restart", "attempt"}),
        ],
    ),
    (
        "decisions lane by lane",
        [("simulate/batch/mod.rs", None), ("simulate/lane.rs", None), ("simulate/core.rs", None)],
    ),
]


@cache
def functions(path: str) -> tuple[list[int], list[str]]:
    """The first lines of the functions of a source file, and their names."""
    starts, names = [0], [""]
    try:
        lines = Path(path).read_text(encoding="utf-8").splitlines()
    except OSError:
        return starts, names
    for number, line in enumerate(lines, 1):
        if found := FUNCTION.match(line):
            starts.append(number)
            names.append(found[1])
    return starts, names


def purpose(lines: Iterable[str]) -> str:
    """What a sample at these source lines, the innermost first, is there for."""
    places = []
    for line in lines:
        path, _, number = line.split(" ")[0].rpartition(":")
        starts, names = functions(path)
        places.append((path, names[bisect_right(starts, int(number)) - 1] if number.isdigit() else ""))
    for name, rules in PURPOSES:
        for path, function in places:
            if any(part in path and (wanted is None or function in wanted) for part, wanted in rules):
                return name
    return "not told apart"


def output(*command: str | Path, text: str | None = None) -> str:
    """What `command` prints."""
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout


def record(runs: int, frequency: int, data: Path) -> None:
    """Builds the program and takes samples of it."""
    subprocess.run(["cargo", "build", "--profile", "profiling", "--locked", "-p", "loosepin-bench"], cwd=REPOSITORY, check=True)
    command = ["perf", "record", "-q", "-e", "cpu-clock:u", "-F", str(frequency), "-o", str(data), "--"]
    printed = output(*command, BINARY, "--runs", str(runs))
    print(printed.strip(), file=sys.stderr)


def shares(data: Path) -> Counter[str]:
    """Samples by purpose."""
    file_maps: list[tuple[int, int, int]] = []
    kernels: dict[int, int] = {}
    found: Counter[str] = Counter()
    addresses: Counter[int] = Counter()
    for line in output("perf", "script", "-i", str(data), "--show-mmap-events", "-F", "ip,sym,dso").splitlines():
        if mapping := MAPPING.search(line):
            start, length, offset = (int(mapping[k], 16) for k in (1, 2, 3))
            if mapping[5].endswith(BINARY.name):
                file_maps.append((start, length, offset))
            elif mapping[5].startswith("//anon") and "x" in mapping[4]:
                kernels.setdefault(start, len(kernels))
        elif sample := SAMPLE.match(line):
            address, library = int(sample[1], 16), sample[3]
            if library.endswith(BINARY.name):
                addresses[address] += 1
            elif library.endswith(".map") or library.startswith("//anon"):
                # Neighbouring kernels are told as one mapping: the one that begins last before the sample is meant.
                start = max(start for start in kernels if start <= address)
                found[KERNELS[kernels[start] % len(KERNELS)]] += 1
            elif "memmove" in sample[2]:
                found["calls of the kernels, copies of the state"] += 1
            else:
                found["making a run and taking it back"] += 1  # memory, clocks: nothing else calls a library
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
    parser.add_argument("--runs", type=int, default=16384, help="runs to take samples of (default: 16384)")
    parser.add_argument("--frequency", type=int, default=5000, help="samples a second (default: 5000)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        data = Path(folder) / "perf.data"
        record(arguments.runs, arguments.frequency, data)
        found = shares(data)
    total = found.total()
    print(f"{total} samples")
    for name, count in found.most_common():
        print(f"{100 * count / total:5.1f} %  {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
