"""Pictures made by many workers: Dask hands out chunks of them, on this machine or on a cluster."""

from __future__ import annotations

import logging
import os
import random
import signal
import threading
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from dataclasses import replace
from itertools import zip_longest
from multiprocessing import resource_tracker
from pathlib import Path
from typing import NamedTuple
from uuid import uuid4

from dask.system import CPU_COUNT
from distributed import Client, Future, LocalCluster, Worker, WorkerPlugin, as_completed, get_worker

from domeshim.errors import DomeError
from domeshim.render.files import write
from domeshim.render.maker import Made, Maker
from domeshim.render.plan import Plan
from domeshim.render.show import Progress

_COMPARED = 2
"""So many pictures are made twice."""
_TOKEN = ".domeshim-"
"""Begins the name of a file by which workers find out whether they see the output's folder."""
_RASTER_THREADS = "LP_NUM_THREADS"
"""So many Mesa's llvmpipe takes in each process; it would take one a core."""


class Keeper(WorkerPlugin):  # type: ignore[misc] # Dask's types are not looked at
    """A worker's part: it keeps the plan's program alive between chunks, one in each of its threads."""

    def __init__(self, plan: Plan, token: Path, *, ours: bool = False) -> None:
        """token: a file in the output's folder; who sees it shares the storage, and writes there itself.

        ours: the worker ends with the client.
        """
        self.name = f"domeshim-{token.name}"
        self._plan = plan
        self._token = token
        self._ours = ours
        self._makers: dict[int, Maker] = {}
        """By the thread's number."""

    def setup(self, worker: Worker) -> None:
        """The worker hears of the plan."""
        os.environ.setdefault(_RASTER_THREADS, _share(worker.state.nthreads))
        if self._ours:  # it would complain that the client has gone; that memory is short is worth hearing
            _silence()
            logging.getLogger("distributed.worker.memory").setLevel(logging.WARNING)

    def teardown(self, worker: Worker) -> None:  # noqa: ARG002 - Dask's own signature
        """The worker ends."""
        for maker in list(self._makers.values()):
            maker.give_up()

    def make(self, frames: tuple[int, ...], also: int | None) -> list[Made]:
        """Make these pictures; their files' contents come with them where the storage is not shared.

        also: one more, that another worker makes as well.
        """
        maker = self._makers.setdefault(threading.get_ident(), Maker(self._plan))
        shared = self._token.exists()
        found = []
        for made in maker.make(frames if also is None else (*frames, also)):
            if made.frame == also:
                found.append(replace(made, content=b"", again=True))
            else:
                found.append(self._written(made) if shared else made)
        return found

    def _written(self, made: Made) -> Made:
        if made.content:
            write(self._plan.path(made.frame, made.eye), made.content)
        return replace(made, content=b"")


class Chunk(NamedTuple):
    """What a worker makes at a time."""

    frames: tuple[int, ...]
    also: int | None = None
    """The next chunk's first picture, where it is to be compared with what another program makes of it."""


def make_chunk(name: str, chunk: Chunk) -> list[Made]:
    """A task: make these pictures on the worker where it runs; name: of the plugin there."""
    keeper = get_worker().plugins.get(name)
    return keeper.make(*chunk) if isinstance(keeper, Keeper) else []  # nobody waits for it any more


class Farm:
    """Many workers: so many local processes, or those of a running scheduler.

    Each worker passes by, undrawn, the pictures that others make. A lost worker's chunk is done elsewhere.
    """

    def __init__(
        self,
        workers: int,
        cluster: str | None = None,
        chunk: int = 24,
        seed: int | None = None,
        patience: float = 10.0,
    ) -> None:
        """seed: hands out the chunks in an order of its own; patience: seconds for a scheduler to answer."""
        self._workers = workers
        self._cluster = cluster
        self._chunk = chunk
        self._seed = seed
        self._patience = patience

    def make(self, plan: Plan, frames: list[int], progress: Progress) -> Iterator[Made]:  # noqa: ARG002 - the crew's
        """Make these pictures; a chunk's come together, when the last of them is made.

        The first ones of two chunks are made twice: by the program that makes the chunk before as well.
        Raises DomeError where there is no scheduler.
        """
        chunks = self._chunks(frames)
        if self._seed is not None:
            random.Random(self._seed).shuffle(chunks)
        with ExitStack() as stack:
            stack.callback(_hear_interrupts)
            _put_off_interrupts()
            for left in plan.output.glob(f"{_TOKEN}*"):  # by a client that was killed
                left.unlink(missing_ok=True)
            token = plan.output / f"{_TOKEN}{uuid4().hex}"
            write(token, b"")
            stack.callback(token.unlink, missing_ok=True)
            client = self._client(stack)
            keeper = Keeper(plan, token, ours=self._cluster is None)
            client.register_plugin(keeper)
            stack.callback(_forget, client, keeper.name)
            stack.callback(_put_off_interrupts)  # once was enough
            # That nobody is left to hear of the other tasks is critical to Dask, and to nobody else.
            stack.callback(_silence)
            futures = {
                client.submit(make_chunk, keeper.name, chunk, pure=False, priority=-number): chunk
                for number, chunk in enumerate(chunks)
            }
            _hear_interrupts()
            yield from _collect(futures, plan)

    def _chunks(self, frames: list[int]) -> list[Chunk]:
        rows = [tuple(frames[i : i + self._chunk]) for i in range(0, len(frames), self._chunk)]
        firsts = [row[0] for row in rows[1 : 1 + _COMPARED]]
        return [Chunk(*found) for found in zip_longest(rows, firsts)]

    def _client(self, stack: ExitStack) -> Client:
        if self._cluster is None:
            cluster = LocalCluster(
                n_workers=self._workers,
                threads_per_worker=1,
                dashboard_address=":0",
                env=shared_cores(self._workers),
            )
            return stack.enter_context(Client(stack.enter_context(cluster)))
        try:
            return stack.enter_context(Client(self._cluster, timeout=self._patience))
        except (OSError, ValueError) as error:
            raise DomeError(f"--cluster={self._cluster}: no scheduler answers there ({error})") from None


def _put_off_interrupts() -> None:
    """This thread hears of Ctrl+C later; threads and processes that begin meanwhile never do, nor need to."""
    resource_tracker.ensure_running()  # which would begin with the first process, and let Ctrl+C in
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})


def _hear_interrupts() -> None:
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def shared_cores(workers: int) -> dict[str, str]:
    """What each of so many workers on this machine finds in its environment."""
    return {} if _RASTER_THREADS in os.environ else {_RASTER_THREADS: _share(workers)}


def _silence() -> None:
    """Let Dask say nothing more in this process."""
    logging.getLogger("distributed").setLevel(logging.CRITICAL + 1)


def _share(programs: int) -> str:
    """How many cores each of so many programs on this machine has."""
    return str(max(CPU_COUNT // programs, 1))


def _collect(futures: dict[Future, Chunk], plan: Plan) -> Iterator[Made]:
    for future in as_completed(futures):
        _put_off_interrupts()  # Dask's own waiting for an answer cannot be interrupted cleanly
        try:
            done = future.result()
        except Exception as error:  # whatever became of the worker
            reason = f"lost with its worker: {error}"
            done = [Made(frame, eye, error=reason) for frame in futures[future].frames for eye in plan.eyes]
        future.release()
        _hear_interrupts()
        yield from done


def _forget(client: Client, name: str) -> None:
    with suppress(Exception):  # the scheduler may have gone
        client.unregister_worker_plugin(name)
