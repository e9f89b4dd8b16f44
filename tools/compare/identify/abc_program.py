"""Approximate Bayesian computation of the play of the worn pin, by the runs and for the readings of two tables.

    python abc_program.py RUNS.csv READINGS.csv CONFIDENCE

Prints one JSON object for each method and reading. RUNS.csv has play_mm, peak_m_s2 and rms_m_s2 of runs whose plays are spread evenly over
the prior; READINGS.csv is that of the case. Two methods: rejection (the nearest share of the runs is kept), and rejection with local linear
regression of the play on the features (M. A. Beaumont, W. Zhang, D. J. Balding, "Approximate Bayesian computation in population genetics",
Genetics 162 (2002) 2025-2035), of the logit of the play, so that it stays within the prior.
"""

import csv
import json
import sys
import time

import numpy as np

GAIN_ERROR = 0.05
PRIOR_MM = (0.1, 0.5)
SHARES = (0.002, 0.01, 0.05)  # of the runs that are kept
SEED = 20260


def read(path, names):
    with open(path, encoding="utf-8", newline="") as file:
        return [{name: row[name] for name in names} for row in csv.DictReader(file)]


def weighted_quantile(values, weights, levels):
    order = np.argsort(values)
    below = np.cumsum(weights[order]) - 0.5 * weights[order]
    return np.interp(levels, below / weights.sum(), values[order])


def main(runs_path, readings_path, confidence):
    rows = read(runs_path, ["play_mm", "peak_m_s2", "rms_m_s2"])
    play = np.array([float(row["play_mm"]) for row in rows])
    # The gain of the sensor is drawn from its prior for each run.
    gain = 1.0 + GAIN_ERROR * np.random.default_rng(SEED).uniform(-1.0, 1.0, len(rows))
    features = np.array([[float(row["peak_m_s2"]), float(row["rms_m_s2"])] for row in rows])
    features = np.log(features * gain[:, None])
    scale = features.std(axis=0)
    low, high = PRIOR_MM
    logit = np.log((play - low) / (high - play))
    levels = [0.5 * (1.0 - confidence), 0.5 * (1.0 + confidence)]
    for reading in read(readings_path, ["alternative", "seed", "play_mm", "peak_m_s2", "rms_m_s2"]):
        seen = np.log([float(reading["peak_m_s2"]), float(reading["rms_m_s2"])])
        for share in SHARES:
            for method in ("rejection", "regression"):
                start = time.process_time()
                distance = np.linalg.norm((features - seen) / scale, axis=1)
                count = round(share * len(rows))
                nearest = np.argpartition(distance, count)[: count + 1]
                width = distance[nearest].max()
                nearest = nearest[distance[nearest] < width]
                if method == "rejection":
                    ends = np.quantile(play[nearest], levels)
                else:
                    weights = 1.0 - (distance[nearest] / width) ** 2
                    design = np.column_stack([np.ones(len(nearest)), features[nearest] - seen])
                    root = np.sqrt(weights)
                    slopes = np.linalg.lstsq(design * root[:, None], logit[nearest] * root, rcond=None)[0]
                    adjusted = logit[nearest] - (features[nearest] - seen) @ slopes[1:]
                    ends = weighted_quantile(adjusted, weights, levels)
                    ends = low + (high - low) / (1.0 + np.exp(-ends))
                told = {
                    "method": method,
                    "share": share,
                    "kept": len(nearest),
                    "alternative": reading["alternative"],
                    "play_mm": float(reading["play_mm"]),
                    "low_mm": float(ends[0]),
                    "high_mm": float(ends[1]),
                    "seconds": time.process_time() - start,
                }
                print(json.dumps(told), flush=True)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
