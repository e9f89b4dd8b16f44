"""Sobol' indices by SALib over `Model.evaluate`, against the contributors of a study: other points, other estimators, the same runs.

`LOOSEPIN_REWRITE_PAGES=1` writes the table of measured/sobol-indices.md anew; `just campaign sobol-indices` counts many seeds.
"""

import os
import re
import sys

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, REPOSITORY
from SALib.analyze import sobol as sobol_indices
from SALib.sample import sobol as sobol_sample
from scipy import stats

PAGE = REPOSITORY / "measured/sobol-indices.md"
# Lengths in m, mass in kg.
LAWS = {
    "parameter.crank_length": lp.Normal(0.05, 2e-5),
    "parameter.rod_length": lp.Normal(0.12, 3e-5),
    "joint.gudgeon.radial_clearance": lp.Uniform(2.5e-4, 3.5e-4),
    "contact.steel_pin.restitution": lp.Uniform(0.7, 0.9),
    "body.slider.mass": lp.Normal(0.14, 0.002),
}
# The same, as a study file states them.
STATED_LAWS = {
    "parameter.crank_length": {"normal": {"mean": "50 mm", "standard_deviation": "0.02 mm"}},
    "parameter.rod_length": {"normal": {"mean": "120 mm", "standard_deviation": "0.03 mm"}},
    "joint.gudgeon.radial_clearance": {"uniform": {"lower": "0.25 mm", "upper": "0.35 mm"}},
    "contact.steel_pin.restitution": {"uniform": {"lower": 0.7, "upper": 0.9}},
    "body.slider.mass": {"normal": {"mean": "0.14 kg", "standard_deviation": "2 g"}},
}
SHORT_NAMES = ["crank length", "rod length", "radial play", "restitution", "slider mass"]
DEVIATION = "slider total maximum_absolute"
FORCE = "gudgeon_force value maximum"
RESPONSES = {DEVIATION: "largest deviation of the slider", FORCE: "peak force in the pin"}
WORDS = {"first": "S1", "total": "ST"}

# Four tenths of a turn after the first contacts: some impacts, and milliseconds.
TURNS, TRANSIENT, SAMPLES, TOLERANCE = 0.4, 0.3, 40, "1e-7 m"
PAIRS = 512
# What SALib and the study state their errors at.
STATED = 0.95
# Twenty comparisons. All hold at the joint confidence, by Bonferroni's bound; at the stated one a single miss of twenty is no surprise.
JOINT = 1 - 0.01 / 20
MAX_MISSES = 1
# The study has eight replicates.
STUDENT = stats.t.ppf((1 + JOINT) / 2, 7) / stats.t.ppf((1 + STATED) / 2, 7)
NORMAL = stats.norm.ppf((1 + JOINT) / 2) / stats.norm.ppf((1 + STATED) / 2)


@pytest.fixture(scope="module")
def model():
    return lp.Model.load(MODEL)


def indices_of_study(model, seed=1, pairs=PAIRS):
    """Of each response and input: first-order and total index with their errors, as the study states them."""
    asks = [
        {"output": "slider", "of": "total", "reduce": "maximum_absolute", "statistics": ["contributors"]},
        {"output": "gudgeon_force", "of": "value", "reduce": "maximum", "statistics": ["contributors"]},
    ]
    study = lp.Study.from_dict(
        {
            "name": "contributors",
            "model": model,
            "seed": seed,
            "cycle": {"transient_turns": TRANSIENT, "recorded_turns": TURNS, "samples_per_turn": SAMPLES},
            "sampling": {"inner": pairs, "tolerance": TOLERANCE},
            "random": STATED_LAWS,
            "ask": asks,
        }
    )
    found = study.run(progress=False).summary["contributors"]
    assert all(each["pairs"] == pairs and each["confidence"] == STATED for each in found)
    by_path = [{own["paths"][0]: own for own in each["random"]} for each in found]
    return {
        (response, path, kind): (own[path][kind]["centre"], own[path][kind]["error"])
        for response, own in zip(RESPONSES, by_path)
        for path in LAWS
        for kind in WORDS
    }


