"""Times what follows one changed line in each crate: `just rebuild-times [CRATE...]`.

A line that must be compiled is put into a function of the largest production file of the crate. Two times are taken in the dev profile:
until a unit test of that crate has passed, and until the program is linked. The file is put back afterwards. Seconds of the clock
and of processors stand side by side: on a busy machine only the latter say something. Prints a table as Markdown.
"""

import argparse
import re
import resource
import subprocess
import sys
import time
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tools/rooms"))
from rooms import TEST_BLOCK, test_files  # noqa: E402

# The first line of a function whose body begins on the next one.
FUNCTION = re.compile(r"^(?: {4})?(?:pub(?:\(\w+\))? )?fn [^;{}]*\{\n", re.MULTILINE)
# A unit test that takes longer than this says nothing of the build.
SHORT_TEST_S = 1.0
TESTS_TRIED = 20


def timed(*command: str) -> tuple[float, float]:
    """Seconds of the clock and of processors until the command has succeeded."""
    began, used = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, cwd=REPOSITORY, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout}")
    now = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.monotonic() - began, now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime


def largest_file(crate: Path) -> Path:
    """The file with the most production lines that has a function to change."""
    sources = sorted(crate.glob("src/**/*.rs"))
    production = [source for source in sources if source not in test_files(sources) and FUNCTION.search(source.read_text())]
    return max(production, key=lambda source: len(TEST_BLOCK.split(source.read_text())[0]))


def changed(text: str, number: int) -> str:
    """The text with one line more in its last production function, which is the least likely to be one that all others use."""
    production = TEST_BLOCK.split(text)[0]
    place = list(FUNCTION.finditer(production))[-1].end()
    return f"{text[:place]}std::hint::black_box({number}_u64);\n{text[place:]}"


def short_test(package: str, kind: str) -> list[str]:
    """The arguments that run one unit test of the package, and no other."""
    listed = subprocess.run(
        ["cargo", "test", "--locked", "--package", package, kind, "--", "--list"],
        cwd=REPOSITORY, stdout=subprocess.PIPE, text=True, check=True,
    ).stdout
    for name in re.findall(r"^(\S+): test$", listed, re.MULTILINE)[:TESTS_TRIED]:
        arguments = ["cargo", "test", "--locked", "--package", package, kind, "--", "--exact", name]
        if timed(*arguments)[0] < SHORT_TEST_S:
            return arguments
    return []


def measure(crate: Path) -> str:
    package, kind = crate.name, "--lib" if (crate / "src/lib.rs").exists() else "--bins"
    program = ["cargo", "build", "--locked", "--package", "loosepin-cli"]
    source = largest_file(crate)
    subprocess.run(program, cwd=REPOSITORY, check=True)
    test = short_test(package, kind)
    text = source.read_text()
    try:
        source.write_text(changed(text, 1))
        to_test = timed(*test) if test else None
        to_program = timed(*program)
    finally:
        source.write_text(text)
    both = " | ".join("none |" if seconds is None else f"{seconds[0]:.1f} | {seconds[1]:.1f}" for seconds in (to_test, to_program))
    return f"| `{package}` | `{source.relative_to(crate / 'src')}` | {both} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("crates", nargs="*", help="packages; all that the program needs if omitted")
    wanted = parser.parse_args().crates
    built = subprocess.run(
        ["cargo", "tree", "--package", "loosepin-cli", "--edges", "normal", "--prefix", "none", "--format", "{p}"],
        cwd=REPOSITORY, stdout=subprocess.PIPE, text=True, check=True,
    ).stdout
    names = wanted or sorted({line.split()[0] for line in built.splitlines() if line.startswith("loosepin")} - {"loosepin"})
    print("| crate | changed file | to a test, s | processor s | to the program, s | processor s |")
    print("|---|---|--:|--:|--:|--:|")
    for name in names:
        print(measure(REPOSITORY / "crates" / name), flush=True)


if __name__ == "__main__":
    main()
