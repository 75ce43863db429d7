"""Plans for a small program, rendered into folders of the test's own."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from domeshim.render.plan import Plan, Reel
from tests.render.programs import CLEARS, SPINNER

MakePlan = Callable[..., Plan]
ROOT = Path(__file__).resolve().parent.parent.parent


class Silent:
    """No progress is shown; what was told is kept."""

    def __init__(self):
        self.done = 0
        self.count = 0

    def begun(self, total, done):
        self.done = done

    def made(self, count=1):
        self.count += count

    def passing(self, frame):
        pass

    def ended(self):
        pass


@pytest.fixture
def progress():
    return Silent()


@pytest.fixture
def make_plan(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> MakePlan:
    """A plan by first and last picture, its folder's name, and what the program does besides."""
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    monkeypatch.delenv("PYOPENGL_PLATFORM")
    monkeypatch.setenv("DASK_LOGGING__DISTRIBUTED", "critical")

    def plan(
        first: int,
        last: int,
        folder: str = "show",
        does: str = CLEARS,
        args: tuple[str, ...] = (),
        **other: object,
    ) -> Plan:
        program = tmp_path / "spinner.py"
        program.write_text(SPINNER.replace("{}", does))
        reel = Reel(str(program), args, settings={"hud": "off"}, side=64)
        made = Plan(reel, first, last, 64, tmp_path / folder, "spinner")
        return Plan(**{**vars(made), **other})  # type: ignore[arg-type]

    yield plan
    os.environ.setdefault("PYOPENGL_PLATFORM", "egl")


def contents(plan: Plan) -> dict[str, bytes]:
    """A folder's pictures by name."""
    return {path.name: path.read_bytes() for path in sorted(plan.output.glob("*.png"))}
