"""Held-out Q² and training time of our surrogates and of other packages, on the same points; README.md says what and why.

    python3 tools/compare/surrogates/compare.py [--designs N] [--only NAME,..] [--cases NAME,..] [--runs N,..]

Makes `.venv` and `build` beside this file.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
REPOSITORY = HERE.parents[2]
BUILD = HERE / "build"
VENV = HERE / ".venv"
INPUTS = {"ishigami": 3, "oscillator": 20}
OURS = ["ours-auto", "ours-chaos", "ours-kriging", "ours-network"]
PEERS = ["sklearn-mlp", "smt-kriging", "egobox-kriging", "openturns-chaos", "chaospy-chaos"]


def python_of_peers() -> str:
    """The Python with the packages; made on the first call."""
    python = VENV / "bin/python"
    if not python.exists():
        subprocess.run([sys.executable, "-m", "venv", str(VENV)], check=True)
        command = [str(python), "-m", "pip", "install", "--quiet", "--requirement", str(HERE / "requirements.txt")]
        subprocess.run(command, check=True)
    return str(python)


def our_program() -> str:
    """The example of `loosepin-bench`, built for release; `SURROGATES` names one that is built already."""
    if given := os.environ.get("SURROGATES"):
        return given
    command = ["cargo", "build", "--release", "--locked", "--package", "loosepin-bench", "--example", "surrogates"]
    subprocess.run(command, cwd=REPOSITORY, check=True)
    return str(REPOSITORY / "target/release/examples/surrogates")


def lines_of(command: list[str]) -> list[dict]:
    """What a program prints, one JSON object a line, with one thread for the linear algebra of all."""
    threads = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "RAYON_NUM_THREADS")}
    done = subprocess.run(command, env=os.environ | threads, check=True, stdout=subprocess.PIPE, text=True)
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--designs", type=int, default=20)
    parser.add_argument("--only", default=",".join(OURS + PEERS))
    parser.add_argument("--cases", default=",".join(INPUTS))
    parser.add_argument("--runs", default="50,100,200")
    arguments = parser.parse_args()
    wanted = arguments.only.split(",")
    ours, python = our_program(), python_of_peers()
    BUILD.mkdir(exist_ok=True)
    for case in arguments.cases.split(","):
        for runs in (int(n) for n in arguments.runs.split(",")):
            kinds = [name.removeprefix("ours-") for name in wanted if name in OURS]
            rows = lines_of([ours, case, str(runs), str(arguments.designs), ",".join(kinds), str(BUILD)])
            for peer in (name for name in wanted if name in PEERS):
                command = [python, str(HERE / "peers.py"), peer, case, str(INPUTS[case]), str(runs)]
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
    main()
