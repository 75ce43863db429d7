"""The passes that make a picture of what the program draws: counted as they are made."""

from __future__ import annotations

from collections import Counter
from functools import wraps
from typing import TYPE_CHECKING, Any

from domeshim.draw.atlas import Atlas
from domeshim.draw.clear import PartClear
from domeshim.draw.finish import Finish
from domeshim.draw.resampling import Resampling
from domeshim.draw.rim import Rim
from domeshim.wording import counted

if TYPE_CHECKING:
    from domeshim.diagnosis.watch import WatchedDriver
    from domeshim.draw.canvas import Canvas
    from domeshim.options import Options

_RESOLVE, _OF_FACES = "multisample resolve", "multisample resolve of the faces"
_OVER_PICTURES: dict[str, tuple[type, str]] = {
    "part clear": (PartClear, "clear"),
    _OF_FACES: (Atlas, "resolve"),
    "resampling": (Resampling, "draw"),
    "rim": (Rim, "draw"),
    "finish": (Finish, "draw"),
}
"""Each pass over a whole picture, in their order, and what makes it."""
_FACES, _SAMPLES = 6, 0x80A9


class Passes:
    """Counts the passes of a picture beside the scene's own."""

    def __init__(self, driver: WatchedDriver) -> None:
        self._driver = driver
        self._made: Counter[str] = Counter()

    def begin_picture(self) -> None:
        """Count from the start."""
        self._made.clear()

    def watch(self) -> None:
        """Look on from now on, for as long as the process lasts."""
        for name, (maker, method) in _OVER_PICTURES.items():
            setattr(maker, method, self._counted(name, getattr(maker, method)))

    def seen(self, options: Options, canvas: Canvas) -> dict[str, Any]:
        """The passes of the picture, and those that nothing asked for; for JSON."""
        made = {name: self._made[name] for name in _OVER_PICTURES}
        made[_OF_FACES] = self._driver.blits[_OF_FACES]  # with one sample there is nothing to resolve
        made[_RESOLVE] = int(self._driver.integer(_SAMPLES) > 1)  # GL's own, as the window is shown
        scene = {"name": "scene", "times": len(canvas.views), "into": _into(options, canvas)}
        passes = [scene, *({"name": name, "times": times} for name, times in made.items() if times)]
        spared = [name for name, times in made.items() if not times]
        spared += ["second eye"] if options.stereo in ("off", "left", "right") else []
        unseen = _FACES - len(canvas.views) if canvas.kind == "face" else _FACES
        spared += [f"{counted(unseen, 'face')} of a cube"] if unseen else []
        return {"passes": passes, "spared": spared}

    def _counted(self, name: str, original: Any) -> Any:
        @wraps(original)
        def call(*args: Any, **named: Any) -> Any:
            self._made[name] += 1
            outer, self._driver.doing = self._driver.doing, name
            try:
                return original(*args, **named)
            finally:
                self._driver.doing = outer

        return call


def _into(options: Options, canvas: Canvas) -> str:
    """What the scene is drawn onto, in each of its passes."""
    if canvas.kind == "face":
        return f"{counted(len(canvas.views), 'face')} of a cube"
    screen = "screen" if options.surface[0] == "cylinder" else "disc"
    return f"the {screen}" if len(canvas.views) == 1 else f"a {screen} for each eye"
