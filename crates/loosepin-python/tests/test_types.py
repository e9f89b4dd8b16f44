"""The types are right: those of the package among themselves, those of the compiled part, those that a user sees."""

import subprocess
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]

USER = """
import loosepin as lp
import numpy as np

model = lp.Model.load("model.toml")
run = model.simulate(turns=2, set={"joint.gudgeon.radial_clearance": "0.3 mm", "contact.steel_pin.restitution": 0.8})
peak: float = float(np.max(run["slider"]))
runs = model.evaluate({"joint.gudgeon.radial_clearance": np.linspace(1e-4, 3e-4, 5)}, ["slider total rms"], progress=False)
worst: float = float(np.max(runs["slider total rms"]))
result = lp.Study.from_dict({"model": model}).run("results", progress=lambda finished, most: None)
widest: tuple[float, float] = result.bounds[0].widened
found = lp.bounds(lambda x, u: x + u, {"x": lp.Normal(0, 1), "u": lp.Interval(-1, 1)}, ["mean", {"quantile": 0.975}])
reveal_type(found.bounds)
"""


def check(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", *arguments], cwd=PACKAGE, capture_output=True, text=True)


def test_package_keeps_its_own_types():
    ended = check("mypy", "python/loosepin")
    assert ended.returncode == 0, ended.stdout


def test_stub_is_what_was_compiled():
    ended = check("mypy.stubtest", "loosepin._loosepin")
    assert ended.returncode == 0, ended.stdout


def test_users_get_types(tmp_path):
    (tmp_path / "user.py").write_text(USER, encoding="utf-8")
    ended = check("mypy", "--strict", str(tmp_path / "user.py"))
    assert 'Revealed type is "tuple[loosepin._records.Bound, ...]"' in ended.stdout.replace("builtins.tuple", "tuple"), ended.stdout
    assert ended.returncode == 0, ended.stdout
