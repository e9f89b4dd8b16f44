"""A study on a Dask cluster of worker processes gives the bytes of the study on one machine, whatever happens to a worker."""

import os
import pickle
import signal
import sys
import time

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, RANDOM_STUDY, STUDY, command, write_study
from loosepin import _cluster

distributed = pytest.importorskip("distributed")

FILES = ["summary.json", "bounds.csv", "runs.parquet", "report.html"]
# s; a worker that was killed is missed when its connection breaks, and its successor starts within seconds.
MISSED_S = 30

# In some samples the crank is longer than the rod: those runs fail.
FAILING = """
name = "cranks that are too long"
model = "model.toml"
seed = 5
[cycle]
transient_turns = 0
recorded_turns = 0.25
samples_per_turn = 40
[sampling]
outer = 3
inner = 8
replicates = 4
most_failed = 0.9
tolerance = "1e-6 m"
[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "3 mm" } }
[epistemic]
"parameter.rod_length" = { interval = ["51.5 mm", "120 mm"] }
[[ask]]
output = "slider"
of = "clearance"
reduce = "maximum"
statistics = ["mean"]
"""

# Studies of their own with loosened inputs, whose runs are others than those of the study.
ALLOWING = STUDY.replace("recorded_turns = 0.1", "recorded_turns = 0.01") + """
[allow]
"joint.gudgeon.radial_clearance" = { up_to = "0.7 mm" }
"""


# A hundredth of a turn is run in a fraction of the time.
SHORT = STUDY.replace("recorded_turns = 0.1", "recorded_turns = 0.01")


# The same with nothing unknown: a few dozen runs.
RANDOM = RANDOM_STUDY.replace("recorded_turns = 0.1", "recorded_turns = 0.01")


@pytest.fixture(scope="module")
def random():
    return lp.Study.from_text(RANDOM, lp.Model.load(MODEL))


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    """A folder with a short study, and the results of the command in `command`."""
    folder = tmp_path_factory.mktemp("cluster")
    write_study(folder, SHORT)
    ended = command("study", "study.toml", "--out", "command", cwd=folder)
    assert ended.returncode in (0, 1), ended.stderr
    return folder


@pytest.fixture(scope="module")
def client():
    with distributed.LocalCluster(
        n_workers=1, processes=True, threads_per_worker=1, dashboard_address=None, host="127.0.0.1"
    ) as cluster, distributed.Client(cluster) as client:
        yield client


def grow(client, workers):
    client.cluster.scale(workers)
    client.wait_for_workers(workers, timeout=MISSED_S)
    assert len(client.nthreads()) == workers


def held(client):
    """Keys that the cluster still holds for the client, a moment after their release."""
    deadline = time.monotonic() + MISSED_S
    while client.futures and time.monotonic() < deadline:
        time.sleep(0.02)
    return {key: state.status for key, state in client.futures.items()}


def same_files(desk, folder):
    return [file for file in FILES if (desk / folder / file).read_bytes() != (desk / "command" / file).read_bytes()] == []


@pytest.mark.parametrize("workers", [1, 2, 4])
def test_identity_any_number_of_workers_gives_the_files_of_the_command(client, desk, workers):
    grow(client, workers)
    told = []
    study = lp.Study.load(desk / "study.toml")
    made = study.run(desk / f"workers{workers}", client=client, progress=lambda *numbers: told.append(numbers))
    assert same_files(desk, f"workers{workers}")
    assert told[-1] == (made.summary["counts"]["runs"],) * 2
    assert not (desk / f"workers{workers}/runs.sqlite").exists()
    assert held(client) == {}


@pytest.mark.skipif(os.name != "posix", reason="signals as on Unix")
def test_identity_a_worker_that_is_killed_changes_nothing(client, desk, monkeypatch):
    grow(client, 4)
    before = client.run(os.getpid)
    wait, killed = distributed.wait, []

    def wait_and_kill(futures, **options):
        finished = wait(futures, **options)
        # In the middle of the first round: some tasks are done, and this worker has others.
        busy = [address for address, tasks in client.processing().items() if tasks and address in before]
        if busy and not killed:
            killed.append(before[busy[0]])
            os.kill(killed[0], signal.SIGKILL)
        return finished

    monkeypatch.setattr(distributed, "wait", wait_and_kill)
    lp.Study.load(desk / "study.toml").run(desk / "killed", client=client, progress=False)
    assert killed, "no worker had anything to do"
    assert same_files(desk, "killed")
    client.wait_for_workers(4, timeout=MISSED_S)
    assert killed[0] not in client.run(os.getpid).values()


