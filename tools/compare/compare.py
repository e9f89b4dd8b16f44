"""Times the slider-crank of `cases/slider_crank_5000` in several programs against this library; README.md says what and why.

    python3 tools/compare/compare.py [--rounds N] [--only NAME,..] [--markdown]

Makes `.venv` and `build` beside this file. Each program is first held against the reference history of the case, then all
run in turn, round after round.
"""

import argparse
import csv
import datetime
import io
import json
import os
import platform
import shlex
import statistics
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).resolve().parent
REPOSITORY = HERE.parents[1]
PROGRAMS = HERE / "programs"
BUILD = HERE / "build"
VENV = HERE / ".venv"
REQUIREMENTS = HERE / "requirements.txt"
REFERENCE = REPOSITORY / "cases/slider_crank_5000/reference.csv"

OURS = "ours"
RIVAL_LIMIT_M = 1e-6
OUR_LIMIT_M = 1e-8
HALF_TURN_S = 6e-3
SAME_TIME_S = 1e-12  # times of the reference are printed to twelve digits
BLOCK_S = 0.7  # processor time of a program in a round, about
FIRST_RUNS = 8  # these, or ten times as many and again, tell how many runs make a block
SHORTEST_TRIAL_S = 0.1  # clocks of processor time may tick in milliseconds
OLDEST_PYTHON = (3, 11)  # tomllib

COMPILER = os.environ.get("CXX", "g++")
COMPILER_FLAGS = ["-std=c++17", "-O3", "-march=native", "-Wall", "-Wextra"]


class Refusal(Exception):
    """What is wrong, and the way out."""

    def __init__(self, text: str, hint: str) -> None:
        super().__init__(f"error: {text}\nhint: {hint}")


@dataclass
class Program:
    """A program in the comparison, and what was measured."""

    name: str
    title: str
    version: Callable[[], str]
    prepare: Callable[[], list[str]]
    limit_m: float = RIVAL_LIMIT_M
    missing: Callable[[], str] = lambda: ""  # what this machine has not and the program needs
    command: list[str] = field(default_factory=list)
    error_m: float = float("nan")
    runs: int = 0
    times_s: list[float] = field(default_factory=list)

    @property
    def time_s(self) -> float:
        """Median of the rounds, s a run."""
        return statistics.median(self.times_s)


def say(text: str) -> None:
    """Progress, which is no result."""
    print(text, file=sys.stderr, flush=True)


def run(command: Sequence[str | Path], hint: str) -> str:
    """What `command` prints; its failure ends the comparison."""
    environment = os.environ | {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, capture_output=True, text=True, cwd=REPOSITORY, env=environment)
    except FileNotFoundError:
        raise Refusal(f"{words[0]} is not there", hint) from None
    if done.returncode != 0:
        told = "\n".join((done.stdout + done.stderr).splitlines()[-15:])
        raise Refusal(f"`{shlex.join(words)}` ended with status {done.returncode}:\n{told}", hint)
    return done.stdout


# Preparation


def check_python() -> None:
    """This Python is new enough."""
    if sys.version_info < OLDEST_PYTHON:
        found, wanted = platform.python_version(), ".".join(map(str, OLDEST_PYTHON))
        raise Refusal(f"Python {found} is too old; must be {wanted} or newer", "call this file with a newer python3")


def venv_python() -> Path:
    """The Python that has the packages."""
    return VENV / "bin/python"


def prepare_venv(venv: Path = VENV, requirements: Path = REQUIREMENTS) -> None:
    """Makes `venv` as `requirements` asks; costs nothing where that was done."""
    wanted = sys.version + requirements.read_text(encoding="utf-8")
    stamp = venv / "installed"
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == wanted:
        return
    say(f"installing the packages of {requirements.relative_to(REPOSITORY)} into {venv.relative_to(REPOSITORY)}")
    hint = "install the venv module, for example: apt-get install python3-venv"
    run([sys.executable, "-m", "venv", "--clear", venv], hint)
    install = [venv / "bin/python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    run(
        [*install, "--requirement", requirements],
        "pip must reach a package index, once, and the packages must have wheels for this Python and platform; "
        "compare.py --only cpp,ours needs no packages",
    )
    stamp.write_text(wanted, encoding="utf-8")


