"""`njit` whose cache belongs to the present text of this folder.

numba notices a change of the file of a function, not of the functions that it calls from other files: with the cache
beside the sources, an edit of `mechanics.py` would leave the old equations inside a cached `integrate`.
"""

import hashlib
import tempfile
from functools import partial
from pathlib import Path

import numba

_texts = b"".join(path.read_bytes() for path in sorted(Path(__file__).parent.glob("*.py")))
numba.config.CACHE_DIR = str(Path(tempfile.gettempdir()) / f"oracle-{hashlib.sha256(_texts).hexdigest()[:12]}")

njit = partial(numba.njit, cache=True)