def indices_of_salib(model, seed=1, pairs=PAIRS):
    """The same by SALib: its sampler, its estimators, its bootstrap."""
    problem = {"num_vars": len(LAWS), "names": list(LAWS), "bounds": [[0, 1]] * len(LAWS)}
    points = sobol_sample.sample(problem, pairs, calc_second_order=False, seed=seed)
    inputs = {path: law.ppf(column) for (path, law), column in zip(LAWS.items(), points.T)}
    runs = model.evaluate(
        inputs, list(RESPONSES), turns=TURNS, transient=TRANSIENT, samples=SAMPLES, tolerance=TOLERANCE, progress=False
    )
    assert not runs.failed.any() and len(runs[FORCE]) == pairs * (len(LAWS) + 2)
    found = {}
    for response in RESPONSES:
        of = sobol_indices.analyze(problem, runs[response], calc_second_order=False, conf_level=STATED, seed=1)
        for place, path in enumerate(LAWS):
            for kind, word in WORDS.items():
                found[response, path, kind] = of[word][place], of[f"{word}_conf"][place]
    return found


@pytest.fixture(scope="module")
def own(model):
    return indices_of_study(model)


@pytest.fixture(scope="module")
def salib(model):
    return indices_of_salib(model)


def test_peer_salib_and_the_study_agree_within_their_errors(own, salib):
    misses = []
    for key, (value, error) in own.items():
        other, error_of_other = salib[key]
        apart = abs(value - other)
        assert apart <= np.hypot(STUDENT * error, NORMAL * error_of_other), key
        if apart > np.hypot(error, error_of_other):
            misses.append(key)
    assert len(misses) <= MAX_MISSES, misses


def test_peer_interactions_are_seen_by_both(own, salib):
    """Play and restitution decide together when the pin strikes: the total index is above that of first order by more than both errors."""
    for found in (own, salib):
        for path in ("joint.gudgeon.radial_clearance", "contact.steel_pin.restitution"):
            (first, error), (total, error_of_total) = (found[FORCE, path, kind] for kind in WORDS)
            assert total - first > error + error_of_total


def table(own, salib) -> str:
    lines = ["| response | input | first order: study | SALib | total: study | SALib |", "|---|---|--:|--:|--:|--:|"]
    for response, words in RESPONSES.items():
        for path, short in zip(LAWS, SHORT_NAMES):
            pairs = [found[response, path, kind] for kind in WORDS for found in (own, salib)]
            cells = [f"{value:.3f} ± {error:.3f}".replace("-0.000", "0.000") for value, error in pairs]
            lines.append(" | ".join([f"| {words}", short, *cells]) + " |")
    return "\n".join(lines) + "\n"


def test_the_table_of_the_page_is_that_of_these_runs(own, salib):
    page, due = PAGE.read_text(encoding="utf-8"), table(own, salib)
    pattern = re.compile(r"(?<=<!-- indices of SALib -->\n\n)(\|.*\n)*(?=\n<!-- end of indices -->)")
    if os.environ.get("LOOSEPIN_REWRITE_PAGES"):
        PAGE.write_text(pattern.sub(lambda _: due, page), encoding="utf-8")
    else:
        assert pattern.search(page)[0] == due


def count_seeds(seeds: int) -> None:
    """How often both agree within √(e₁² + e₂²) of their errors of 95 %, of `seeds` seeds and ten indices a line."""
    model = lp.Model.load(MODEL)
    pairs = [(indices_of_study(model, seed), indices_of_salib(model, seed)) for seed in range(1, seeds + 1)]
    for response in RESPONSES:
        for kind in WORDS:
            keys = [(response, path, kind) for path in LAWS]
            agree = sum(
                abs(own[key][0] - other[key][0]) <= np.hypot(own[key][1], other[key][1]) for own, other in pairs for key in keys
            )
            print(f"{RESPONSES[response]}, {kind}: {agree} of {len(keys) * seeds} agree", flush=True)


if __name__ == "__main__":
    count_seeds(int(sys.argv[1]))