def package_folder(name: str) -> Path:
    """Where a package of `.venv` lies."""
    code = f"import importlib.util; print(importlib.util.find_spec('{name}').submodule_search_locations[0])"
    return Path(run([venv_python(), "-c", code], reinstall_hint()).strip())


def package_version(name: str) -> str:
    """Version of a package of `.venv`."""
    code = f"import importlib.metadata; print(importlib.metadata.version('{name}'))"
    return run([venv_python(), "-c", code], reinstall_hint()).strip()


def reinstall_hint() -> str:
    """The way out of a broken `.venv`."""
    return f"remove {VENV.relative_to(REPOSITORY)}, then try again"


def write_parameters() -> None:
    """The numbers of the model as constants of C++."""
    sys.path.insert(0, str(PROGRAMS))
    from model import Model

    BUILD.mkdir(exist_ok=True)
    (BUILD / "parameters.hpp").write_text(Model.read().as_header(), encoding="utf-8")


def compile_cpp(name: str, *more: str | Path, binary_name: str = "") -> list[str]:
    """Builds a program in C++."""
    write_parameters()
    source, binary = PROGRAMS / f"{name}.cpp", BUILD / (binary_name or name)
    say(f"compiling {source.relative_to(REPOSITORY)}")
    command = [COMPILER, *COMPILER_FLAGS, "-I", BUILD, "-o", binary, source, *more]
    run(command, "install g++ 9 or newer, or name another compiler in CXX")
    return [str(binary)]


def compile_mujoco(name: str) -> list[str]:
    """Builds a program that links to the library in MuJoCo's wheel."""
    prepare_venv()
    folder = package_folder("mujoco")
    libraries = sorted(folder.glob("libmujoco.*"))
    if not libraries:
        raise Refusal(f"there is no libmujoco in {folder}", reinstall_hint())
    return compile_cpp(name, "-I", folder / "include", libraries[0], f"-Wl,-rpath,{folder}")


def python_program(name: str) -> list[str]:
    """A program in Python."""
    prepare_venv()
    return [str(venv_python()), str(PROGRAMS / f"{name}.py")]


def build_example(name: str) -> Path:
    """Builds an example of `loosepin-bench`, for any processor of this platform, as the library is shipped."""
    say(f"building {name}")
    build = ["cargo", "build", "--release", "--locked", "--quiet", "--package", "loosepin-bench", "--example", name]
    run(build, "install Rust from https://rustup.rs")
    target = Path(os.environ.get("CARGO_TARGET_DIR", "target"))
    return REPOSITORY / target / "release" / "examples" / name


def build_ours() -> list[str]:
    """Builds this library's own program."""
    return [str(build_example("slider_crank_batch"))]


def build_lanes(*arguments: str) -> list[str]:
    """Builds the kernel by hand on lanes, which takes `arguments` before all others."""
    return [str(build_example("slider_crank_lanes")), *arguments]


def missing_avx512() -> str:
    """What keeps the kernel by hand from running here."""
    information = Path("/proc/cpuinfo")
    flags = information.read_text(encoding="utf-8").split() if information.is_file() else []
    return "" if "avx512f" in flags else "the processor has no AVX-512"


def compiler_version() -> str:
    """Which compiler, and how it was called."""
    number = run([COMPILER, "-dumpfullversion", "-dumpversion"], "name a compiler in CXX").strip()
    return f"{Path(COMPILER).name} {number}, -O3 -march=native"


def commit() -> str:
    """The commit, and whether the tree differs from it."""
    hint = "run this inside a clone"
    name = run(["git", "rev-parse", "--short=10", "HEAD"], hint).strip()
    return f"{name}{' with changes' if run(['git', 'status', '--porcelain'], hint).strip() else ''}"


