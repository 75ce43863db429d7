"""The guide to a real projector: its commands run, its settings are accepted, its pictures are there."""

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner
from PIL import Image

from domeshim.cli import commands
from domeshim.options import Options

ROOT = Path(__file__).resolve().parent.parent
GUIDE = (ROOT / "docs" / "dome.md").read_text()
_INDENTED = re.findall(r"((?:^    \S.*\n)+)", GUIDE, re.MULTILINE)
BLOCKS = [found.replace("    ", "") for found in _INDENTED]
LINES = [line for block in BLOCKS for line in block.splitlines()]
COMMANDS = [line for line in LINES if line.startswith("domeshim lens")]
SETTINGS = [line for line in LINES if re.match(r"\w+ = ", line)]


@pytest.fixture
def there(tmp_path, monkeypatch):
    """A folder with the guide's files in it, and the dome.toml that its fit writes."""
    (tmp_path / "docs").symlink_to(ROOT / "docs")
    (tmp_path / "dome.toml").write_text("fov = 170\n")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_about_the_lens_runs(there, command):
    _, *words = shlex.split(command)
    if "pattern" in words:
        if "--size" not in words:
            words += ["--size", "128"]
        words += ["--output", "card.png"]
    if "--plot" in words:
        pytest.importorskip("matplotlib")
    ended = CliRunner().invoke(commands, words, catch_exceptions=False)
    assert ended.exit_code == 0, ended.output
    if "pattern" in words:
        assert Image.open("card.png").getextrema()[0][1] == 255


def test_every_setting_is_accepted(there):
    assert len(SETTINGS) >= 15
    for line in SETTINGS:
        (there / "dome.toml").write_text("radius = 4\n" * line.startswith("seat") + line)
        assert Options.from_environment({"DOME_CONFIG": "dome.toml"}) != Options()
    whole = next(block for block in BLOCKS if block.startswith("# dome.toml"))
    (there / "dome.toml").write_text(whole)
    options = Options.from_environment({"DOME_CONFIG": "dome.toml"})
    assert (options.display, options.fov, options.hud) == (1, 176.54, "side")


def test_the_fit_is_the_one_in_the_guide(there):
    said = CliRunner().invoke(commands, ["lens", "fit", "docs/dome/lens.csv", "--size", "1080"]).output
    lens = re.search(r"DOME_LENS=(\S+)", said)
    assert lens is not None
    assert f'lens = "{lens[1]}"' in SETTINGS


def test_every_picture_is_there():
    pictures = re.findall(r"\((pictures/[\w-]+\.png)\)", GUIDE)
    assert len(pictures) == 9
    assert all((ROOT / "docs" / picture).is_file() for picture in pictures)
