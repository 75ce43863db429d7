"""PyOpenGL's own demos through the faces of a cube, held against the direct method's pictures of them."""

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from domeshim.measure.match import match_discs

SIZE = 256
PROGRAMS = [
    ("GLUT/gears.py", "100", "0"),
    ("NeHe/lesson5.py", "180", "60"),
    ("NeHe/lesson12.py", "240", "30"),
    ("redbook/scene.py", "360", "0"),
]


def demos():
    found = find_spec("OpenGL_Demo")
    if found is None or not found.submodule_search_locations:
        pytest.skip("PyOpenGL-Demo is not installed")
    return Path(found.submodule_search_locations[0])


@pytest.mark.parametrize(("program", "fov", "tilt"), PROGRAMS)
def test_demos_look_the_same_through_the_faces(tmp_path, program, fov, tilt):
    path = demos() / program
    pictures = []
    for method in ("auto", "cubemap"):
        output = tmp_path / f"{method}.png"
        options = ["--method", method, "--fov", fov, "--tilt", tilt, "--size", str(SIZE)]
        command = [sys.executable, "-m", "domeshim", "capture", "--mode", "dome", "--frame", "1", *options]
        subprocess.run([*command, "--output", output, path], check=True, capture_output=True)
        pictures.append(np.asarray(Image.open(output).convert("RGB")))
    match = match_discs(*pictures)
    assert match.content > 100
    assert match.share < 0.02