def all_programs() -> list[Program]:
    """Everything that can be compared."""
    return [
        Program(OURS, "loosepin, 1e-8 m", lambda: f"commit {commit()}", build_ours, limit_m=OUR_LIMIT_M),
        Program(
            "lanes",
            "a kernel by hand on AVX-512 lanes, the same work",
            lambda: f"commit {commit()}",
            build_lanes,
            limit_m=OUR_LIMIT_M,
            missing=missing_avx512,
        ),
        Program(
            "lanes-bare",
            "the same kernel without readings and energy account",
            lambda: f"commit {commit()}",
            lambda: build_lanes("--bare"),
            limit_m=OUR_LIMIT_M,
            missing=missing_avx512,
        ),
        Program("cpp", "C++, own Dormand-Prince", compiler_version, lambda: compile_cpp("cpp_program")),
        Program(
            "cpp-fine",
            "C++, own Dormand-Prince, within 1e-8 m",
            compiler_version,
            lambda: compile_cpp("cpp_program", "-DALLOWED_ERROR=1e-9", binary_name="cpp_fine_program"),
            limit_m=OUR_LIMIT_M,
        ),
        Program("numba", "numba, own Dormand-Prince", lambda: package_version("numba"), lambda: python_program("numba_program")),
        Program(
            "mujoco-forward",
            "MuJoCo's dynamics in the same Dormand-Prince",
            lambda: package_version("mujoco"),
            lambda: compile_mujoco("mujoco_forward_program"),
        ),
        Program("exudyn", "Exudyn, DOPRI5", lambda: package_version("exudyn"), lambda: python_program("exudyn_program")),
        Program(
            "mujoco",
            "MuJoCo, RK4, C interface",
            lambda: package_version("mujoco"),
            lambda: compile_mujoco("mujoco_program"),
        ),
    ]


# Measurement


def read_reference() -> list[tuple[float, float]]:
    """Time and x of the slider in the first half turn, s and m."""
    with REFERENCE.open(encoding="utf-8", newline="") as file:
        rows = [(float(row["time"]), float(row["b3_x"])) for row in csv.DictReader(file)]
    return [row for row in rows if row[0] <= HALF_TURN_S + SAME_TIME_S]


def read_history(program: Program) -> list[tuple[float, float]]:
    """Time and x of the slider in the nominal run of a program, s and m."""
    printed = run([*program.command, "--history"], f"call {shlex.join(program.command)} --history to see more")
    table = printed[printed.index("time_s,") :]  # a library may greet on standard output
    return [(float(row["time_s"]), float(row["slider_x_m"])) for row in csv.DictReader(io.StringIO(table))]


def largest_error_m(reference: list[tuple[float, float]], history: list[tuple[float, float]]) -> float:
    """Largest difference at the times of the reference; the history has a row at each of them."""
    largest_m, row = 0.0, 0
    for time_s, x_m in reference:
        while row < len(history) and history[row][0] < time_s - SAME_TIME_S:
            row += 1
        if row == len(history) or history[row][0] > time_s + SAME_TIME_S:
            return float("nan")
        largest_m = max(largest_m, abs(history[row][1] - x_m))
    return largest_m


def verify(program: Program, reference: list[tuple[float, float]]) -> None:
    """The program computes the same motion, within its limit."""
    program.error_m = largest_error_m(reference, read_history(program))
    say(f"{program.name}: largest error over the first half revolution {program.error_m:.2e} m")
    if not program.error_m <= program.limit_m:
        raise Refusal(
            f"{program.name}: slider position off by {program.error_m:.2e} m in the first half revolution; "
            f"must be at most {program.limit_m:.0e} m",
            "its time would not be comparable; leave it out with --only, or tighten its tolerance",
        )


def time_a_run_s(program: Program, runs: int) -> float:
    """Processor time of a run, the mean of `runs`."""
    hint = f"call {shlex.join(program.command)} --runs {runs} to see more"
    told = json.loads(run([*program.command, "--runs", str(runs)], hint).splitlines()[-1])
    return told["seconds"] / told["runs"]


def runs_of_a_block(program: Program) -> int:
    """How many runs last about `BLOCK_S`."""
    runs = FIRST_RUNS
    while (trial_s := runs * time_a_run_s(program, runs)) < SHORTEST_TRIAL_S:
        runs *= 10
    return max(FIRST_RUNS, round(runs * BLOCK_S / trial_s))


def measure(programs: list[Program], rounds: int) -> None:
    """Blocks of all programs in turn, so that a noise of the machine hits all alike."""
    for program in programs:
        program.runs = runs_of_a_block(program)
    for index in range(rounds):
        for program in programs:
            program.times_s.append(time_a_run_s(program, program.runs))
        told = (f"{program.name} {program.times_s[-1] * 1e3:.3g} ms" for program in programs)
        say(f"round {index + 1} of {rounds}: {', '.join(told)}")


# Table

