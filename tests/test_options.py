from __future__ import annotations

import math
from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from domeshim.errors import OptionError
from domeshim.options import Options
from domeshim.settings import VARIABLES


def read(**variables: str) -> Options:
    return Options.from_environment(variables)


def test_nothing_set_gives_the_defaults():
    assert read() == Options()
    assert read(**dict.fromkeys(VARIABLES.values(), "  ")) == Options()


@pytest.mark.parametrize(
    ("variable", "text", "field", "value"),
    [
        ("DOME", "1", "enabled", True),
        ("DOME", " On ", "enabled", True),
        ("DOME", "0", "enabled", False),
        ("DOME_FOV", "360", "fov", 360.0),
        ("DOME_FOV", " 1e-3 ", "fov", 0.001),
        ("DOME_TILT", "-180", "tilt", -180.0),
        ("DOME_LENS", " Equidistant ", "lens", ("equidistant", ())),
        ("DOME_LENS", "polynomial: 0.7, -0.01", "lens", ("polynomial", (0.7, -0.01))),
        ("DOME_LENS", "POLYNOMIAL:1,0,0,0,1e-9", "lens", ("polynomial", (1.0, 0.0, 0.0, 0.0, 1e-9))),
        ("DOME_LENS", "OpenCV:-0.02,0.004", "lens", ("opencv", (-0.02, 0.004))),
        ("DOME_HEADING", "-90", "heading", -90.0),
        ("DOME_ROLL", "180", "roll", 180.0),
        ("DOME_SEAT", "0, -0.5, 0.1", "seat", (0.0, -0.5, 0.1)),
        ("DOME_PROJECTOR", "0.1,0,0", "projector", (0.1, 0.0, 0.0)),
        ("DOME_RADIUS", "7.5", "radius", 7.5),
        ("DOME_PRESET", "DomeMaster", "tilt", 90.0),
        ("DOME_METHOD", "Paper", "method", "paper"),
        ("DOME_HUD", "OFF", "hud", "off"),
        ("DOME_PANEL", "179.9", "panel", 179.9),
        ("DOME_FILL", "off", "fill", None),
        ("DOME_FILL", "170", "fill", 170.0),
        ("DOME_FRAME", " 2048 X 1536 ", "frame", (2048, 1536)),
        ("DOME_FRAME", "16384x1", "frame", (16384, 1)),
        ("DOME_DISPLAY", "0", "display", 0),
        ("DOME_KEEP_GOING", "1", "keep_going", True),
        ("DOME_TOLERANCE", "0.1", "tolerance", 0.1),
        ("DOME_METHOD", "tessellate", "method", "tessellate"),
        ("DOME_METHOD", "Cubemap: 512", "method", "cubemap:512"),
        ("DOME_SURFACE", "Dome", "fov", 180.0),
    ],
)
def test_what_is_accepted(variable, text, field, value):
    assert getattr(read(**{variable: text}), field) == value


@pytest.mark.parametrize(
    ("variable", "text", "message"),
    [
        ("DOME", "maybe", "DOME=maybe: neither on nor off; accepted: 0 or 1"),
        ("DOME_FOV", "abc", "DOME_FOV=abc: not a number; accepted: degrees over 0 to 360"),
        ("DOME_FOV", "0", "DOME_FOV=0: out of range; accepted: degrees over 0 to 360"),
        ("DOME_FOV", "360.01", "DOME_FOV=360.01: out of range; accepted: degrees over 0 to 360"),
        ("DOME_FOV", "nan", "DOME_FOV=nan: not a finite number; accepted: degrees over 0 to 360"),
        ("DOME_FOV", "1\n2", "DOME_FOV='1\\n2': not a number; accepted: degrees over 0 to 360"),
        ("DOME_TILT", "181", "DOME_TILT=181: out of range; accepted: degrees from -180 to 180"),
        ("DOME_LENS", "wide", "DOME_LENS=wide: not known; accepted: equidistant, equisolid, "),
        ("DOME_LENS", "stereografic", "not known; probably meant: stereographic; accepted: "),
        ("DOME_LENS", "opencv:1,2,3,4,5,6", "opencv takes 1 to 5 numbers, not 6"),
        ("DOME_LENS", "blender:1,2,3,4", "blender takes 5 to 6 numbers, not 4"),
        ("DOME_LENS", "no.csv", "DOME_LENS=no.csv: No such file or directory; accepted: "),
        ("DOME_HEADING", "-181", "DOME_HEADING=-181: out of range; accepted: degrees from -180 to 180"),
        ("DOME_ROLL", "up", "DOME_ROLL=up: not a number; accepted: degrees from -180 to 180"),
        ("DOME_SEAT", "1,2", "DOME_SEAT=1,2: 2 numbers; accepted: right,top,pole from the dome's centre"),
        ("DOME_SEAT", "0,1,0", "1 from the dome's centre, where DOME_RADIUS is 1; accepted: right,top,"),
        ("DOME_PROJECTOR", "0,0,x", "DOME_PROJECTOR=0,0,x: not a number"),
        ("DOME_RADIUS", "0", "DOME_RADIUS=0: out of range; accepted: a length over 0"),
        ("DOME_PRESET", "imax", "DOME_PRESET=imax: not known; accepted: domemaster"),
        ("DOME_LENS", "equidistant:1", "equidistant takes no numbers"),
        ("DOME_LENS", "polynomial", "polynomial takes 1 to 5 numbers, not 0"),
        ("DOME_LENS", "polynomial:1,2,3,4,5,6", "polynomial takes 1 to 5 numbers, not 6"),
        ("DOME_LENS", "polynomial:1,,2", "not a number"),
        ("DOME_LENS", "polynomial:inf", "not a finite number"),
        ("DOME_METHOD", "cubemap:8", "DOME_METHOD=cubemap:8: not the size of a cube's face; "),
        ("DOME_METHOD", "vertex:8", "DOME_METHOD=vertex:8: vertex takes no numbers; accepted: auto, "),
        ("DOME_METHOD", "fast", "DOME_METHOD=fast: not known; accepted: auto, paper, vertex, tessellate"),
        ("DOME_HUD", "beside", "DOME_HUD=beside: not known; accepted: panel, flat, side, off"),
        ("DOME_PANEL", "180", "out of range"),
        ("DOME_FILL", "0", "out of range"),
        ("DOME_FRAME", "1024", "DOME_FRAME=1024: not a size; accepted: WxH in pixels, each 1 to 16384"),
        ("DOME_FRAME", "0x5", "out of range"),
        ("DOME_FRAME", "16385x5", "out of range"),
        ("DOME_FRAME", "5x-5", "not a size"),
        ("DOME_DISPLAY", "-1", "not a display's number"),
        ("DOME_DISPLAY", "\N{SUPERSCRIPT TWO}", "not a display's number"),
        ("DOME_KEEP_GOING", "2", "neither on nor off"),
        ("DOME_TOLERANCE", "0", "DOME_TOLERANCE=0: out of range; accepted: pixels, at least 0.01"),
        ("DOME_STEREO", "both", "DOME_STEREO=both: not known; accepted: off, left, right, top-bottom"),
        ("DOME_DEBUG", "heat", "DOME_DEBUG=heat: not known; accepted: off, levels"),
        ("DOME_EYES", "-1", "DOME_EYES=-1: out of range; accepted: a length of at least 0"),
        ("DOME_CONFIG", "no.toml", "DOME_CONFIG='no.toml': No such file or directory; accepted: a dome.toml"),
        ("DOME_FVO", "180", "DOME_FVO: no such variable; probably meant: DOME_FOV"),
        ("DOME_METHODS", "paper", "DOME_METHODS: no such variable; probably meant: DOME_METHOD"),
        ("DOME_TOLERENCE", "1", "DOME_TOLERENCE: no such variable; probably meant: DOME_TOLERANCE"),
    ],
)
def test_what_is_refused_in_one_line(variable, text, message):
    with pytest.raises(OptionError) as refused:
        read(**{variable: text})
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