def test_identity_an_interrupted_study_goes_on_with_or_without_a_cluster(client, desk, tmp_path):
    study = lp.Study.load(desk / "study.toml")

    def interrupt(finished, most):
        if finished > 100:
            raise KeyboardInterrupt

    for folder, resumed_by in [("there", client), ("here", None)]:
        with pytest.raises(KeyboardInterrupt, match="interrupted after .* resume=True continues"):
            study.run(desk / folder, client=client, progress=interrupt)
        assert held(client) == {}, "what was asked for is taken back"
        assert (desk / folder / "runs.sqlite").exists()
        study.run(desk / folder, client=resumed_by, resume=True, progress=False)
        assert same_files(desk, folder)


@pytest.mark.parametrize("text", [FAILING, ALLOWING], ids=["failing", "allowing"])
def test_identity_failed_runs_and_loosened_inputs_are_the_same(client, text):
    study = lp.Study.from_text(text, lp.Model.load(MODEL))
    here, there = study.run(progress=False), study.run(client=client, progress=False)
    assert there._native.summary_json() == here._native.summary_json()
    for name in here.samples:
        np.testing.assert_array_equal(there.samples[name], here.samples[name], err_msg=name)
    if text is FAILING:
        assert 0 < here.summary["counts"]["failed"] < here.summary["counts"]["runs"]
    else:
        assert here.summary["allowances"]


def test_identity_a_study_with_tables_needs_no_files_on_the_workers(client, tmp_path):
    rods = "\n".join(f"{119.96 + 0.007 * row:.3f}" for row in range(12))
    (tmp_path / "rods.csv").write_text(f"rod length [mm]\n{rods}\n", encoding="utf-8")
    text = RANDOM.replace(
        '{ normal = { mean = "120 mm", standard_deviation = "0.03 mm" } }', '{ samples = "rods.csv" }'
    )
    study = lp.Study.load(write_study(tmp_path, text))
    for name in ("rods.csv", "study.toml", "model.toml"):
        (tmp_path / name).unlink()
    here = study.run(progress=False)
    assert study.run(client=client, progress=False)._native.summary_json() == here._native.summary_json()
    again = pickle.loads(pickle.dumps(study))
    assert (again.name, again.text, again.model.text) == (study.name, study.text, study.model.text)
    assert again.run(progress=False)._native.summary_json() == here._native.summary_json()


def test_identity_accuracy_and_budget_reach_the_workers(client, random):
    stated = {"accuracy": ["slider.mean=0.5 um"], "budget": "2200 runs", "progress": False}
    here, there = random.run(**stated), random.run(client=client, **stated)
    assert there._native.summary_json() == here._native.summary_json()


def test_identity_a_further_output_keeps_its_bounds(client, random):
    asked = (lambda run: np.ptp(run["slider total"], axis=1), ["mean", {"quantile": 0.975}])
    here, there = random.bounds(*asked, progress=False), random.bounds(*asked, progress=False, client=client)
    assert there.bounds == here.bounds
    np.testing.assert_array_equal(there.outputs["y"], here.outputs["y"])


def test_what_a_worker_raises_comes_out_and_the_folder_is_kept(client, random, tmp_path, monkeypatch):
    monkeypatch.setattr(_cluster._loosepin, "__version__", "0.0.3")
    with pytest.raises(RuntimeError, match="a worker has loosepin .*, the caller 0.0.3: other versions may give other numbers"):
        random.run(tmp_path / "kept", client=client, progress=False)
    monkeypatch.undo()
    there = random.run(tmp_path / "kept", client=client, resume=True, progress=False)
    assert there._native.summary_json() == random.run(progress=False)._native.summary_json()


def test_what_is_no_client_is_refused(client, random, monkeypatch):
    with pytest.raises(TypeError, match="client is a str; must be a distributed.Client"):
        random.run(client="tcp://127.0.0.1:8786")
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ImportError, match="client=... needs distributed, which cannot be imported\nhint: pip install distributed"):
        random.run(client=client)
