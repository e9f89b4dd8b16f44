"""The wheel installs, imports and says which version it is."""

import importlib.metadata

import loosepin


def test_version_is_that_of_the_installed_wheel():
    assert loosepin.__version__ == importlib.metadata.version("loosepin")


def test_module_says_what_it_is_for():
    assert loosepin.__doc__ == "How accurately a planar mechanism moves when its parts scatter and its joints have play."
