"""How smoothly the studio follows a pin that is dragged and a canvas that is zoomed, and how soon it shows something.

    just studio-bench                 (builds the release program first)
    python3 tools/studio/frames.py PROGRAM [--busy]

For a four-bar, a six-bar and a chain of ten four-bars (21 bodies): frames that came late (more than 25 ms after the one before), the time
from a look to its answer as the page sees it, and what the server says that it took. With --busy a study runs beside it on all cores. Needs
Chromium; nothing is asserted.
"""

import math
import pathlib
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tests/browser"))
import test_studio  # noqa: E402
from chromium import Chromium  # noqa: E402

DRAG_S = 5.0
ZOOM_S = 5.0
LATE_MS = 25
FOUR_BARS = 10
# Notes the time of each frame, and of each look and its answer.
NOTE = """(() => {
    window.frames_ms = [];
    window.answers_ms = [];
    let last = performance.now();
    const frame = (now) => { window.frames_ms.push(now - last); last = now; requestAnimationFrame(frame); };
    requestAnimationFrame(frame);
    if (window.isNoted) return;
    window.isNoted = true;
    const sent = new Map(), send = WebSocket.prototype.send, heard = new WeakSet();
    WebSocket.prototype.send = function (text) {
        const message = JSON.parse(text);
        if (message.kind === 'look') sent.set(message.seq, performance.now());
        if (!heard.has(this)) {
            heard.add(this);
            this.addEventListener('message', ({ data }) => {
                const answer = JSON.parse(data);
                if (answer.kind === 'look_answer' && sent.has(answer.seq)) window.answers_ms.push([performance.now() - sent.get(answer.seq), answer.cost_ms]);
            });
        }
        return send.call(this, text);
    };
})()"""


def chain(folder):
    """Ten four-bars in a row: each rocker is the crank of the next, which is a parallelogram; three pins have play."""
    folder.mkdir()
    bodies, joints, guesses, before = [], [], [], "crank.b"
    body = ('[body.{0}]\nmass = "0.3 kg"\ninertia = "1e-3 kg m^2"\ncentre_of_mass = ["{1} / 2", "0 mm"]\n'
            'points = {{ a = ["0 mm", "0 mm"], b = ["{1}", "0 mm"] }}\n')
    joint = '[joint.{}]\nkind = "revolute"\nbearing = "{}"\njournal = "{}"\n'
    play = 'bearing_radius = "8 mm"\nradial_clearance = "0.1 mm"\ncontact = "steel"\n'
    bodies.append(body.format("crank", "crank_length"))
    joints.append(joint.format("pivot", "ground.g0", "crank.a"))
    for number in range(1, FOUR_BARS + 1):
        bodies.append(body.format(f"coupler{number}", "coupler_length" if number == 1 else "base_length"))
        bodies.append(body.format(f"rocker{number}", "rocker_length"))
        joints.append(joint.format(f"pin{number}", before, f"coupler{number}.a") + (play if number in (2, 5, 8) else ""))
        joints.append(joint.format(f"top{number}", f"coupler{number}.b", f"rocker{number}.b"))
        joints.append(joint.format(f"foot{number}", f"ground.g{number}", f"rocker{number}.a"))
        guesses.append(f'coupler{number} = "{20 if number == 1 else 0} deg", rocker{number} = "94 deg"')
        before = f"rocker{number}.b"
    ground = "".join(f'g{number} = ["{number} * base_length", "0 mm"]\n' for number in range(FOUR_BARS + 1))
    (folder / "model.toml").write_text(
        'name = "chain of ten four-bars"\ngravity = "9.81 m/s^2"\n[parameter]\ncrank_length = "80 mm"\ncoupler_length = "260 mm"\n'
        f'rocker_length = "180 mm"\nbase_length = "300 mm"\n[body.ground.points]\n{ground}{"".join(bodies)}'
        '[contact.steel]\nlaw = "lankarani-nikravesh"\nrestitution = 0.85\nyoungs_modulus = "207 GPa"\npoisson_ratio = 0.3\n'
        f'{"".join(joints)}[drive.crank]\njoint = "pivot"\nspeed = "60 rpm"\nstart_angle = "34 deg"\n'
        f'[assembly]\nguess = {{ {", ".join(guesses)} }}\n[cycle]\ndrive = "crank"\ntransient_turns = 0\nrecorded_turns = 1\n'
        f'samples_per_turn = 180\n[output.last]\nangle_of = "rocker{FOUR_BARS}"\n')
    (folder / "study.toml").write_text(
        'name = "chain of ten four-bars"\nmodel = "model.toml"\nseed = 1\n[sampling]\nouter = 4\ninner = 32\n[random]\n'
        '"parameter.coupler_length" = { tolerance = "260 ± 0.1 mm" }\n[[ask]]\noutput = "last"\nof = "total"\nat = "cycle"\n'
        'statistics = ["mean"]\n')


