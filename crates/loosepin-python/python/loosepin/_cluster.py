"""Runs of a study on the workers of a Dask cluster.

Dask schedules the tasks, moves what they need and give, and repeats those of a worker that is lost. A task makes a few runs from the
texts of the study and the numbers of their inputs, and gives their rows; everything else stays with the caller.
"""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _loosepin
from ._extras import need

Rows = tuple[NDArray[np.float64], NDArray[np.int32]]
"""A row for each run, and the number of the reason for its failure, -1 for none."""
Part = tuple[int, NDArray[np.float64], NDArray[np.int32]]
"""Index of the first run, then rows and reasons as in `Rows`."""
RunProvider = Callable[[list[tuple[int, float]], NDArray[np.float64], NDArray[np.float64]], Iterator[Part | None]]
"""Makes runs from the loosened numbers and the inputs of the runs, part by part; yields None while no part is finished."""

# Runs of a task: enough to keep the lanes of a processor busy, few enough that a lost worker costs little.
_LEAST_RUNS, _MOST_RUNS = 16, 128
# Tasks for each thread of the cluster, so that all are done at about the same time.
_TASKS_PER_THREAD = 4
# How often a task is tried again that has raised something; a lost worker is another matter, and Dask's.
_RETRIES = 2
# s; how often an interruption is looked for while nothing comes back.
_TICK_S = 0.1


def run_provider(client: Any, study: _loosepin.Study, accuracy: tuple[str, ...], budget: str | None) -> RunProvider:
    """Function that makes the runs of `study` on the cluster of `client`."""
    distributed = need("distributed", "client=...")
    if not isinstance(client, distributed.Client):
        raise TypeError(f"client is a {type(client).__name__}; must be a distributed.Client")
    if client.asynchronous:
        raise ValueError("client is asynchronous; must be a distributed.Client that waits for its answers")
    # Bytes, by which a worker knows that it has compiled this study before.
    stated = pickle.dumps((_loosepin.__version__, study.texts(), list(accuracy), budget))

    def make(
        loosened: list[tuple[int, float]], random: NDArray[np.float64], epistemic: NDArray[np.float64]
    ) -> Iterator[Part | None]:
        threads = max(1, sum(client.nthreads().values()))
        runs = min(max(-(-len(random) // (_TASKS_PER_THREAD * threads)), _LEAST_RUNS), _MOST_RUNS)
        waiting: dict[Any, int] = {}
        try:
            for first in range(0, len(random), runs):
                places = slice(first, first + runs)
                inputs = (loosened, random[places], epistemic[places])
                # Two tasks are never the same one, whatever their inputs: what one gives is let go as soon as it is here.
                future = client.submit(rows, stated, *inputs, pure=False, retries=_RETRIES)
                waiting[future] = first
            while waiting:
                try:
                    done = distributed.wait(list(waiting), timeout=_TICK_S, return_when="FIRST_COMPLETED").done
                except distributed.TimeoutError:
                    yield None
                    continue
                finished = list(done)
                for future, (made, reasons) in zip(finished, client.gather(finished)):
                    first = waiting.pop(future)
                    # Not when Python happens to collect it: what it holds is memory of a worker.
                    future.release()
                    yield first, _aligned(made), _aligned(reasons)
        finally:
            # Nothing is left where all came back; otherwise somebody has interrupted, or something was raised.
            client.cancel(list(waiting))
            for future in waiting:
                future.release()

    return make


def rows(stated: bytes, loosened: list[tuple[int, float]], random: NDArray[np.float64], epistemic: NDArray[np.float64]) -> Rows:
    """Task that makes these runs of the study pickled in `stated`."""
    return _compiled(stated).make(loosened, _aligned(random), _aligned(epistemic))


def _aligned(array: NDArray[Any]) -> NDArray[Any]:
    """The array where numbers begin at whole words: data from the network may start anywhere in a message."""
    return np.require(array, requirements=["C", "A"])


@lru_cache(maxsize=2)
def _compiled(stated: bytes) -> _loosepin.RunRows:
    """The study, compiled once in each process."""
    version, texts, accuracy, budget = pickle.loads(stated)
    if version != _loosepin.__version__:
        raise RuntimeError(
            f"a worker has loosepin {_loosepin.__version__}, the caller {version}: other versions may give other numbers"
        )
    return _loosepin.RunRows(texts, accuracy, budget)
