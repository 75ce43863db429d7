"""The user's settings become one frozen Options. The only reader of their variables.

A setting is looked for in a command's own options, then in the DOME* variables, then in the file DOME_CONFIG,
then in what DOME_PRESET stands for.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from domeshim.errors import OptionError
from domeshim.lens import catalogue, surfaces
from domeshim.lens.catalogue import LensName
from domeshim.lens.surfaces import DOME, SurfaceName
from domeshim.settings import PRESETS, SETTINGS, VARIABLES, Place, Said, Stereo, malformed

_FIELDS = {field for field in SETTINGS if field not in ("preset", "config")}
"""The settings that are fields of Options; the others stand for some of them."""


@dataclass(frozen=True)
class Options:
    """What the user set, checked. Angles in degrees, sizes in pixels."""

    enabled: bool = False
    fov: float = 180.0
    tilt: float = 0.0
    heading: float = 0.0
    roll: float = 0.0
    seat: Place | None = None
    """Where the viewer is, from the dome's centre: to the disc's right, to its top, to the dome's pole."""
    projector: Place | None = None
    radius: float = 1.0
    """The dome's, in the unit of seat and projector."""
    lens: LensName = ("equidistant", ())
    method: str = "auto"
    tolerance: float = 0.5
    surface: SurfaceName = DOME
    hud: str = "panel"
    panel: float = 60.0
    fill: float | None = None
    stereo: Stereo = "off"
    eyes: float = 0.065
    frame: tuple[int, int] | None = None
    disc: tuple[float, float, float] | None = None
    """The disc's centre, from the frame's top left, and its radius."""
    mirror: str = "off"
    fade: float = 0.0
    """Over so many degrees the picture fades to black at the rim."""
    brightness: float = 1.0
    gamma: float = 1.0
    max_turn: float | None = None
    """The fastest that the view may turn on the dome, degrees a second; None: as fast as it does."""
    vsync: bool | None = None
    """None: as the program and the driver have it."""
    display: int | None = None
    keep_going: bool = False
    record: str | None = None
    """The film of what is seen, if there shall be one from the start."""
    preview: bool = False
    """A virtual dome opens beside the program."""
    debug: str = "off"
    """levels: draws are coloured by the pieces that their edges are subdivided into."""

    @property
    def flat_hud(self) -> bool:
        """The HUD is drawn undistorted, over the disc or beside it."""
        return self.hud in ("flat", "side")

    @property
    def finishes(self) -> bool:
        """The finished pictures are drawn once more: through a mesh, mirrored, or in another light."""
        plain = (self.mirror, self.fade, self.brightness, self.gamma) == ("off", 0.0, 1.0, 1.0)
        return self.surface[0] == "mesh" or not plain

    @property
    def cubemap(self) -> bool:
        """The method is cubemap."""
        return self.method.startswith("cubemap")

    @property
    def shows_levels(self) -> bool:
        """Draws are coloured by how finely they are subdivided."""
        return self.debug == "levels"

    @property
    def face_size(self) -> int | None:
        """Pixels across a face of the cube where the user says so."""
        size = self.method.partition(":")[2]
        return int(size) if size else None

    @classmethod
    def from_environment(
        cls, environ: Mapping[str, str] | None = None, given: Mapping[str, str] | None = None
    ) -> Options:
        """Read the DOME* variables; given holds a command's own options by field name, and wins over them.

        Raises OptionError for the first malformed one.
        """
        environ = os.environ if environ is None else environ
        _reject_misspelt(environ)
        said = _said_in(environ, given or {})
        values = {field: SETTINGS[field].read(text) for field, text in said.items() if field in _FIELDS}
        options = cls(**values)  # type: ignore[arg-type] # each setting's parser gives its field's type
        _check_lens(options, said.get("lens"))
        _check_places(options, said)
        _check_stereo(options, said)
        _check_surface(options, said)
        return options


def _said_in(environ: Mapping[str, str], given: Mapping[str, str]) -> dict[str, Said]:
    """What was said of each setting, the strongest word only."""
    said = {
        field: Said(variable, environ[variable])
        for field, variable in VARIABLES.items()
        if environ.get(variable, "").strip()
    }
    said |= {
        field: Said(f"--{field.replace('_', '-')}", text) for field, text in given.items() if text.strip()
    }
    if "config" in said:
        said = _in_file(said["config"]) | said
    if "preset" in said:
        preset = str(SETTINGS["preset"].read(said["preset"]))
        said = {field: Said(f"the preset's {field}", text) for field, text in PRESETS[preset].items()} | said
    return said


