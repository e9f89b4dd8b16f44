"""The steps of `./test` run to the last one, and what failed is named at the end."""

import os
import re
import subprocess
import sys
from pathlib import Path

STEPS = Path(__file__).with_name("steps.py")

# What cargo and pytest print, from runs in which a test was made to fail.
JUST = r"""#!/bin/sh
case "$1" in
lint) echo "error: could not compile \`loosepin-text\` (lib) due to 1 previous error" >&2; exit 101 ;;
rust-tests) cat <<'END'
     Running unittests src/lib.rs (target/debug/deps/loosepin_text-0123456789abcdef)
test units::tests::a_unit ... ok
test units::tests::another_unit ... FAILED
test crates/loosepin-text/src/diagnostics/problems.rs - diagnostics::problems::problems (line 5) ... FAILED
test slow_test ... ignored
test result: FAILED. 1 passed; 2 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.01s
error: 2 targets failed:
    `-p loosepin-text --lib`
    `-p loosepin-cli --test command`
END
exit 101 ;;
python-tests) cat <<'END'
FAILED crates/loosepin-python/tests/test_pages.py::test_page[docs/python.md] - AssertionError: 1 != 2
ERROR crates/loosepin-python/tests/test_study.py
END
exit 1 ;;
browser-tests) echo "error: pytest is not installed in .venv"; exit 2 ;;
*) echo "$1 is well" ;;
esac
"""


def steps(tmp_path, *names):
    just = tmp_path / "just"
    just.write_text(JUST)
    just.chmod(0o755)
    done = subprocess.run([sys.executable, STEPS, just, *names], capture_output=True, text=True)
    return done.returncode, re.sub(r": \d+ s", ": N s", done.stdout).splitlines()


def test_a_step_that_fails_hides_none_that_comes_after_it(tmp_path):
    status, printed = steps(tmp_path, "format-check", "lint", "docs", "rust-tests", "python-tests", "browser-tests")
    assert status == 101
    assert "format-check is well" in printed and "docs is well" in printed and "==> docs: N s" in printed
    assert "==> rust-tests: N s, failed" in printed
    assert printed[printed.index("error: lint failed with status 101:") :] == [
        "error: lint failed with status 101:",
        "  could not compile `loosepin-text`",
        "error: rust-tests failed with status 101:",
        "  units::tests::another_unit",
        "  crates/loosepin-text/src/diagnostics/problems.rs - diagnostics::problems::problems (line 5)",
        "  -p loosepin-text --lib",
        "  -p loosepin-cli --test command",
        "error: python-tests failed with status 1:",
        "  crates/loosepin-python/tests/test_pages.py::test_page[docs/python.md]",
        "  crates/loosepin-python/tests/test_study.py",
        "error: browser-tests failed with status 2",
    ]


def test_steps_that_are_well_say_nothing_at_the_end(tmp_path):
    status, printed = steps(tmp_path, "format-check", "docs")
    assert status == 0
    assert printed == ["format-check is well", "==> format-check: N s", "docs is well", "==> docs: N s"]


# What cargo says of a program of tests, of a library, and of its end.
MESSAGES = """
{"reason":"compiler-artifact","manifest_path":"FOLDER/loosepin-cli/Cargo.toml","target":{"kind":["test"],"name":"command"},"profile":{"test":true},"executable":"FOLDER/fails"}
{"reason":"compiler-artifact","manifest_path":"FOLDER/loosepin-text/Cargo.toml","target":{"kind":["lib"],"name":"loosepin_text"},"profile":{"test":true},"executable":"FOLDER/passes"}
{"reason":"compiler-artifact","manifest_path":"FOLDER/loosepin-text/Cargo.toml","target":{"kind":["lib"],"name":"loosepin_text"},"profile":{"test":false},"executable":null}
{"reason":"build-finished","success":true}
"""


def rust_tests(tmp_path, cargo):
    for package in ("loosepin-cli", "loosepin-text"):
        (tmp_path / package).mkdir()
    for name, text in {
        "cargo": cargo,
        "fails": "echo 'test a_test ... FAILED'; pwd; exit 101",
        "passes": "echo 'test another_test ... ok'; pwd",
    }.items():
        (tmp_path / name).write_text(f"#!/bin/sh\n{text}\n")
        (tmp_path / name).chmod(0o755)
    environment = os.environ | {"PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    return subprocess.run([sys.executable, STEPS.with_name("rust_tests.py"), "--tests"], env=environment, capture_output=True, text=True)


def test_programs_of_tests_run_to_the_last_and_those_that_fail_are_named(tmp_path):
    (tmp_path / "messages").write_text(MESSAGES.strip().replace("FOLDER", str(tmp_path)))
    done = rust_tests(tmp_path, f"echo \"$@\" >&2; cat {tmp_path}/messages")
    assert done.stderr == "test --no-run --message-format=json-render-diagnostics --tests\n"
    for shown in (
        f"     Running -p loosepin-cli --test command\ntest a_test ... FAILED\n{tmp_path}/loosepin-cli\n",
        f"     Running -p loosepin-text --lib\ntest another_test ... ok\n{tmp_path}/loosepin-text\n",
    ):
        assert shown in done.stdout
    assert done.stdout.endswith("error: 1 targets failed:\n    `-p loosepin-cli --test command`\n")
    assert done.returncode == 101


def test_no_tests_are_an_error(tmp_path):
    done = rust_tests(tmp_path, "echo '{\"reason\":\"build-finished\",\"success\":true}'")
    assert (done.returncode, done.stdout) == (1, "error: cargo has built no tests\n")


def test_what_cannot_be_built_is_the_status_of_cargo(tmp_path):
    done = rust_tests(tmp_path, "echo 'error: could not compile `loosepin-text`' >&2; exit 102")
    assert (done.returncode, done.stdout) == (102, "")
