"""Motion and check from Python are those of the command."""

import json

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, command, write_study

SETTING = "joint.gudgeon.radial_clearance=0.4 mm"


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


@pytest.fixture(scope="module")
def motion(model: lp.Model) -> lp.Motion:
    return model.motion(set={"joint.gudgeon.radial_clearance": "0.4 mm"})


@pytest.fixture(scope="module")
def study_folder(tmp_path_factory: pytest.TempPathFactory):
    folder = tmp_path_factory.mktemp("study")
    write_study(folder)
    return folder


def test_identity_motion_is_that_of_the_command(motion, tmp_path):
    ended = command("motion", str(MODEL), "--set", SETTING, "--out", "run", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert motion._native.summary_json() == (tmp_path / "run/summary.json").read_text(encoding="utf-8")
    assert motion.report(tmp_path / "page.html").read_bytes() == (tmp_path / "run/report.html").read_bytes()
    assert str(motion) == ended.stdout


def test_analytic_worst_case_of_the_slider_crank(motion):
    slider, angle = motion["slider"], motion.drive_angle_rad
    assert (slider.unit, slider.words) == ("m", "x of slider.pin")

    def x_m(rod_m):
        """Where a rod of this length holds the slider."""
        return 0.05 * np.cos(angle) + np.sqrt(rod_m**2 - (0.05 * np.sin(angle)) ** 2)

    # The pin lies within the clearance of the end of the rod: as far from the crank pin as a rod of 120 +- 0.4 mm would hold it.
    # m: round-off of the ideal motion; the search ends at a tenth of a nanometre.
    np.testing.assert_allclose(slider.value, x_m(0.12), atol=1e-13)
    np.testing.assert_allclose(slider.found[0], x_m(0.1196) - x_m(0.12), atol=1e-10)
    np.testing.assert_allclose(slider.found[1], x_m(0.1204) - x_m(0.12), atol=1e-10)
    np.testing.assert_allclose(slider.worst_case, np.maximum(-slider.found[0], slider.found[1]), rtol=1e-12)
    assert (slider.proven[0] <= slider.found[0]).all() and (slider.proven[1] >= slider.found[1]).all()
    # First order: the clearance over the cosine of the angle of the rod. One joint: its part is the sum, half of it the deviation of a disc.
    first_order = 0.4e-3 / np.sqrt(1 - (0.05 / 0.12 * np.sin(angle)) ** 2)
    np.testing.assert_allclose(slider.first_order, first_order, rtol=1e-9)
    np.testing.assert_allclose(slider.joints["gudgeon"], first_order, rtol=1e-9)
    np.testing.assert_allclose(slider.disc_standard_deviation, first_order / 2, rtol=1e-9)
    np.testing.assert_allclose(slider.rim_standard_deviation, first_order / np.sqrt(2), rtol=1e-9)
    # rad/s: 5000 turns a minute.
    speed = 5000 * 2 * np.pi / 60
    np.testing.assert_allclose(slider.velocity[90], np.gradient(slider.value, angle)[90] * speed, rtol=1e-3)


def test_frames_and_figures(motion):
    frame = motion.to_pandas()
    np.testing.assert_array_equal(frame["slider worst_case"], motion["slider"].worst_case)
    dataset = motion.to_xarray()
    np.testing.assert_array_equal(dataset["slider proven_highest"], motion["slider"].proven[1])
    assert dataset["slider value"].attrs["units"] == "m" and dataset["slider value"].dims == ("drive_angle_rad",)
    assert motion.plot().axes[0].get_ylabel() == "slider, deviation by play [mm]"
    assert "<svg" in motion._repr_html_() and "worst case of the play" in motion._repr_html_()


def test_identity_motion_of_a_study_is_that_of_the_command(study_folder):
    ended = command("motion", "study.toml", "--out", "run", cwd=study_folder)
    text = (study_folder / "run/summary.json").read_text(encoding="utf-8")
    motion = lp.Study.load(study_folder / "study.toml").motion()
    expected = json.loads(text)
    assert {**motion.summary, "repeat": None} == {**expected, "repeat": None}
    assert motion.is_met == (ended.returncode == 0) and len(motion.requirements) == 1
    # The random lengths have standard deviations of 0.02 and 0.03 mm.
    dimensions = motion["slider"].dimensions
    assert list(dimensions) == ["parameter.crank_length", "parameter.rod_length"]
    np.testing.assert_allclose(motion["slider"].dimensional_standard_deviation, np.hypot(*dimensions.values()), rtol=1e-12)
    # At top dead centre both lengths move the slider as they are.
    np.testing.assert_allclose([each[0] for each in dimensions.values()], [0.02e-3, 0.03e-3], rtol=1e-9)


def test_settings_that_are_wrong_are_refused(model):
    with pytest.raises(lp.LoosepinError, match=r"\]: set: the model has no quantity"):
        model.motion(set={"joint.gudgeon.radial_clearence": "0.4 mm"})


def test_identity_check_is_that_of_the_command(model, study_folder):
    ended = command("check", str(MODEL), cwd=study_folder)
    check = model.check()
    assert ended.stdout == f"{MODEL}: {check}"
    names = [section.name for section in check.sections]
    assert names[:2] == ["bodies", "joints"] and check["bodies"].name == "bodies"
    assert dict(check["bodies"].facts)["rod"][0] in check.text
    assert [name for name, _ in check["joints"].facts] == ["main", "crank_pin", "gudgeon", "guide"]
    with pytest.raises(KeyError):
        check["nothing"]


def test_identity_check_of_a_study_is_that_of_the_command(study_folder):
    ended = command("check", "study.toml", cwd=study_folder)
    check = lp.Study.load(study_folder / "study.toml").check()
    # The time that runs take is measured anew each time.
    said, found = (text.splitlines() for text in (ended.stdout, f"study.toml: {check}"))
    assert len(said) == len(found)
    differ = [(one, two) for one, two in zip(said, found) if one != two]
    assert all(" s" in one or "min" in one for one, two in differ) and len(differ) <= 2, differ
    assert "parameter.crank_length" in str(dict(check["inputs"].facts))


def test_a_check_says_what_keeps_a_model_from_running():
    text = MODEL.read_text(encoding="utf-8").replace('crank_length = "50 mm"', 'crank_length = "150 mm"')
    with pytest.raises(lp.LoosepinError, match="crank"):
        lp.Model.from_text(text).check()


def test_analytic_path_of_the_rod(model):
    motion = model.motion(paths=["rod.small_end"])
    path, angle = motion.paths["rod.small_end"], motion.drive_angle_rad
    # Ideal: the pin of the slider, 50 mm crank, 120 mm rod; on the line of the guide.
    root = np.sqrt(0.12**2 - (0.05 * np.sin(angle)) ** 2)
    np.testing.assert_allclose(path.x_m, 0.05 * np.cos(angle) + root, atol=1e-13)
    np.testing.assert_allclose(path.y_m, 0, atol=1e-13)
    speed = 5000 * 2 * np.pi / 60
    velocity = -0.05 * np.sin(angle) * (1 + 0.05 * np.cos(angle) / root) * speed
    np.testing.assert_allclose(path.velocity_x_m_s, velocity, atol=1e-9)
    np.testing.assert_allclose(path.speed_m_s, np.abs(velocity), atol=1e-9)
    # Virtual power, and the angle of the rod.
    advantage = motion.mechanical_advantages["slider"]
    moving = np.abs(velocity) > 1e-3
    np.testing.assert_allclose(advantage[moving], (speed / np.abs(velocity))[moving], rtol=1e-9)
    assert np.isinf(advantage[[0, 180]]).all()
    np.testing.assert_allclose(motion.transmission_angles_rad["rod slider"], np.arcsin(np.abs(0.05 * np.sin(angle)) / 0.12), atol=1e-9)
    assert [each["name"] for each in motion.kinematics["ranges"]] == ["rod", "guide"]


def test_identity_the_zone_reaches_as_far_as_the_play(model):
    motion = model.motion(set={"joint.gudgeon.radial_clearance": "0.4 mm"}, paths=["slider.pin"])
    path = motion.paths["slider.pin"]
    # The slider moves along x alone: as far as its output.
    np.testing.assert_allclose(path.zone_m[:, :, 0].max(axis=1), motion["slider"].first_order, rtol=1e-9)
    np.testing.assert_allclose(path.zone_m[:, :, 1], 0, atol=1e-12)
    moving = path.tangent_x != 0
    np.testing.assert_allclose(path.play_along_m[moving], motion["slider"].first_order[moving], rtol=1e-9)
    figure = path.plot()
    assert figure.axes[0].get_xlabel() == "x of slider.pin [mm]"
    assert [text.get_text() for text in figure.axes[0].get_legend().get_texts()] == ["zone, magnified 10 times", "ideal path"]
    frame = motion.to_pandas()
    np.testing.assert_array_equal(frame["slider.pin play_along_m"], path.play_along_m)
    assert motion.to_xarray()["slider velocity"].attrs["units"] == "m/s"


def test_identity_paths_are_those_of_the_command(model, tmp_path):
    ended = command("motion", str(MODEL), "--path", "crank.pin", "--out", "run", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    motion = model.motion(paths=["crank.pin"])
    assert motion._native.summary_json() == (tmp_path / "run/summary.json").read_text(encoding="utf-8")
    motion.save(tmp_path / "saved")
    assert (tmp_path / "saved/motion.csv").read_bytes() == (tmp_path / "run/motion.csv").read_bytes()


def test_points_that_are_not_there_are_refused(model):
    with pytest.raises(lp.LoosepinError, match=r"paths: there is no point 'crank.pim'\nhint: did you mean 'crank.pin'\?"):
        model.motion(paths=["crank.pim"])
    with pytest.raises(TypeError, match="paths is a str; must be a list of str"):
        model.motion(paths="crank.pin")


def test_a_run_records_the_path_of_a_point(model):
    run = model.simulate(turns=0.5, transient=0, samples=40, second_run=False, states=True, paths=["crank.pin"])
    angle = run.states["crank"].angle_rad
    np.testing.assert_allclose(run["crank.pin x"], 0.05 * np.cos(angle), atol=1e-12)
    np.testing.assert_allclose(run["crank.pin velocity x"], -0.05 * np.sin(angle) * run.states["crank"].omega_rad_s, atol=1e-9)