def _in_file(config: Said) -> dict[str, Said]:
    from domeshim.config import read_config  # noqa: PLC0415 - only where there is one

    path = config.folder / config.text.strip()
    names = {variable: field for field, variable in VARIABLES.items() if field not in ("enabled", "config")}
    found = read_config(path, config.name, names)
    return {field: Said(name, text, path.parent) for field, (name, text) in found.items() if text.strip()}


_HERE = ("enabled", "record", "preview")


def settings_in_environment() -> dict[str, str]:
    """The user's DOME_* variables as texts, by the field of Options; for a process without a screen."""
    found = {field: os.environ.get(variable, "") for field, variable in VARIABLES.items()}
    return {field: text for field, text in found.items() if text.strip() and field not in _HERE}


def _reject_misspelt(environ: Mapping[str, str]) -> None:
    """Raise OptionError for a DOME_* variable that is nearly, but not quite, one of ours."""
    known = set(VARIABLES.values())
    strangers = sorted(name for name in environ if name.startswith("DOME_") and name not in known)
    if not strangers:
        return
    from difflib import get_close_matches  # noqa: PLC0415 - hardly ever needed

    for name in strangers:
        # 0.86 tells DOME_FVO from DOME_FOV, and leaves alone what other software may call DOME_NAME.
        for meant in get_close_matches(name, known, n=1, cutoff=0.86):
            raise OptionError(f"{name}: no such variable; probably meant: {meant}")


def _check_lens(options: Options, said: Said | None) -> None:
    """Raise OptionError where there is no such lens of that field of view."""
    if options.lens == ("equidistant", ()):
        return
    from domeshim.lens.models import LensError, lens_of  # noqa: PLC0415 - numpy, which most starts do without

    try:
        lens_of(*options.lens, options.fov)
    except LensError as error:
        assert said is not None
        raise malformed(said.name, said.text, str(error), catalogue.ACCEPTED) from None


def _check_stereo(options: Options, said: Mapping[str, Said]) -> None:
    """Raise OptionError for two eyes on the faces of a cube, which are seen from one place each."""
    if options.cubemap and options.stereo != "off":
        method = said["method"]
        accepted = f"with {said['stereo'].name}={options.stereo} any other method"
        raise malformed(method.name, method.text, "its faces are seen by one eye", accepted)


def _check_surface(options: Options, said: Mapping[str, Said]) -> None:
    """Raise OptionError for what a surface or a finish cannot be had with."""
    kind = options.surface[0]
    shared = options.stereo in ("top-bottom", "left-right")
    if options.cubemap and kind in ("keystone", "cylinder"):
        raise _against_surface(said, f"method cubemap knows no {kind}; take another method, or a warp mesh")
    if shared and kind == "mesh":
        reason = f"one mesh for two discs, where DOME_STEREO is {options.stereo}; take left or right"
        raise _against_surface(said, reason)
    if shared and options.fade:
        fade = said["fade"]
        raise malformed(fade.name, fade.text, f"DOME_STEREO is {options.stereo}", "0 with two discs")
    if kind == "mesh":
        _check_mesh(Path(str(options.surface[1])), said["surface"])
    if kind == "cylinder":
        given = [said[field] for field in _OF_A_DOME if field in said]
        if options.method == "paper":
            given.append(said["method"])
        if given:
            raise _against_surface(said, f"{given[0].name} is for a dome, and this screen is none")


_OF_A_DOME = ("fov", "lens", "seat", "projector", "radius", "disc", "fade")
"""Settings that mean nothing on another screen."""


def _check_mesh(path: Path, said: Said) -> None:
    """Raise OptionError where the file is no warp mesh."""
    from domeshim.lens.mesh import MeshError, read_mesh  # noqa: PLC0415 - numpy, as for a lens

    try:
        read_mesh(path, aspect=1.0)
    except MeshError as error:
        raise OptionError(f"{said.name}: {error}") from None


def _against_surface(said: Mapping[str, Said], reason: str) -> OptionError:
    return malformed(said["surface"].name, said["surface"].text, reason, surfaces.ACCEPTED)


def _check_places(options: Options, said: Mapping[str, Said]) -> None:
    """Raise OptionError for a seat or a projector that is not within the dome."""
    for field, place in (("seat", options.seat), ("projector", options.projector)):
        if place is not None and math.hypot(*place) > NEAREST_TO_DOME * options.radius:
            reason = (
                f"{math.hypot(*place):.4g} from the dome's centre, where DOME_RADIUS is {options.radius:g}"
            )
            raise malformed(said[field].name, said[field].text, reason, SETTINGS[field].accepted)


NEAREST_TO_DOME = 0.95
"""A seat or projector may be off the dome's centre by so much of its radius."""
