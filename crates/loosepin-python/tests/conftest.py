"""The files and results that several tests look at."""

import os
import subprocess
from pathlib import Path

import loosepin as lp
import pytest

# Pages have the date when they are written; here it is always the same.
os.environ["SOURCE_DATE_EPOCH"] = "0"

REPOSITORY = Path(__file__).resolve().parents[3]
MODEL = REPOSITORY / "cases/slider_crank_worn_pin/model.toml"

STUDY = """
name = "a tenth of a turn"
model = "model.toml"
seed = 7
[cycle]
transient_turns = 0
recorded_turns = 0.1
samples_per_turn = 40
[sampling]
outer = 3
inner = 8
tolerance = "1e-6 m"
[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }
"parameter.rod_length" = { normal = { mean = "120 mm", standard_deviation = "0.03 mm" } }
[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }
[[ask]]
output = "slider"
of = "total"
at = "cycle"
statistics = ["mean"]
[[ask]]
output = "slider"
of = "total"
reduce = "maximum_absolute"
statistics = ["cdf", { quantile = 0.975 }, "contributors"]
[[require]]
output = "slider"
of = "total"
within = "0.6 mm"
over = "cycle"
probability_at_least = 0.9
"""

# Without anything unknown: seconds also in an unoptimised build.
RANDOM_STUDY = STUDY.replace(
    """[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }
""",
    "",
)


def write_study(folder: Path, text: str = STUDY) -> Path:
    (folder / "model.toml").write_text(MODEL.read_text(encoding="utf-8"), encoding="utf-8")
    (folder / "study.toml").write_text(text, encoding="utf-8")
    return folder / "study.toml"


def program() -> Path:
    """The command `loosepin` of the same tree."""
    path = Path(os.environ.get("LOOSEPIN", REPOSITORY / "target/debug/loosepin"))
    if not path.exists():
        pytest.fail(f"{path} is not there; `just python-tests` builds it")
    return path


def command(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    """What it prints."""
    return subprocess.run([program(), *arguments], cwd=cwd, capture_output=True, text=True, timeout=120)


@pytest.fixture(scope="session")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a model and a small study, and the results of the command in `command`."""
    folder = tmp_path_factory.mktemp("desk")
    write_study(folder)
    ended = command("study", "study.toml", "--out", "command", cwd=folder)
    assert ended.returncode in (0, 1), ended.stderr
    return folder


@pytest.fixture(scope="session")
def result(desk: Path) -> lp.StudyResult:
    """That study from Python, on one thread, with its files in `python`."""
    return lp.Study.load(desk / "study.toml").run(desk / "python", threads=1, progress=False)
