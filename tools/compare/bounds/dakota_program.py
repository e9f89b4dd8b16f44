"""Dakota: nested models as its user's manual has them for mixed aleatory and epistemic uncertainty.

An outer method over the two intervals, an inner one over the two normal lengths: second-order probability (sampling in
sampling), and interval-valued probability (`global_interval_est ego`, `local_interval_est`) around sampling or a polynomial
chaos. Dakota writes the least and greatest of each statistic to its output file, which is read here.
"""

import os
import re
import tempfile
from pathlib import Path

import dakota.environment
import numpy as np
from problem import CLEARANCE_MM, CRANK_MM, DIRECTION_RAD, ROD_MM, STATISTICS, Bounds, Response, conduct

# What the inner method gives, in its order: mean, deviation, P(y <= level) at four levels, two quantiles. P(|y| > limit) is
# 1 - P(y <= limit) + P(y <= -limit); a mapping has no constants, so the 1 is added on reading.
MAPPING = """
      1 0  0  0 0 0  0 0
      0 1  0  0 0 0  0 0
      0 0  0  0 0 0  1 0
      0 0  0  0 0 0  0 1
      0 0  0  1 -1 0  0 0
      0 0  1  0 0 -1  0 0"""

INTERVALS = f"""
  continuous_interval_uncertain = 2
    descriptors = 'c' 'p'
    lower_bounds = {CLEARANCE_MM[0]} {DIRECTION_RAD[0]}
    upper_bounds = {CLEARANCE_MM[1]} {DIRECTION_RAD[1]!r}"""

STUDY = """
environment
  output_file 'output'
  top_method_pointer = 'outer'

method
  id_method = 'outer'
  output normal
  model_pointer = 'statistics'
  {outer}

model
  id_model = 'statistics'
  nested
    variables_pointer = 'intervals'
    responses_pointer = 'bounded'
    sub_method_pointer = 'inner'
    primary_variable_mapping = 'c' 'p'
    primary_response_mapping = {mapping}

variables
  id_variables = 'intervals'
{intervals}

responses
  id_responses = 'bounded'
  response_functions = 6
  {gradients}
  no_hessians

method
  id_method = 'inner'
  output silent
  model_pointer = 'simulation'
  {inner}
    probability_levels = 0.025 0.975
    response_levels = -0.6 -0.45 0.45 0.6
    distribution cumulative

model
  id_model = 'simulation'
  single
    variables_pointer = 'all'
    responses_pointer = 'simulated'
    interface_pointer = 'program'

variables
  id_variables = 'all'
  active aleatory
  normal_uncertain = 2
    descriptors = 'r' 'l'
    means = {means}
    std_deviations = {deviations}
{intervals}

interface
  id_interface = 'program'
  python
    analysis_drivers = 'simulate'
  deactivate evaluation_cache restart_file

responses
  id_responses = 'simulated'
  response_functions = 1
  no_gradients
  no_hessians
"""

SAMPLING = "sampling sample_type lhs samples = {samples} seed = {seed}"
CHAOS = "polynomial_chaos quadrature_order = 4 samples_on_emulator = 10000 seed = {seed}"
# With the default (no limit short of convergence) one seed did not end within 80 s of processor time.
EGO = "global_interval_est ego seed = {seed} max_iterations = 8"
NUMERICAL = "numerical_gradients fd_step_size = 1.e-4"


def study(outer: str, inner: str, gradients: str = "no_gradients") -> tuple[str, int]:
    """What Dakota writes to its output file, and the number of evaluations."""
    response = Response()

    def simulate(parameters: dict) -> dict:
        crank_mm, rod_mm, clearance_mm, direction_rad = parameters["cv"]
        return {"fns": np.array([response(crank_mm, rod_mm, clearance_mm, direction_rad)])}

    text = STUDY.format(
        outer=outer,
        inner=inner,
        gradients=gradients,
        mapping=MAPPING,
        intervals=INTERVALS,
        means=f"{CRANK_MM[0]} {ROD_MM[0]}",
        deviations=f"{CRANK_MM[1]} {ROD_MM[1]}",
    )
    with tempfile.TemporaryDirectory() as folder:
        before = os.getcwd()
        os.chdir(folder)
        try:
            dakota.environment.study(callbacks={"simulate": simulate}, input_string=text).execute()
        finally:
            os.chdir(before)
        return (Path(folder) / "output").read_text(encoding="utf-8"), response.evaluations


NUMBER = r"([-+0-9.eEnaif]+)"


def read(told: str) -> Bounds:
    """Least and greatest of the six statistics."""
    found = re.findall(rf"^response_fn_(\d):\s+Min = +{NUMBER}\s+Max = +{NUMBER}", told, re.MULTILINE)
    if [int(index) for index, _, _ in found] != list(range(1, len(STATISTICS) + 1)):
        raise ValueError(f"Dakota's output has bounds of {len(found)} statistics; must be {len(STATISTICS)}")
    bounds = {}
    for (_, low, high), name in zip(found, STATISTICS, strict=True):
        added = 1.0 if name.startswith("beyond") else 0.0
        bounds[name] = (added + float(low), added + float(high))
    return bounds


def method(outer: str, inner: str, gradients: str = "no_gradients"):
    """A study for each seed."""

    def conduct_study(seed: int) -> tuple[Bounds, int]:
        # The seed of the inner method is the same at every outer point: common random numbers, Dakota's default.
        told, evaluations = study(outer.format(seed=seed), inner.format(seed=1000 + seed, samples=200), gradients)
        return read(told), evaluations

    return conduct_study


if __name__ == "__main__":
    conduct(
        [
            ("sampling (100) around sampling (200)", method("sampling sample_type lhs samples = 100 seed = {seed}", SAMPLING)),
            ("global_interval_est ego around polynomial chaos", method(EGO, CHAOS)),
            ("global_interval_est ego around sampling (200)", method(EGO, SAMPLING)),
            ("local_interval_est around sampling (200)", method("local_interval_est", SAMPLING, NUMERICAL)),
        ]
    )
