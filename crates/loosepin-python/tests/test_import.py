"""The wheel installs, imports and says which version it is."""

import importlib.metadata
import subprocess
import sys

import loosepin


def test_version_is_that_of_the_installed_wheel():
    assert loosepin.__version__ == importlib.metadata.version("loosepin")


def test_module_says_what_it_is_for():
    first_line = (loosepin.__doc__ or "").splitlines()[0]
    assert first_line == "How accurately a mechanism moves when its parts scatter and its joints have play."


def test_everything_public_is_there_and_documented():
    for name in loosepin.__all__:
        assert name == "__version__" or getattr(loosepin, name).__doc__, name


def test_import_needs_nothing_but_numpy():
    heavy = ("pandas", "xarray", "matplotlib", "IPython")
    code = f"import sys, loosepin; print([name for name in {heavy!r} if name in sys.modules])"
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert printed == "[]\n"
