"""Runs three studies with several sample sizes and makes the tables of measured/sample-sizes.md: `just campaign sample-sizes --write`.

One response each, the largest deviation of the cycle, so that times are those of the runs. Seconds are of one core (user time), since the
machine may do other things as well.
"""

import json
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[1]
PAGE = REPOSITORY / "measured/sample-sizes.md"
BUDGET = "100000runs"
SIZES = [(16, 64), (16, 256), (16, 1024), (16, 4096), (8, 256), (64, 256), (256, 256)]
ASK = """
[[ask]]
output = "{output}"
of = "total"
reduce = "maximum_absolute"
statistics = ["mean", "standard_deviation", {{ quantile = 0.975 }}]
[[require]]
output = "{output}"
of = "total"
within = "{limit}"
over = "cycle"
probability_at_least = 0.95
"""
# Study, its name on the page, output, a limit that some mechanisms exceed, an accuracy of the mean, unit, units in one of SI.
STUDIES = [
    ("worn-pin", "worn pin", "slider", "0.65 mm", "20 um", "mm", 1e3),
    ("four-bar", "four-bar", "rocker", "0.15 deg", "0.005 deg", "°", 57.29577951308232),
    ("offset-slider-crank", "offset slider-crank", "plunger", "0.3 mm", "5 um", "mm", 1e3),
]


def run(program: Path, folder: Path, text: str, *options: str) -> tuple[dict, float, float]:
    """The result of a study, with its seconds: of one core, and by the clock."""
    (folder / "study.toml").write_text(text, encoding="utf-8")
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    ended = subprocess.run([program, "study", folder / "study.toml", "--out", folder / "out", "--force", *options], capture_output=True, text=True)
    assert ended.returncode in (0, 1), ended.stderr
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    clock = json.loads((folder / "out/timing.json").read_text())["elapsed_s"]
    return json.loads((folder / "out/summary.json").read_text()), seconds, clock


def study_text(folder: Path, output: str, limit: str, outer: int, inner: int) -> str:
    """The inputs of the study as they are, one question, one requirement."""
    text = (folder / "stated.toml").read_text(encoding="utf-8")
    text = text[: text.index("[[ask]]")]
    text = re.sub(r"outer = \d+", f"outer = {outer}", text)
    return re.sub(r"inner = \d+", f"inner = {inner}", text) + ASK.format(output=output, limit=limit)


def row(result: dict, seconds: float, scale: float) -> list[str]:
    """Runs, seconds, upper end and its error of three statistics, the share that keeps the limit, and the gap."""
    cells = [f"{result['counts']['runs']:,}", f"{seconds:.0f}"]
    for kind in ("mean", "standard_deviation", "quantile"):
        [bound] = [
            each for each in result["bounds"]
            if each["statistic"]["kind"] == kind and each["treatment"] == "mixed" and each["at"]["kind"] == "reduced"
        ]
        upper = bound["upper"]
        parts = [float(upper["error"][f"{part}_si"]) * scale for part in ("sampling", "optimisation")]
        widened = float(upper["widened_si"]) * scale
        cells.append("no end" if widened == float("inf") else f"{widened:.4f} ({parts[0]:.4f}, {parts[1]:.4f})")
    [requirement] = result["requirements"]
    least, most = (float(end) for end in requirement["probability"])
    cells.append(f"{100 * least:.1f} to {100 * most:.1f} %")
    cells.append(f"{100 * float(result['gaps']['between_points']):.1f} %")
    return cells


def accuracy_rows(program: Path, folder: Path, outer: int, output: str, limit: str, accuracy: str, unit: str, scale: float) -> list[str]:
    """A study that grows from `outer` values until the mean is that accurate, and how it ended."""
    options = ["--accuracy", f"{output}.mean={accuracy}", "--budget", BUDGET]
    result, seconds, _ = run(program, folder, study_text(folder, output, limit, outer, 256), *options)
    counts, reached = result["counts"], result["accuracy"]
    [target] = reached["targets"]
    rounds = f"{reached['rounds']} round{'' if reached['rounds'] == 1 else 's'}"
    end = f"{rounds}, {float(target['reached_si']) * scale:.4f} {unit} reached, stop: {reached['stop']}"
    if reached["stop"] != "reached":
        end += f"; about {float(target['runs_needed']):,.0f} runs would be needed"
    asked = f"`--accuracy {output}.mean={accuracy.replace(' ', '')} --budget {BUDGET}`"
    return [
        f"| {counts['outer']} | {counts['inner']} | " + " | ".join(row(result, seconds, scale)) + " |",
        f"{asked} from {outer} × 256: {end}.",
    ]


def main(program: Path, write: bool) -> None:
    lines = []
    with tempfile.TemporaryDirectory() as temporary:
        for name, words, output, limit, accuracy, unit, scale in STUDIES:
            folder = Path(temporary) / name
            if name == "worn-pin":
                folder.mkdir()
                case = REPOSITORY / "cases/slider_crank_worn_pin"
                (folder / "model.toml").write_text((case / "model.toml").read_text())
                (folder / "stated.toml").write_text((case / "study.toml").read_text())
            else:
                subprocess.run([program, "new", name, folder], check=True, capture_output=True)
                (folder / "study.toml").rename(folder / "stated.toml")
            lines += [
                f"**{words}**, largest deviation of the {output}, {unit}; limit ±{limit}:",
                "",
                "| outer | inner | runs | core s | mean, at most | standard deviation, at most | 97.5 % quantile, at most | share within the limit | gap |",
                "|--:|--:|--:|--:|--:|--:|--:|--:|--:|",
            ]
            for outer, inner in SIZES:
                result, seconds, _ = run(program, folder, study_text(folder, output, limit, outer, inner))
                lines.append(f"| {outer} | {inner} | " + " | ".join(row(result, seconds, scale)) + " |")
                print(lines[-1], flush=True)
            # Of the worn pin also from too few values.
            starts = [(16, "10 um"), (64, accuracy)] if name == "worn-pin" else [(64, accuracy)]
            ends = []
            for outer, wanted in starts:
                grown, end = accuracy_rows(program, folder, outer, output, limit, wanted, unit, scale)
                lines.append(grown)
                ends.append(end)
            lines += ["", f"Last {'row' if len(ends) == 1 else 'rows'}: {' '.join(ends)}", ""]
            print("\n".join(lines[-4:]), flush=True)
    print("\n".join(lines))
    if write:
        page = PAGE.read_text(encoding="utf-8")
        pattern = re.compile(r"(?<=<!-- sample sizes -->\n\n)(.|\n)*(?=<!-- end of sample sizes -->)")
        PAGE.write_text(pattern.sub(lambda _: "\n".join(lines) + "\n", page), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), "--write" in sys.argv[2:])
