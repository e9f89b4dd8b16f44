"""How soon the study of each template shows a first band, and what the whole study costs.

    just template-times               (builds the release program first)
    python3 tools/templates/times.py PROGRAM [TEMPLATE ...]

Each template is written into a folder of its own and its study runs on a terminal of its own, since the progress line is for terminals. The
first band is the first progress line that says "so far". Prints a table in Markdown; nothing is asserted.
"""

import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import time


def templates(program):
    """Names of all templates, in the order of the list."""
    listed = subprocess.run([program, "new", "--list"], capture_output=True, text=True, check=True).stdout
    return re.findall(r"^([a-z-]+): ", listed, re.MULTILINE)


def study(program, folder):
    """Seconds to the first band, of the whole study, and of the processor; the number of runs."""
    started = time.monotonic()
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(folder)
        os.execvpe(program, [program, "study", "study.toml"], os.environ | {"COLUMNS": "160", "TERM": "xterm"})
    first_s, said = None, b""
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError:
            break
        said += part
        if first_s is None and b"so far" in said:
            first_s = time.monotonic() - started
    _, _, used = os.wait4(child, 0)
    runs = [int(number) for number in re.findall(rb"(\d+) of at most", said)]
    return first_s, time.monotonic() - started, used.ru_utime + used.ru_stime, max(runs, default=0)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    print("| Template | Runs | First band, s | Study, s | Processor, s |\n|---|--:|--:|--:|--:|")
    for template in sys.argv[2:] or templates(program):
        with tempfile.TemporaryDirectory() as above:
            folder = pathlib.Path(above) / template
            subprocess.run([program, "new", template, folder], capture_output=True, check=True)
            first_s, all_s, processor_s, runs = study(program, folder)
        first = "none shown" if first_s is None else f"{first_s:.1f}"
        print(f"| {template} | {runs:,} | {first} | {all_s:.1f} | {processor_s:.1f} |", flush=True)


if __name__ == "__main__":
    main()
