"""Ten turns of the slider, as an accelerometer would see them: made by cases/oracle, which shares nothing with the program.

Each seed draws play, restitution and lengths as measured.toml declares them, runs the mechanism of model.toml for two turns and ten
more, and takes the largest magnitude and the rms of the acceleration of the slider over the ten. The gain of the sensor is off by up to
5 %, the same for both. Alternatives are mechanisms that the study does not allow: a crank pin with play as well, of 0.3 mm (`joint`) or
1 mm (`worn_joint`), and friction of 0.3 in the worn pin, whose play is anywhere in its interval (`friction`) or between 0.3 and 0.5 mm, for
a study that knows this (`friction_known_play`).

    python motion_readings.py > motion_repetitions.csv     100 seeds, and 100 of each alternative
    python motion_readings.py 20 5 joint                   seeds 5 to 19 of one alternative

Needs cases/oracle/requirements.txt.
"""

import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "oracle"))

import mechanics  # noqa: E402
import model_file  # noqa: E402
from integrate import ONSET, Settings, run  # noqa: E402

TRANSIENT, RECORDED = 2, 10
SAMPLES = 5000  # a turn: 2.4 us, of a contact of 30 us
SETTINGS = Settings(position_error=1e-10, velocity_error=1e-7, largest_step_s=2e-5)
ERROR = 0.05
CRANK_PIN = '[joint.crank_pin]\nkind = "revolute"\nbearing = "crank.pin"\njournal = "rod.big_end"\n'
# Play of the crank pin, mm; friction in the worn pin; interval of its play, mm.
ALTERNATIVES = {
    "none": (None, None, (0.1, 0.5)),
    "joint": (0.3, None, (0.1, 0.5)),
    "worn_joint": (1.0, None, (0.1, 0.5)),
    "friction": (None, 0.3, (0.1, 0.5)),
    "friction_known_play": (None, 0.3, (0.3, 0.5)),
}
FRICTION = 'density = "7800 kg/m^3"                              # for the law\'s validity limit\n'


def model_text(alternative, play_mm, restitution, crank_mm, rod_mm):
    text = (HERE / "model.toml").read_text()
    changes = [
        ('crank_length = "50 mm"', f'crank_length = "{crank_mm!r} mm"'),
        ('rod_length = "120 mm"', f'rod_length = "{rod_mm!r} mm"'),
        ("restitution = 0.8 ", f"restitution = {restitution!r} "),
        ('radial_clearance = "0.3 mm"', f'radial_clearance = "{play_mm!r} mm"'),
    ]
    second_play_mm, friction, _ = ALTERNATIVES[alternative]
    if second_play_mm:
        play = f'bearing_radius = "10 mm"\nradial_clearance = "{second_play_mm} mm"\ncontact = "steel_pin"\n'
        changes.append((CRANK_PIN, CRANK_PIN + play))
    if friction:
        changes.append((FRICTION, FRICTION + f'friction = {{ law = "ambrosio", coefficient = {friction} }}\n'))
    for old, new in changes:
        if text.count(old) != 1:
            raise SystemExit(f"model.toml does not hold {old!r} once")
        text = text.replace(old, new)
    return text


def features(text):
    """Largest magnitude and rms of the acceleration of the slider, m/s^2, and impacts a turn."""
    path = Path("/tmp") / f"motion_readings_{hash(text) & 0xFFFFFFFF}.toml"
    path.write_text(text)
    mechanism = model_file.read(path)
    path.unlink()
    system = mechanics.tables(mechanism)
    start, _ = mechanics.assemble(mechanism, system)
    turn_s = 2.0 * np.pi / abs(mechanism.drive_speed_rad_s)
    turns = TRANSIENT + RECORDED
    history = run(start, np.linspace(0.0, turns * turn_s, turns * SAMPLES + 1), system, SETTINGS)
    bodies = len(mechanism.bodies)
    slider = next(k for k, body in enumerate(mechanism.bodies) if body.name == "slider")
    acceleration = history.rows[TRANSIENT * SAMPLES :, 1 + 6 * bodies + 3 * slider]
    onsets = history.events[(history.events[:, 2] == ONSET) & (history.events[:, 0] >= TRANSIENT * turn_s)]
    return np.abs(acceleration).max(), np.sqrt(np.mean(acceleration**2)), len(onsets) / RECORDED


def main(seeds, alternatives):
    print("alternative,seed,play_mm,restitution,crank_mm,rod_mm,gain,peak_m_s2,rms_m_s2,impacts")
    for alternative in alternatives:
        for seed in seeds:
            random = np.random.default_rng([seed, 31])
            truth = [
                float(random.uniform(*ALTERNATIVES[alternative][2])),
                float(random.uniform(0.7, 0.9)),
                float(random.normal(50.0, 0.02)),
                float(random.normal(120.0, 0.03)),
            ]
            gain = 1.0 + ERROR * float(random.uniform(-1.0, 1.0))
            peak, rms, impacts = features(model_text(alternative, *truth))
            numbers = [*truth, gain, gain * peak, gain * rms, impacts]
            print(",".join([alternative, str(seed), *(f"{number:.7g}" for number in numbers)]), flush=True)


if __name__ == "__main__":
    first, behind = int(sys.argv[2]) if len(sys.argv) > 2 else 0, int(sys.argv[1]) if len(sys.argv) > 1 else 100
    main(range(first, behind), sys.argv[3:] or ALTERNATIVES)
