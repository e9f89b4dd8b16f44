"""Wear from Python is that of the command."""

import json

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, command

WORN = """bearing_length = "20 mm"
wear.bearing.coefficient = "1e-15 m^2/N"
wear.journal = { archard = 1e-6, hardness = "2 GPa" }
wear.sectors = 72
radial_clearance"""

SHORT = {"turns": 0.5, "transient": 0, "tolerance": "1e-7 m"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory):
    """A model whose gudgeon wears, and the results of the command."""
    folder = tmp_path_factory.mktemp("wear")
    (folder / "model.toml").write_text(MODEL.read_text(encoding="utf-8").replace("radial_clearance", WORN, 1), encoding="utf-8")
    arguments = ["--turns", "0.5", "--transient", "0", "--tolerance", "1e-7 m", "--set", "wear.cycles=4000"]
    ended = command("wear", str(folder / "model.toml"), *arguments, "--out", "run", cwd=folder)
    assert ended.returncode == 0, ended.stderr
    (folder / "printed.txt").write_text(ended.stdout, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def wear(folder) -> lp.Wear:
    return lp.Model.load(folder / "model.toml").wear(**SHORT, set={"wear.cycles": "4000"})


def test_identity_wear_is_that_of_the_command(wear, folder, tmp_path):
    assert wear.simulation._native.summary_json() == (folder / "run/summary.json").read_text(encoding="utf-8")
    assert str(wear) == (folder / "printed.txt").read_text(encoding="utf-8")
    assert wear.report(tmp_path / "page.html").read_bytes() == (folder / "run/report.html").read_bytes()
    frame = wear.to_pandas()
    names, *lines = (folder / "run/wear.csv").read_text(encoding="utf-8").splitlines()
    assert list(frame.columns) == names.split(",") and len(frame) == len(lines) == 2 * 72
    for (_, row), line in zip(frame.iterrows(), lines):
        joint, surface, sector, *numbers = line.split(",")
        assert (row["joint"], row["surface"], row["sector"]) == (joint, surface, int(sector))
        assert [row["from_rad"], row["to_rad"], row["depth_m"]] == [float(number) for number in numbers]


def test_analytic_worn_volume_is_that_of_archard(wear):
    gudgeon = wear["gudgeon"]
    assert list(wear) == ["gudgeon"] and list(gudgeon.surfaces) == ["bearing", "journal"]
    assert gudgeon.cycles == 4000 and abs(gudgeon.radial_clearance_m - 0.3e-3) < 1e-18 and gudgeon.friction_path_j > 0
    # V = N k W; k = 1e-15 m^2/N of the bearing, 1e-6 over 2 GPa of the journal.
    for name, coefficient_m2_n in [("bearing", 1e-15), ("journal", 1e-6 / 2e9)]:
        surface = gudgeon.surfaces[name]
        np.testing.assert_allclose(surface.coefficient_m2_n, coefficient_m2_n, rtol=1e-14)
        np.testing.assert_allclose(surface.volume_m3, 4000 * coefficient_m2_n * gudgeon.friction_path_j, rtol=1e-12)
        assert surface.greatest_depth_m == surface.depth_m.max() > 0
        assert surface.from_rad[0] == 0 and surface.to_rad[-1] == 2 * np.pi
    # Depth times width and length of each sector adds up to the volume; 1e-3: the run's own check of the friction path.
    width_m = 2 * np.pi * 10e-3 / 72
    volume_m3 = gudgeon.surfaces["bearing"].depth_m.sum() * width_m * 20e-3
    np.testing.assert_allclose(volume_m3, gudgeon.surfaces["bearing"].volume_m3, rtol=1e-3)
    dataset = wear.to_xarray()
    np.testing.assert_array_equal(dataset["gudgeon.journal.depth_m"], gudgeon.surfaces["journal"].depth_m)
    np.testing.assert_array_equal(dataset["gudgeon.from_rad"], gudgeon.surfaces["journal"].from_rad)
    assert "4000 cycles" in wear._repr_html_()
    assert wear.life is None and gudgeon.life == {} and len(wear.life_cycles) == 0


def test_identity_a_worn_shape_has_a_life(folder):
    text = (folder / "model.toml").read_text(encoding="utf-8") + '\n[wear]\ncycles = 2e5\njumps = 1\ngeometry = "worn"\n'
    (folder / "life.toml").write_text(text, encoding="utf-8")
    arguments = ["--turns", "0.5", "--transient", "0", "--tolerance", "1e-7 m"]
    ended = command("wear", str(folder / "life.toml"), *arguments, "--out", "life", cwd=folder)
    assert ended.returncode == 0, ended.stderr
    wear = lp.Model.load(folder / "life.toml").wear(**SHORT)
    text = (folder / "life/summary.json").read_text(encoding="utf-8")
    assert wear.simulation._native.summary_json() == text
    life = json.loads(text)["life"]
    np.testing.assert_array_equal(wear.life_cycles, life["cycles"])
    bearing = wear["gudgeon"].life["bearing"]
    np.testing.assert_array_equal(bearing.depth_m, life["joints"][0]["surfaces"][0]["depth_m"])
    depth = wear.to_xarray()["gudgeon.bearing.life_depth_m"]
    assert depth.dims == ("cycles", "gudgeon.from_rad")
    np.testing.assert_array_equal(depth, bearing.depth_m)
    assert bearing.depth_m.shape == (len(wear.life_cycles), 72) and bearing.volume_m3[0] == 0 < bearing.volume_m3[-1]


def test_a_model_without_wear_is_refused():
    with pytest.raises(lp.LoosepinError, match="no joint of the model wears"):
        lp.Model.load(MODEL).wear()
