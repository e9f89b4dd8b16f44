# Every command of a developer. `./test` installs the tools and calls `everything`; CI calls `./test`.

set shell := ["bash", "-euo", "pipefail", "-c"]

# The Python with numpy, pyarrow and pytest that ./test prepares.
python := justfile_directory() / ".venv/bin/python"

# The list of recipes.
default:
    @just --list --unsorted

# Before every push: format, lint, docs, architecture, unit tests; under two minutes on a warm build.
check: format-check lint docs architecture unit

# Everything that CI runs, on a bare machine: installs what is missing first.
test:
    ./test

# The steps of ./test, once the tools are there: all of them, also where one fails; at the end the failed steps and tests are named.
everything:
    "{{ python }}" tools/steps/steps.py "{{ just_executable() }}" format-check lint docs page-scripts-check studio-front-check \
        rust-tests python-tests browser-tests

# Rewrites the sources in the house format.
format:
    cargo fmt --all

# The sources are in the house format.
format-check:
    cargo fmt --all --check

# Clippy over every target; warnings are errors.
lint:
    cargo clippy --workspace --all-targets --locked -- -D warnings

# The documentation builds; a broken link or a missing page is an error.
docs: site
    RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --locked

# Rewrites the tables of keys, units and contact laws in docs; a test fails where they are stale.
file-pages:
    LOOSEPIN_REWRITE_PAGES=1 cargo test --locked --package loosepin --test documents tables_of_the_pages

# Solves the films that rupture and writes their table, in a few minutes; a test compares it with the solution at other places.
film-table:
    cargo test --release --locked --package loosepin-mechanics --lib -- --ignored --nocapture write_the_table

# Builds the scripts of the report pages from TypeScript; the built files are checked in.
page-scripts: (npm "crates/loosepin-report/scripts" "build")