HEADINGS = ["who", "version", "time a run", "runs a second", "largest error", "times slower than ours"]


def ratio_text(program: Program, ours: Program | None) -> str:
    """Median of the ratios of the rounds, and their range."""
    if ours is None:
        return "not measured"
    if program is ours:
        return "1"
    ratios = [mine_s / ours_s for mine_s, ours_s in zip(program.times_s, ours.times_s, strict=True)]
    return f"{statistics.median(ratios):.3g} ({min(ratios):.3g} to {max(ratios):.3g})"


def table(programs: list[Program]) -> list[list[str]]:
    """Rows of text."""
    ours = next((program for program in programs if program.name == OURS), None)
    return [
        [
            program.title,
            program.version(),
            f"{program.time_s * 1e3:.3g} ms",
            f"{1.0 / program.time_s:.3g}" if program.time_s > 1e-3 else f"{1.0 / program.time_s:.0f}",
            f"{program.error_m:.1e} m",
            ratio_text(program, ours),
        ]
        for program in programs
    ]


def as_text(rows: list[list[str]]) -> str:
    """The table for a terminal."""
    everything = [HEADINGS, *rows]
    widths = [max(len(row[column]) for row in everything) for column in range(len(HEADINGS))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in everything)


def as_markdown(rows: list[list[str]]) -> str:
    """The table for a page."""
    lines = [HEADINGS, ["---"] * len(HEADINGS), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def processor_name() -> str:
    """What the system calls its processor."""
    information = Path("/proc/cpuinfo")
    if information.is_file():
        for line in information.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()


def circumstances(rounds: int) -> str:
    """What a published time needs beside it."""
    date = datetime.date.today().isoformat()
    command = shlex.join(["python3", "tools/compare/compare.py", *sys.argv[1:]])
    machine = f"{processor_name()}, {platform.system()}"
    many = f"{rounds} round{'s' if rounds > 1 else ''}"
    return (
        f"{date}, {machine}, commit {commit()}, `{command}`: processor time on one thread, medians over {many}; in brackets "
        "the range. Two revolutions, 1,000 readings of the slider's position in each, clearances within 10 % of the nominal "
        "one; the error is that of the nominal run over the first half revolution. It proves nothing about other mechanisms, "
        "other accuracies or several threads."
    )


# Command line


def known_names(parser: argparse.ArgumentParser, option: str, what: str, written: str, names: Sequence[str]) -> list[str]:
    """The names behind an option, with a comma between them; ends the program where one of them is not known, or there is none."""
    found = [name.strip() for name in written.split(",") if name.strip()]
    unknown = [name for name in found if name not in names]
    if unknown or not found:
        parser.error(f"{option}: there is no {what} '{', '.join(unknown)}'; known are {', '.join(names)}")
    return found


def read_arguments(names: list[str]) -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=7, help="how often each program runs its block (7)")
    parser.add_argument("--only", default=",".join(names), metavar="NAME,..", help=f"some of: {', '.join(names)}")
    parser.add_argument("--markdown", action="store_true", help="the table as Markdown, with its circumstances")
    arguments = parser.parse_args()
    if arguments.rounds < 1:
        parser.error(f"--rounds {arguments.rounds}; must be >= 1")
    arguments.only = known_names(parser, "--only", "program", arguments.only, names)
    return arguments


def compare() -> None:
    """Builds, verifies, times, prints."""
    check_python()
    programs = all_programs()
    arguments = read_arguments([program.name for program in programs])
    chosen = [program for program in programs if program.name in arguments.only]
    for program in chosen:
        if reason := program.missing():
            say(f"{program.name} is left out: {reason}")
    chosen = [program for program in chosen if not program.missing()]
    if not chosen:
        raise Refusal("no program is left to compare", "name others with --only")
    for program in chosen:
        program.command = program.prepare()
    reference = read_reference()
    for program in chosen:
        verify(program, reference)
    measure(chosen, arguments.rounds)
    rows = table(chosen)
    if arguments.markdown:
        print(as_markdown(rows) + "\n\n" + circumstances(arguments.rounds))
    else:
        print(as_text(rows))


def exit_status(comparison: Callable[[], None]) -> int:
    """Runs a comparison; 2 where something is missing or wrong."""
    try:
        comparison()
    except Refusal as refusal:
        print(refusal, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(exit_status(compare))
