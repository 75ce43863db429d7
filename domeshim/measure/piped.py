"""A process of our own that hears orders and answers them, by a pipe each."""

from __future__ import annotations

import os
import subprocess
import sys
from contextlib import suppress
from typing import IO, Any


class Piped:
    """`python -m MODULE ORDERS REPLIES ARGUMENTS`, where the first two are the numbers of its open pipes."""

    def __init__(self, module: str, *arguments: str, **how: Any) -> None:
        """how: further arguments of subprocess.Popen."""
        orders_out, orders_in = os.pipe()
        replies_out, replies_in = os.pipe()
        pipes = (str(orders_out), str(replies_in))
        try:
            self._process = subprocess.Popen(
                [sys.executable, "-m", module, *pipes, *arguments],
                pass_fds=(orders_out, replies_in),
                stdin=subprocess.DEVNULL,
                **how,
            )
        finally:
            os.close(orders_out)
            os.close(replies_in)
        self.orders: IO[bytes] = os.fdopen(orders_in, "wb")
        self.replies: IO[bytes] = os.fdopen(replies_out, "rb")

    def wait(self) -> int:
        """Its exit status, once it has ended by itself."""
        return self._process.wait()

    def kill(self) -> None:
        """End it; what is read from it from now on is its end."""
        self._process.kill()
        self._process.wait()

    def close(self) -> None:
        """End it."""
        for stream in (self.orders, self.replies):
            with suppress(OSError):
                stream.close()
        if self._process.poll() is None:
            self._process.terminate()
        self._process.wait()