# The built scripts of the report pages are those of their sources, byte for byte.
page-scripts-check:
    #!/usr/bin/env bash
    set -euo pipefail
    kept=$(mktemp -d)
    trap 'rm -rf "$kept"' EXIT
    # One whose source is gone must not stay.
    mv crates/loosepin-report/assets/*.js "$kept"
    just page-scripts
    test "$(ls crates/loosepin-report/assets/*.js | wc -l)" = "$(ls "$kept" | wc -l)" || {
        echo "error: crates/loosepin-report/assets holds other scripts than its sources give; look at git status" >&2
        exit 1
    }
    for built in crates/loosepin-report/assets/*.js; do
        cmp "$built" "$kept/$(basename "$built")" || {
            echo "error: $built is not what its source gives; it is built now: look at it, and commit it" >&2
            exit 1
        }
    done

# Writes the types of the studio's messages in TypeScript from the Rust types; a test compares them.
studio-messages:
    LOOSEPIN_REWRITE_PAGES=1 cargo test --locked --package architecture --test messages

# Builds the front end of the studio from TypeScript and Svelte; the built files are checked in.
studio-front: (npm "crates/loosepin-studio/front" "check" "build")

# The front end of the studio has no fault of types or access, and its built files are those of its sources, byte for byte.
studio-front-check:
    #!/usr/bin/env bash
    set -euo pipefail
    kept=$(mktemp -d)
    trap 'rm -rf "$kept"' EXIT
    cp -r crates/loosepin-studio/assets/. "$kept"
    just studio-front
    diff --recursive --brief crates/loosepin-studio/assets "$kept" || {
        echo "error: crates/loosepin-studio/assets is not what its sources give; it is built now: look at it, and commit it" >&2
        exit 1
    }

# How smoothly the studio follows the mouse, alone and beside a study (measured/performance.md).
studio-bench:
    cargo build --release --locked --package loosepin-cli
    "{{ python }}" tools/studio/frames.py target/release/loosepin
    "{{ python }}" tools/studio/frames.py target/release/loosepin --busy

# The documentation as a site with search: target/site/book/index.html.
site:
    "{{ python }}" tools/site/site.py

# Builds program, archive, wheel and Debian package of a release, and tries them in clean roots (docs/release.md).
release *ARGUMENTS:
    python3 tools/release/release.py {{ ARGUMENTS }}

# Who imports whom, file sizes, dependencies named: the rules of docs/architecture.md.
architecture:
    cargo test --locked --package architecture

# Unit tests of all crates.
unit:
    cargo test --locked --workspace --lib --exclude loosepin-python

# Unit, integration and documentation tests of all crates.
rust-tests:
    #!/usr/bin/env bash
    set -uo pipefail
    status=0
    # Examples are compiled by the linter; linking them takes longer than what it could find. A crate that fails hides no other one.
    "{{ python }}" tools/steps/rust_tests.py --workspace --locked --tests || status=$?
    cargo test --workspace --locked --doc --no-fail-fast || status=$?
    exit "$status"

# Installs the package into .venv, with the module of the same build as the other tests, and runs the Python tests.
python-tests: (tool "pytest") programs
    "{{ python }}" tools/python/install.py target/debug
    "{{ python }}" -m pytest --quiet --numprocesses auto --dist loadfile crates/loosepin-python/tests tools/steps

# Loads the pages that people see in headless Chromium (its path in CHROMIUM), with axe-core, which comes with the scripts.
browser-tests: (tool "pytest") page-scripts programs
    #!/usr/bin/env bash
    set -euo pipefail
    "{{ python }}" tools/python/install.py target/debug
    if [ ! -d tests/browser ]; then
        echo "there is no tests/browser" >&2
        exit 0
    fi
    "{{ python }}" -m pytest --quiet --numprocesses auto --dist loadfile tests/browser

# A long run, quoted in docs and not part of CI: fuzzing, kills, mutants, seeded repetitions, comparisons.
campaign NAME *ARGUMENTS:
    #!/usr/bin/env bash
    set -euo pipefail
    if [ ! -x "tests/campaigns/{{ NAME }}" ]; then
        echo "error: there is no campaign '{{ NAME }}'" >&2
        echo "hint: the campaigns are: $(ls tests/campaigns | tr '\n' ' ')" >&2
        exit 2
    fi
    exec "tests/campaigns/{{ NAME }}" {{ ARGUMENTS }}

# Lines of code, what plane and space have twice, and where variants of enums are named, at a commit.
structure REVISION="HEAD":
    python3 tools/structure/structure.py {{ REVISION }}

# Seconds from one changed line in each crate to a passing unit test of it, and to the program.
rebuild-times *CRATES:
    python3 tools/rebuild/rebuild_times.py {{ CRATES }}

# Simulations per second, right-hand sides per revolution, nanoseconds each.
bench *ARGUMENTS:
    cargo bench --locked --package loosepin-bench {{ ARGUMENTS }}

# Times the reference case in other simulators against ours; tools/compare/README.md says how.
compare *ARGUMENTS:
    python3 tools/compare/compare.py {{ ARGUMENTS }}

# Holds bounds by uncertainty packages, and ours, against exact ones; tools/compare/bounds/README.md says how.
compare-bounds *ARGUMENTS:
    python3 tools/compare/bounds.py {{ ARGUMENTS }}

# Holds `loosepin identify` against approximate Bayesian computation; tools/compare/identify/README.md says how.
compare-identify *ARGUMENTS:
    python3 tools/compare/identify.py {{ ARGUMENTS }}

# Holds what surrogates predict, ours and those of other packages, against the same points; tools/compare/surrogates/README.md says how.
compare-surrogates *ARGUMENTS:
    python3 tools/compare/surrogates.py {{ ARGUMENTS }}

# How soon the study of each template shows a first band, and what the whole study costs (measured/performance.md).
template-times *TEMPLATES:
    cargo build --release --locked --package loosepin-cli
    python3 tools/templates/times.py target/release/loosepin {{ TEMPLATES }}

# Where the processor time of the reference case goes, by perf; measured/performance.md says what follows.
profile *ARGUMENTS:
    python3 tools/profile/profile.py {{ ARGUMENTS }}

# The main job, on the reference case.
study:
    cargo run --release --locked -- study cases/slider_crank_worn_pin/study.toml

# The command, the module of the Python package and the example that writes pages. `--example` makes cargo choose the features of
# dependencies as `cargo test` does: nothing is compiled again.
[private]
programs:
    cargo build --locked --workspace --lib --bins --example report_pages

# Installs what a folder of TypeScript needs, and runs scripts of its package.json.
[private]
npm FOLDER +SCRIPTS:
    #!/usr/bin/env bash
    set -euo pipefail
    # ./test may have put npm into .venv.
    export PATH="$PATH:{{ justfile_directory() }}/.venv/bin"
    command -v npm >/dev/null || {
        echo "error: npm is not on the PATH" >&2
        echo "hint: install Node 20.19 or newer, or call ./test --install-only" >&2
        exit 2
    }
    cd "{{ FOLDER }}"
    npm ci --silent --no-audit --no-fund --ignore-scripts
    for script in {{ SCRIPTS }}; do npm run --silent "$script"; done

# A tool of .venv is there, or a message says how to get it.
[private]
tool NAME:
    #!/usr/bin/env bash
    if ! "{{ python }}" -c "import {{ NAME }}" 2>/dev/null; then
        echo "error: {{ NAME }} is not installed in .venv" >&2
        echo "hint: ./test --install-only" >&2
        exit 2
    fi
