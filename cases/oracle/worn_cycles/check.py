"""Holds worn_cycles.cpp, with the radii of the given program, against its turn and its 4000 cycles by 32 jumps.

    python3 check.py        # one line a check; exit status 1 if one fails; needs g++ or the compiler named in CXX
"""

import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from reporting import report, status  # noqa: E402  (it lies in the folder above)

GIVEN = HERE.parents[2] / "crates/loosepin-simulate/tests/files"
GIVEN_STEP_S = 4e-6  # its volumes depend on the step from the eleventh digit on
# Friction path of a settled turn on the unworn shape by sectors, J; volumes, m³, and path, J, after 4000 cycles.
GIVEN_PATHS_J = {180: 8.80037407, 360: 8.80006663842, 720: 8.80007210}
GIVEN_END = {
    "bearing_volume_m3": 7.11917115083e-10,
    "journal_volume_m3": 3.55958557541e-10,
    "path_work_j": 8.98318500365,
}
LAST_DIGIT = 1.2e-9  # one of the last of the nine given with 180 and 720 sectors, relative
VOLUME_TOLERANCE = 1e-10  # relative; twelve digits are given
POSITION_TOLERANCE = 4e-11  # m and rad; the given steps halved change positions by 3.2e-11
DEPTH_TOLERANCE_M = 1e-14  # twelve digits of 7 µm, and sums in another order over 64 turns
ENERGY_TOLERANCE_J = 1e-11  # of some 8 J that are exchanged, with steps of 1 µs


def rows(text):
    return [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(text.splitlines())]


def off(found, given):
    return abs(found / given - 1.0)


def largest(found, given, column):
    assert len(found) == len(given), (len(found), len(given))
    return max(abs(one[column] - other[column]) for one, other in zip(found, given))


def main():
    with tempfile.TemporaryDirectory() as folder:
        binary, turn, depths = (Path(folder) / name for name in ("worn_cycles", "turn.csv", "depths.csv"))
        compiler = os.environ.get("CXX", "g++")
        subprocess.run([compiler, "-O3", "-std=c++17", "-o", binary, HERE / "worn_cycles.cpp"], check=True)

        def run(*options):
            command = [binary, *map(str, options)]
            return rows(subprocess.run(command, check=True, capture_output=True, text=True).stdout)

        given = ("--radii", "nominal", "--step", GIVEN_STEP_S)
        for sectors, path_j in GIVEN_PATHS_J.items():
            tolerance = VOLUME_TOLERANCE if sectors == 360 else LAST_DIGIT
            found = run(*given, "--jumps", 0, "--sectors", sectors, "--turn", turn)[0]
            report(f"friction path of a turn, {sectors} sectors", off(found["path_work_j"], path_j), tolerance)
            if sectors == 360:
                history, wanted = rows(turn.read_text()), rows((GIVEN / "wear_cycles_first_turn.csv").read_text())
                for column in ("rod_angle", "slider_x_m"):
                    report(f"{column} over the turn", largest(history, wanted, column), POSITION_TOLERANCE)
        life = run(*given, "--jumps", 32, "--depths", depths)
        for name, value in GIVEN_END.items():
            report(f"{name} after 4000 cycles by 32 jumps", off(life[-1][name], value), VOLUME_TOLERANCE)
        shape, wanted = rows(depths.read_text()), rows((GIVEN / "wear_cycles_profile.csv").read_text())
        for column in ("bearing_depth_m", "journal_depth_m"):
            report(f"{column} after 4000 cycles by 32 jumps", largest(shape, wanted, column), DEPTH_TOLERANCE_M)
        worn = run("--jumps", 0, "--step", 1e-6, "--shape", depths)[0]
        report("energy account of a turn on that shape", abs(worn["energy_residual_j"]), ENERGY_TOLERANCE_J)
    return status()


if __name__ == "__main__":
    sys.exit(main())