def share(values, part):
    return sorted(values)[min(int(part * len(values)), len(values) - 1)]


def drag(studio, pin):
    """Drags a pin around for some seconds; gives the times of frames and answers."""
    browser = studio.browser
    browser.evaluate(NOTE)
    x, y = studio.pin(pin)

    def mouse(kind, right, down, **more):
        browser.call("Input.dispatchMouseEvent", type=kind, x=x + right, y=y + down, button="left", **more)

    mouse("mousePressed", 0, 0, clickCount=1)
    browser.evaluate("(window.frames_ms.length = 0, window.answers_ms.length = 0, true)")
    began, step = time.monotonic(), 0
    while time.monotonic() - began < DRAG_S:
        step += 1
        mouse("mouseMoved", 12 * math.sin(0.08 * step) + 3, -8 * math.sin(0.056 * step), buttons=1)
        time.sleep(0.012)
    times = browser.evaluate("[window.frames_ms, window.answers_ms]")
    mouse("mouseReleased", 0, 0, clickCount=1)
    studio.settle()
    times.append(zoom(browser, x, y))
    # An unsaved text would hold the page.
    studio.click("button", "Undo")
    studio.wait_until_saved()
    return times


def zoom(browser, x, y):
    """Zooms in and out about a place for some seconds, while the mechanism turns; gives the times of frames."""
    browser.call("Input.dispatchKeyEvent", type="keyDown", key=" ")
    browser.call("Input.dispatchKeyEvent", type="keyUp", key=" ")
    browser.evaluate("(window.frames_ms.length = 0, true)")
    began, step = time.monotonic(), 0
    while time.monotonic() - began < ZOOM_S:
        step += 1
        browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-60 * math.sin(0.05 * step))
        time.sleep(0.012)
    frames = browser.evaluate("window.frames_ms")
    for kind in ("keyDown", "keyUp"):
        browser.call("Input.dispatchKeyEvent", type=kind, key=" ")
    browser.call("Input.dispatchKeyEvent", type="keyDown", key="0")
    return frames


def main(program, is_busy):
    test_studio.PROGRAM = program
    with tempfile.TemporaryDirectory() as desk, Chromium() as browser:
        desk = pathlib.Path(desk)
        served = desk / "mechanisms"
        served.mkdir()
        for template in ("four-bar", "watt-six-bar"):
            subprocess.run([program, "new", template, served / template], check=True, capture_output=True)
        chain(served / "chain")
        subprocess.run([program, "new", "toggle-press", desk / "press"], check=True, capture_output=True)
        browser.view(1280, reduced_motion=True)
        studio = test_studio.Studio(served, browser)
        try:
            for folder, pin in (("four-bar", "crank_pin"), ("watt-six-bar", "crank_pin"), ("chain", "pin1")):
                studio.open()
                studio.click(".shelf .open", f"{folder}/study.toml")
                studio.wait("document.querySelector('.drawing .grip')")
                studio.settle()
                beside = None
                if is_busy:
                    command = [program, "study", desk / "press/study.toml", "--out", desk / f"out-{folder}"]
                    beside = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    time.sleep(1)
                frames, answers, zoomed = drag(studio, pin)
                if beside:
                    beside.kill()
                    beside.wait()
                late, late_zoomed = (sum(time_ms > LATE_MS for time_ms in times) for times in (frames, zoomed))
                page, server = [answer[0] for answer in answers], [answer[1] for answer in answers]
                print(f"{folder:13} {'beside a study' if is_busy else 'idle':14} {late:3} of {len(frames)} frames late ({100 * late / len(frames):.1f} %), zoomed {late_zoomed} of {len(zoomed)} "
                      f"({100 * late_zoomed / len(zoomed):.1f} %), "
                      f"{len(answers)} answers, from look to answer {share(page, 0.5):.0f} ms (95 %: {share(page, 0.95):.0f}), "
                      f"server {share(server, 0.5):.0f} ms (95 %: {share(server, 0.95):.0f})")
            studio.open()
            paint = browser.evaluate("performance.getEntriesByName('first-contentful-paint')[0].startTime")
            print(f"first paint after {paint:.0f} ms")
        finally:
            studio.close()


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), "--busy" in sys.argv[2:])
