"""Held-out Q² and training time of our surrogates and of other packages, on the same points; surrogates/README.md says what and why.

    just compare-surrogates [--designs N] [--only NAME,..] [--cases NAME,..] [--runs N,..]

Makes `.venv` and `build` in the folder surrogates.
"""

import argparse
import json
import os
import statistics
import sys

from compare import HERE, build_example, check_python, exit_status, known_names, prepare_venv, run

FOLDER = HERE / "surrogates"
BUILD = FOLDER / "build"
VENV = FOLDER / ".venv"
INPUTS = {"ishigami": 3, "oscillator": 20}
OURS = ["ours-auto", "ours-chaos", "ours-kriging", "ours-network"]
PEERS = ["sklearn-mlp", "smt-kriging", "egobox-kriging", "openturns-chaos", "chaospy-chaos"]


def our_program() -> str:
    """The example of `loosepin-bench`, built for release; `SURROGATES` names one that is built already."""
    if given := os.environ.get("SURROGATES"):
        return given
    return str(build_example("surrogates"))


def lines_of(command: list[str]) -> list[dict]:
    """What a program prints, one JSON object a line."""
    return [json.loads(line) for line in run(command, "its last lines say why").splitlines() if line.startswith("{")]


def read_arguments() -> argparse.Namespace:
    """The command line."""
    programs = OURS + PEERS
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--designs", type=int, default=20, help="sets of runs to learn from (20)")
    parser.add_argument("--only", default=",".join(programs), metavar="NAME,..", help=f"some of: {', '.join(programs)}")
    parser.add_argument("--cases", default=",".join(INPUTS), metavar="NAME,..", help=f"some of: {', '.join(INPUTS)}")
    parser.add_argument("--runs", default="50,100,200", metavar="N,..", help="runs to learn from (50,100,200)")
    arguments = parser.parse_args()
    if arguments.designs < 1:
        parser.error(f"--designs {arguments.designs}; must be >= 1")
    arguments.only = known_names(parser, "--only", "program", arguments.only, programs)
    arguments.cases = known_names(parser, "--cases", "case", arguments.cases, list(INPUTS))
    written = [number.strip() for number in arguments.runs.split(",") if number.strip()]
    if not written or not all(number.isdecimal() and int(number) > 0 for number in written):
        parser.error(f"--runs {arguments.runs}; must be whole numbers >= 1 with commas between them")
    arguments.runs = [int(number) for number in written]
    return arguments


def compare_surrogates() -> None:
    """Runs all, prints a line for each program and number of runs."""
    check_python()
    # Every program computes on one thread; `run` says so to the libraries of linear algebra.
    os.environ["RAYON_NUM_THREADS"] = "1"
    arguments = read_arguments()
    wanted = arguments.only
    ours = our_program()
    if any(name in PEERS for name in wanted):
        prepare_venv(VENV, FOLDER / "requirements.txt")
    BUILD.mkdir(exist_ok=True)
    for case in arguments.cases:
        for runs in arguments.runs:
            kinds = [name.removeprefix("ours-") for name in wanted if name in OURS]
            rows = lines_of([ours, case, str(runs), str(arguments.designs), ",".join(kinds), str(BUILD)])
            for peer in (name for name in wanted if name in PEERS):
                command = [str(VENV / "bin/python"), str(FOLDER / "peers.py"), peer, case, str(INPUTS[case]), str(runs)]
                rows += lines_of([*command, str(arguments.designs), str(BUILD)])
            for name in wanted:
                found = [row for row in rows if row["program"] == name]
                if not found:
                    continue
                quality = [row["q2"] for row in found]
                seconds = statistics.median(row["seconds"] for row in found)
                print(
                    f"{case:10} {runs:4} {name:16} Q2 median {statistics.median(quality):7.4f} least {min(quality):8.4f}"
                    f"   {seconds:8.2f} s   {len(found)} designs",
                    flush=True,
                )


if __name__ == "__main__":
    sys.exit(exit_status(compare_surrogates))