def test_other_softwares_variables_are_left_alone():
    assert read(DOME_NAME="Zeiss", DOME_HOME="/opt", DOMESTIC="1", dome_fov="abc") == Options()


def test_a_commands_options_win_and_are_named_as_typed():
    environ = {"DOME_FOV": "abc", "DOME_TILT": "20"}
    assert Options.from_environment(environ, {"fov": "200"}) == Options(fov=200.0, tilt=20.0)
    with pytest.raises(OptionError, match=r"^--fov=x: not a number"):
        Options.from_environment({}, {"fov": "x"})


def test_the_real_environment_is_read_by_default(monkeypatch):
    monkeypatch.setenv("DOME_TILT", "30")
    assert Options.from_environment().tilt == 30.0


def test_a_lens_that_stops_rising_is_refused_with_the_angle():
    # The slope of phi - phi^2 / 2 is 1 - phi: it ends at 1 radian, 57.3 degrees.
    with pytest.raises(OptionError, match=r"stops rising 57\.3 degrees .*90 degrees, half of DOME_FOV"):
        read(DOME_LENS="polynomial:1,-0.5")
    assert read(DOME_LENS="polynomial:1,-0.5", DOME_FOV="114").fov == 114.0
    with pytest.raises(OptionError, match=r"stops rising 0 degrees"):
        read(DOME_LENS="polynomial:0,1")


@given(
    st.lists(st.floats(-2, 2).filter(lambda c: c == 0 or abs(c) > 1e-3), min_size=1, max_size=5),
    st.floats(1, 360),
)
def test_a_lens_is_accepted_just_where_its_slope_is_positive(coefficients, fov):
    slope = np.polynomial.Polynomial([i * c for i, c in enumerate(coefficients, 1)])
    lowest = slope(np.linspace(0, math.radians(fov / 2), 2000)).min()
    lens = "polynomial:" + ",".join(map(repr, coefficients))
    if lowest > 1e-3:
        assert read(DOME_LENS=lens, DOME_FOV=repr(fov)).lens == ("polynomial", tuple(coefficients))
    elif lowest < -1e-3:
        with pytest.raises(OptionError, match="stops rising"):
            read(DOME_LENS=lens, DOME_FOV=repr(fov))


@given(st.sampled_from(sorted(VARIABLES.values())), st.text(max_size=20))
def test_any_text_gives_a_value_or_one_line(variable, text):
    said = ""
    try:
        read(**{variable: text})
    except OptionError as refused:
        said = str(refused)
    assert len(said.splitlines()) <= 1


def test_options_cannot_be_changed_but_replaced():
    options = Options()
    with pytest.raises(FrozenInstanceError):
        options.fov = 1.0  # type: ignore[misc]
    assert replace(options, fov=1.0) == Options(fov=1.0)


def test_cube_faces_are_seen_by_one_eye() -> None:
    with pytest.raises(OptionError) as caught:
        Options.from_environment({"DOME_METHOD": "cubemap", "DOME_STEREO": "left"})
    wanted = (
        "DOME_METHOD=cubemap: its faces are seen by one eye; accepted: with DOME_STEREO=left any other method"
    )
    assert str(caught.value) == wanted
