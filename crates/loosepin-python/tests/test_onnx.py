"""Networks that a study has learned say the same in ONNX, as an independent program evaluates it."""

import json

import loosepin as lp
import numpy as np
import onnx
import pytest
from conftest import STUDY, write_study
from onnx.reference import ReferenceEvaluator

# Relative to the largest value of a curve: round-off of sums in another order.
TOLERANCE = 1e-12


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """Of ideal positions: a number, a curve, and one whose inputs are a random number and an interval."""
    folder = tmp_path_factory.mktemp("onnx")
    head, _, _ = STUDY.partition("[[ask]]")
    head = head.replace('standard_deviation = "0.02 mm"', 'standard_deviation = "0.2 mm"')
    head = head.replace("recorded_turns = 0.1", "recorded_turns = 0.2")
    asks = '[[ask]]\noutput = "slider"\nof = "dimensional"\nposes = { crank = ["1.1 rad"] }\nstatistics = ["mean"]\n'
    asks += '[[ask]]\noutput = "slider"\nof = "dimensional"\nat = "cycle"\nstatistics = ["mean"]\n'
    text = head + '[surrogate]\nkind = "network"\ndirect = "confirming"\ntraining_runs = 14\nconfirming_runs = 8\n' + asks
    lp.Study.load(write_study(folder, text)).run(folder / "results", progress=False)
    return lp.Surrogates.load(folder / "results/surrogates.json")


def points(saved, model, seed, beyond=0.0):
    """Rows within the ranges of the file, or beyond them by a share of their widths."""
    ranges = json.loads({entry.key: entry.value for entry in model.metadata_props}["inputs"])
    assert [entry["path"] for entry in ranges] == list(saved.inputs)
    lower, upper = (np.array([entry[end] for entry in ranges]) for end in ("lower", "upper"))
    share = np.random.default_rng(seed).uniform(0.03, 0.97, (7, len(ranges)))
    return lower + share * (upper - lower) + beyond * (upper - lower)


def test_peer_networks_say_the_same_in_onnx(saved):
    places = []
    for output, about in enumerate(saved.outputs):
        model = onnx.load_from_string(saved.to_onnx(output))
        onnx.checker.check_model(model, full_check=True)
        rows = points(saved, model, seed=output + 3)
        (values,) = ReferenceEvaluator(model).run(None, {"inputs": rows})
        expected, _ = saved.predict(output, dict(zip(saved.inputs, rows.T, strict=True)))
        assert values.dtype == np.float64 and values.shape == expected.shape == (7, len(about.places))
        assert np.ptp(expected, axis=0).max() > 1e-5, "m; otherwise any constant would do"
        np.testing.assert_allclose(values, expected, rtol=0, atol=TOLERANCE * np.abs(expected).max())
        places.append(len(about.places))
    assert 1 in places and max(places) == 9, places


def test_what_lies_beyond_is_not_a_number(saved):
    model = onnx.load_from_string(saved.to_onnx(0))
    rows = points(saved, model, seed=8)
    beyond = points(saved, model, seed=8, beyond=1.0)
    for column in range(rows.shape[1]):
        mixed = rows.copy()
        mixed[2, column] = beyond[2, column]
        (values,) = ReferenceEvaluator(model).run(None, {"inputs": mixed})
        assert np.isnan(values).any(axis=1).tolist() == [False, False, True, False, False, False, False]


def test_the_file_says_what_its_numbers_are(saved):
    metadata = {entry.key: entry.value for entry in onnx.load_from_string(saved.to_onnx(0)).metadata_props}
    assert (metadata["study"], metadata["output"], metadata["of"], metadata["unit"]) == (saved.study, "slider", "dimensional", "m")
    assert json.loads(metadata["inputs"])[0]["unit"] == "m" and float(metadata["held_out_rms"]) > 0
    with pytest.raises(IndexError, match="counted from 0"):
        saved.to_onnx(len(saved.outputs))
