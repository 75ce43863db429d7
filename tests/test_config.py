"""dome.toml: the same settings in a file; what is wrong in it is said in one line."""

from __future__ import annotations

from pathlib import Path

import pytest

from domeshim.errors import OptionError
from domeshim.options import Options

WHOLE = """\
# The dome of the school.
lens = "polynomial:0.62,0.03"   # measured in May
DOME_FOV = 170
tilt = 20.5
seat = [0, -1.5, 0.25]
radius = 4
keep_going = true
"""


@pytest.fixture
def config(tmp_path: Path):
    def write(text: str) -> str:
        (tmp_path / "dome.toml").write_text(text)
        return str(tmp_path / "dome.toml")

    return write


def test_every_kind_of_value(config):
    options = Options.from_environment({"DOME_CONFIG": config(WHOLE)})
    assert options == Options(
        lens=("polynomial", (0.62, 0.03)),
        fov=170.0,
        tilt=20.5,
        seat=(0.0, -1.5, 0.25),
        radius=4.0,
        keep_going=True,
    )


def test_variables_win_over_the_file_and_options_over_both(config):
    environ = {"DOME_CONFIG": config(WHOLE), "DOME_TILT": "30", "DOME_FOV": "160"}
    options = Options.from_environment(environ, {"fov": "150"})
    assert (options.tilt, options.fov, options.radius) == (30.0, 150.0, 4.0)
    options = Options.from_environment({"DOME_CONFIG": "nowhere.toml"}, {"config": environ["DOME_CONFIG"]})
    assert options.tilt == 20.5


def test_a_preset_is_weakest(config):
    assert Options.from_environment({"DOME_PRESET": "domemaster"}) == Options(tilt=90.0)
    environ = {"DOME_CONFIG": config('preset = "domemaster"\nfov = 170'), "DOME_TILT": "60"}
    assert Options.from_environment(environ) == Options(tilt=60.0, fov=170.0)


def test_a_lens_file_is_looked_for_beside_the_config(config, tmp_path, monkeypatch):
    (tmp_path / "My Lens.csv").write_text("angle,radius\n30,0.4\n60,0.75\n90,1\n")
    monkeypatch.chdir("/")
    lens = ("measured", (30.0, 0.4, 60.0, 0.75, 90.0, 1.0))
    assert Options.from_environment({"DOME_CONFIG": config('lens = "My Lens.csv"')}).lens == lens
    assert Options.from_environment({"DOME_LENS": str(tmp_path / "My Lens.csv")}).lens == lens


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("fov = 180\ntitl = 30\n", "{}:2: titl: no such setting; probably meant: tilt"),
        ("DOME_TOLERENCE = 1", "{}:1: DOME_TOLERENCE: no such setting; probably meant: tolerance"),
        ("xyzzy = 1", "{}:1: xyzzy: no such setting; accepted: brightness, debug, disc, display, eyes, "),
        ("dome = 1", "{}:1: dome: no such setting"),
        ("\n\nfov = 'wide'", "{}:3: fov=wide: not a number; accepted: degrees over 0 to 360"),
        ("tilt = 1\nfov = {{a = 1}}", "{}:2: fov: a dict; accepted: a string, a number, a list of numbers"),
        ("[fov]\na = 1", "{}:1: fov: a dict; accepted: a string"),
        ("fov = 1\nDOME_FOV = 2", "{}:2: DOME_FOV: said before, by {}:1: fov"),
        ("fov = 1\nfov = 2", "{}: not TOML: Cannot overwrite a value (at "),
        ("fov =", "{}: not TOML: Invalid value (at "),
        ("lens = 'orthographic'\nfov = 200", "{}:1: lens=orthographic: an orthographic lens folds back"),
        (
            "seat = [0, 5, 0]\nradius = 4",
            "{}:1: seat=0,5,0: 5 from the dome's centre, where DOME_RADIUS is 4",
        ),
    ],
)
def test_what_is_wrong_is_said_in_one_line(config, text, message):
    path = config(text.replace("{{", "{").replace("}}", "}"))
    with pytest.raises(OptionError) as refused:
        Options.from_environment({"DOME_CONFIG": path})
    assert str(refused.value).startswith(message.replace("{}", path))
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", None])
def test_no_text_and_no_file(tmp_path, content):
    path = tmp_path / "dome.toml"
    path.write_bytes(content) if content is not None else path.mkdir()
    with pytest.raises(OptionError, match=r"not TOML|Is a directory"):
        Options.from_environment({"DOME_CONFIG": str(path)})
