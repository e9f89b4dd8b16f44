"""Ctrl-C ends a study soon and loses nothing; other threads go on meanwhile."""

import os
import signal
import subprocess
import sys
import threading
import time

import loosepin as lp
import pytest
from conftest import REPOSITORY

LONG_STUDY = REPOSITORY / "cases/slider_crank_worn_pin/study.toml"

CHILD = """
import sys
import loosepin as lp

def told(finished, most):
    if finished > 64:
        print("running", flush=True)

try:
    lp.Study.load(sys.argv[1]).run(sys.argv[2], threads=2, progress=told)
except KeyboardInterrupt as interrupt:
    print(interrupt, flush=True)
    sys.exit(130)
"""

# s; how long an end is waited for, on a busy machine. By themselves the calls end after minutes.
PATIENCE_S = 60
# How often the other thread has counted between two signs of progress, at least once.
COUNTED = 20


@pytest.mark.skipif(os.name != "posix", reason="signals as on Unix")
def test_ctrl_c_ends_a_long_study_and_keeps_its_runs(tmp_path):
    child = subprocess.Popen(
        [sys.executable, "-c", CHILD, str(LONG_STUDY), str(tmp_path / "kept")], stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None and child.stdout.readline() == "running\n"
    child.send_signal(signal.SIGINT)
    printed, _ = child.communicate(timeout=PATIENCE_S)
    assert child.returncode == 130
    last = printed.splitlines()[-1]
    assert last.startswith("interrupted after ") and last.endswith("the same call with resume=True continues"), printed
    assert (tmp_path / "kept/runs.sqlite").exists()


# A run of minutes, of which only the last of very many turns is recorded: nothing is seen of it until then.
LONG_RUN = """
import sys, threading, time
import loosepin as lp

model = lp.Model.load(sys.argv[1])
print("running", flush=True)
try:
    model.simulate(transient=float(sys.argv[2]), turns=float(sys.argv[3]), samples=10)
except KeyboardInterrupt:
    print("stopped", flush=True)
    sys.exit(130)
"""


def assert_ctrl_c_ends(script, *arguments):
    """`script` prints "running" before its long call, and "stopped" when that is interrupted."""
    command = [sys.executable, "-c", script, *(str(argument) for argument in arguments)]
    child = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None and child.stdout.readline() == "running\n"
    time.sleep(0.7)
    assert child.poll() is None, "it ended by itself"
    child.send_signal(signal.SIGINT)
    printed, _ = child.communicate(timeout=PATIENCE_S)
    assert (child.returncode, printed) == (130, "stopped\n")


@pytest.mark.skipif(os.name != "posix", reason="signals as on Unix")
@pytest.mark.parametrize("transient, turns", [(90000, 1), (0, 90000)])
def test_ctrl_c_ends_a_single_long_run(transient, turns):
    model = REPOSITORY / "cases/slider_crank_worn_pin/model.toml"
    assert_ctrl_c_ends(LONG_RUN, model, transient, turns)


def test_identity_an_interrupted_study_goes_on_to_the_same_result(desk, result, tmp_path):
    study = lp.Study.load(desk / "study.toml")
    folder = tmp_path / "kept"

    def interrupt(finished, most):
        if finished > 100:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt, match="interrupted after .* resume=True continues"):
        study.run(folder, threads=1, progress=interrupt)
    with pytest.raises(lp.LoosepinError) as refused:
        study.run(folder)
    assert refused.value.code == "E0910"
    resumed = study.run(folder, resume=True, progress=False)
    assert resumed._native.summary_json() == result._native.summary_json()


def test_what_a_listener_raises_comes_out_unchanged():
    class Enough(Exception):
        pass

    def stop(finished, most):
        raise Enough("of this")

    with pytest.raises(Enough, match="of this"):
        lp.Study.load(LONG_STUDY).run(progress=stop)


def test_other_threads_run_while_a_study_computes():
    counted, is_over, last, most = 0, threading.Event(), None, 0

    class Enough(Exception):
        pass

    def count():
        nonlocal counted
        while not is_over.is_set():
            counted += 1
            time.sleep(0.001)

    def stop(finished, runs):
        nonlocal last, most
        most = max(most, counted - last if last is not None else 0)
        last = counted
        # Were the lock held, the thread would count once or twice in each sign of progress, and never this often between two of them.
        if most >= COUNTED:
            raise Enough

    thread = threading.Thread(target=count)
    study = lp.Study.load(LONG_STUDY)
    thread.start()
    try:
        with pytest.raises(Enough):
            study.run(threads=1, progress=stop)
    finally:
        is_over.set()
        thread.join()


LONG_MOTION = """
import sys
import loosepin as lp

model = lp.Model.load(sys.argv[1])
print("running", flush=True)
try:
    model.motion()
except KeyboardInterrupt:
    print("stopped", flush=True)
    sys.exit(130)
"""

LINKAGE = """
[body.crank{k}]
mass = "0.3 kg"
inertia = "2e-4 kg m^2"
points = {{ main = ["0 mm", "0 mm"], pin = ["68 mm", "0 mm"] }}
[body.coupler{k}]
mass = "0.4 kg"
inertia = "2e-3 kg m^2"
points = {{ crank_end = ["0 mm", "0 mm"], rocker_end = ["224 mm", "0 mm"] }}
[body.rocker{k}]
mass = "0.3 kg"
inertia = "7e-4 kg m^2"
points = {{ foot = ["0 mm", "0 mm"], tip = ["143 mm", "0 mm"] }}
[joint.main{k}]
kind = "revolute"
bearing = "ground.crank_pivot"
journal = "crank{k}.main"
[joint.pin{k}]
kind = "revolute"
bearing = "crank{k}.pin"
journal = "coupler{k}.crank_end"
bearing_radius = "10 mm"
radial_clearance = "0.28 mm"
contact = "steel"
[joint.tip{k}]
kind = "revolute"
bearing = "rocker{k}.tip"
journal = "coupler{k}.rocker_end"
bearing_radius = "9 mm"
radial_clearance = "0.14 mm"
contact = "steel"
[joint.foot{k}]
kind = "revolute"
bearing = "ground.rocker_pivot"
journal = "rocker{k}.foot"
bearing_radius = "16 mm"
radial_clearance = "0.09 mm"
contact = "steel"
[drive.crank{k}]
joint = "main{k}"
speed = "540 rpm"
start_angle = "205 deg"
[output.rocker{k}]
angle_of = "rocker{k}"
"""


def many_linkages(count: int) -> str:
    """So many four-bars beside each other, with play in three joints each: the worst cases of eight take half a minute."""
    head = (
        'name = "many linkages"\n[body.ground]\npoints = { crank_pivot = ["0 mm", "0 mm"], rocker_pivot = ["257 mm", "-15 mm"] }\n'
        '[contact.steel]\nlaw = "hertz"\nrestitution = 0.9\nyoungs_modulus = "207 GPa"\npoisson_ratio = 0.3\n[cycle]\ndrive = "crank0"\n'
    )
    guess = ", ".join(f'rocker{k} = "145 deg"' for k in range(count))
    return head + f"[assembly]\nguess = {{ {guess} }}\n" + "".join(LINKAGE.format(k=k) for k in range(count))


@pytest.mark.skipif(os.name != "posix", reason="signals as on Unix")
def test_ctrl_c_ends_worst_cases(tmp_path):
    path = tmp_path / "model.toml"
    path.write_text(many_linkages(8), encoding="utf-8")
    assert_ctrl_c_ends(LONG_MOTION, path)
