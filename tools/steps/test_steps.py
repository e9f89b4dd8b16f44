"""The steps of `./test` run to the last one, and what failed is named at the end."""

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
