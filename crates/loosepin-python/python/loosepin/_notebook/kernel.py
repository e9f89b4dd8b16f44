"""Whether a notebook runs this code."""

from __future__ import annotations

import sys
from typing import Any


def has_kernel() -> bool:
    """Whether the code runs in the kernel of a notebook: there, what is shown can change later."""
    ipython = sys.modules.get("IPython")
    shell: Any = ipython.get_ipython() if ipython is not None else None
    return shell is not None and hasattr(shell, "kernel")
