"""domeshim lens, as it is called."""

import sys

import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

from domeshim.cli import commands
from domeshim.errors import DomeError, OptionError, ScreenError
from domeshim.lens.models import lens_of
from domeshim.options import Options
from tests.displays import needs_xvfb
from tests.GLUT.program_runs import run_on_screen

TRUE = (0.62, 0.03, -0.012, 0.004, -0.0006)


def call(*arguments):
    result = CliRunner().invoke(commands, ["lens", *map(str, arguments)], catch_exceptions=False)
    assert result.exit_code == 0, result.output
    return result.output


@pytest.fixture
def data(tmp_path):
    phi = np.linspace(0, np.pi / 2, 40)
    radius = 540 * lens_of("polynomial", TRUE, 180).radius(phi)
    lines = [f"{r:.6f},{a:.6f}" for r, a in zip(radius, np.degrees(phi), strict=True)]
    (tmp_path / "data.csv").write_text("\n".join(["radius,angle", *lines]))
    return tmp_path / "data.csv"


def test_fit_writes_a_dome_toml_that_is_ready_to_use(data, tmp_path):
    said = call("fit", data, "--size", 1080, "--output", tmp_path / "dome.toml")
    options = Options.from_environment({"DOME_CONFIG": str(tmp_path / "dome.toml")})
    assert options.lens[0] == "polynomial"
    assert options.lens[1] == pytest.approx(TRUE, abs=1e-6)
    assert options.fov == pytest.approx(176.56, abs=0.02)  # there the radius is 1
    assert "40 pairs, off by" in said
    assert "DOME_LENS=polynomial:0.6" in said


def test_fit_refuses_in_one_line(data, tmp_path):
    with pytest.raises(OptionError, match=r"line 3: a radius of 13\S+; if it is in pixels, give --size"):
        call("fit", data)
    (tmp_path / "few.csv").write_text("1,0.1\n2,0.2\n")
    with pytest.raises(OptionError, match=r"few\.csv: too few: 2 different angles"):
        call("fit", tmp_path / "few.csv")
    with pytest.raises(OptionError, match=r"none\.csv: No such file or directory; accepted: two columns"):
        call("fit", tmp_path / "none.csv")
    with pytest.raises(OptionError, match=r"--output=.*accepted: a file to write"):
        call("fit", data, "--size", 1080, "--output", data / "dome.toml")


def test_plots(data, tmp_path):
    pytest.importorskip("matplotlib")
    call("fit", data, "--size", 1080, "--plot", tmp_path / "fit.png")
    call("show", "equisolid", "--plot", tmp_path / "plots" / "show.png")
    for name in ("fit.png", "plots/show.png"):
        pixels = np.asarray(Image.open(tmp_path / name).convert("L"))
        assert pixels.std() > 5
    with pytest.raises(OptionError, match=r"--plot=.*\.xyz: not known; accepted: a \.png"):
        call("show", "equisolid", "--plot", tmp_path / "show.xyz")


def test_a_plot_without_matplotlib_names_the_extra(data, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(DomeError, match=r"pip install 'domeshim\[plot\]'"):
        call("show", "equisolid", "--plot", "show.png")


def test_show_prints_a_table():
    rows = [line.split() for line in call("show", "stereographic", "--fov", "180").splitlines()]
    assert rows[0] == ["angle", "radius", "a", "degree", "of", "equidistant"]
    assert rows[4] == ["30.00", "0.26795", "0.009353", "0.842"]
    assert rows[-1][:2] == ["90.00", "1.00000"]
    with pytest.raises(OptionError, match="--lens=stereo: not known; probably meant: stereographic"):
        call("show", "stereo")


def test_pattern_writes_a_card_of_the_frames_size(tmp_path):
    output = tmp_path / "new" / "card.png"
    call("pattern", "--fov", 200, "--lens", "equisolid", "--size", "320x256", "--output", output)
    with Image.open(output) as card:
        assert card.size == (320, 256)
        assert np.asarray(card).max() == 255
    call("pattern", "--frame", "200x100", "--output", output)
    with Image.open(output) as card:
        assert card.size == (200, 100)
    with pytest.raises(OptionError, match=r"--output=.*: unknown file extension: \.xyz; accepted: a picture"):
        call("pattern", "--size", 64, "--output", tmp_path / "card.xyz")


def test_pattern_honours_disc_surface_and_mirror(tmp_path):
    def pattern(*options):
        call("pattern", "--size", "300x200", *options, "--output", tmp_path / "card.png")
        return np.asarray(Image.open(tmp_path / "card.png")).astype(int)

    plain = pattern("--disc", "100,100,90")
    assert (plain[100, 5:14].max(-1) > 200).any()
    assert plain[10:190, 200:298].max() == 0
    assert np.abs(pattern("--disc", "100,100,90", "--mirror", "horizontal") - plain[:, ::-1]).max() <= 1
    (tmp_path / "half.data").write_text("2\n2 2\n-1 -1 0 0 1\n0 -1 1 0 1\n-1 1 0 1 1\n0 1 1 1 1\n")
    halved = pattern("--surface", tmp_path / "half.data")
    assert halved[:, 152:].max() == 0
    assert halved[:, :148].max() > 200
    wide = pattern("--surface", "cylinder:160")
    assert (wide[100, 3:-3].max(-1) > 100).mean() > 0.9  # its horizon


def test_pattern_without_a_display_names_the_way_out(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    with pytest.raises(ScreenError, match=r"no display .*; --output FILE writes the card without one"):
        call("pattern")


ON_SCREEN = """
import subprocess, sys
from PIL import ImageGrab
from tests.waiting import LONGEST, wait_for
def white():
    return shown.poll() is not None or sum(min(pixel) > 200 for pixel in ImageGrab.grab().getdata()) > 400
with subprocess.Popen([sys.executable, "-m", "domeshim", "lens", "pattern", "--size", "300"]) as shown:
    try:
        wait_for(white, 0.1)
        subprocess.run(["xdotool", "key", "q"], check=True)
        print(shown.wait(LONGEST))
    finally:
        shown.kill()
"""


@needs_xvfb
def test_pattern_in_a_window_ends_by_q(tmp_path):
    ended = run_on_screen(tmp_path, ON_SCREEN)
    assert ended.stdout.strip() == "0", ended.stderr
