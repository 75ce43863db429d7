"""Keystones and warp meshes: their mathematics, their files, and what is refused."""

import os
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from domeshim.errors import OptionError
from domeshim.lens.keystone import WHOLE, Keystone
from domeshim.lens.mesh import MeshError, read_mesh
from domeshim.options import Options
from tests.waiting import LONGEST

CORNERS = (0.2, 0.0, 0.9, 0.1, 1.0, 1.0, 0.0, 0.8)
SQUARE = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], float)


def test_keystone_takes_the_corners_where_they_shall_go():
    assert np.allclose(Keystone(CORNERS).to_frame(SQUARE), 2 * np.reshape(CORNERS, (4, 2)) - 1)
    assert np.allclose(Keystone(WHOLE).matrix, np.eye(3))


@given(st.lists(st.floats(-1, 1), min_size=2, max_size=2))
def test_keystone_has_its_inverse(place):
    keystone = Keystone(CORNERS)
    assert np.allclose(keystone.to_disc(keystone.to_frame(np.array(place))), place)


def test_keystone_keeps_lines_straight():
    line = np.linspace([-1, -0.3], [0.8, 1], 9)
    a, *middle, b = Keystone(CORNERS).to_frame(line)
    across = np.cross(np.append(b - a, 0), [0, 0, 1])[:2]
    assert max(abs((place - a) @ across) for place in middle) < 1e-12


def test_no_length_grows_by_more_than_the_stretch():
    keystone = Keystone((0.4, 0.0, 0.6, 0.0, 1.0, 1.0, 0.0, 1.0))
    grid = np.random.default_rng(2).uniform(-1, 1, (500, 2, 2))
    grid[:, 1] = grid[:, 0] + (grid[:, 1] - grid[:, 0]) * 1e-3
    before = np.linalg.norm(grid[:, 1] - grid[:, 0], axis=1)
    after = np.linalg.norm(np.diff(keystone.to_frame(grid), axis=1)[:, 0], axis=1)
    assert 0.8 * keystone.stretch < (after / before).max() < 1.01 * keystone.stretch


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("keystone:1,2", "2 numbers"),
        ("keystone:a", "not eight numbers"),
        ("keystone:0,0,1,0,1,2,0,1", "outside"),
        ("keystone:0,0,0,1,1,1,1,0", "round to the left"),
        ("keystone:0,0,1,0,0.1,0.1,0,1", "round to the left"),
        ("cone", "no file of that name"),
    ],
)
def test_malformed_surface_is_refused(text, reason):
    with pytest.raises(OptionError, match=reason):
        Options.from_environment({"DOME_SURFACE": text})


def test_what_cannot_go_together_is_refused(tmp_path):
    mesh = tmp_path / "m.data"
    mesh.write_text(bourke())
    whole = "keystone:0,0,1,0,1,1,0,0.9"
    for variables, reason in (
        ({"DOME_SURFACE": whole, "DOME_METHOD": "cubemap"}, "cubemap"),
        ({"DOME_SURFACE": str(mesh), "DOME_STEREO": "left-right"}, "one mesh"),
        ({"DOME_FADE": "5", "DOME_STEREO": "top-bottom"}, "DOME_STEREO"),
    ):
        with pytest.raises(OptionError, match=reason):
            Options.from_environment(variables)


STARTS = {
    "DOME=1": ["-c", "from domeshim import startup; startup.arm_at_start(); print('began')"],
    "capture": ["-m", "domeshim", "capture", "--output", "out.png", "prog.py"],
}


@pytest.mark.parametrize("arguments", STARTS.values(), ids=STARTS)
def test_a_file_that_is_no_mesh_ends_in_one_line_before_the_program_begins(tmp_path, arguments):
    (tmp_path / "bad.data").write_text("2\n3 3\n1 2 3\n")
    (tmp_path / "prog.py").write_text("print('began')\n")
    environ = {**os.environ, "DOME": "1", "DOME_SURFACE": "bad.data", "PYTHONPATH": os.pathsep.join(sys.path)}
    ended = subprocess.run(
        [sys.executable, *arguments],
        cwd=tmp_path,
        env=environ,
        capture_output=True,
        text=True,
        timeout=LONGEST,
    )
    said = "domeshim: DOME_SURFACE: bad.data: 3 by 3 nodes of x y u v i are 45 numbers, and there are 3\n"
    assert (ended.returncode, ended.stdout, ended.stderr) == (2, "", said)


def bourke(columns=5, rows=4, aspect=1.0, place=lambda u, v: (2 * u - 1, 2 * v - 1)):
    """A mesh's text: the picture's u and v where place says."""
    lines = ["2", f"{columns} {rows}"]
    for v in np.linspace(0, 1, rows):
        for u in np.linspace(0, 1, columns):
            x, y = place(u, v)
            lines.append(f"{x * aspect} {y} {u} {v} 1")
    return "\n".join(lines)


@pytest.mark.parametrize("aspect", [1.0, 16 / 9])
def test_bourke_mesh_shows_what_it_says(tmp_path, aspect):
    path = tmp_path / "m.data"
    path.write_text(bourke(aspect=aspect))
    mesh = read_mesh(path, 16 / 9)
    assert len(mesh.triangles) == 2 * 4 * 3
    places = np.random.default_rng(1).uniform(-1, 1, (50, 2))
    assert np.allclose(mesh.shown_at(places), (places + 1) / 2)
    assert np.isnan(mesh.shown_at(np.array([[1.2, 0.0]]))).all()


def test_node_of_negative_intensity_is_off(tmp_path):
    path = tmp_path / "m.data"
    lines = bourke(3, 3).split("\n")
    lines[2] = lines[2][:-1] + "-1"
    path.write_text("\n".join(lines))
    assert len(read_mesh(path, 1.0).triangles) == 2 * 4 - 2


def test_polar_mesh_is_closed(tmp_path):
    path = tmp_path / "m.data"
    around = np.arange(8) * np.pi / 4
    nodes = [
        f"{r * np.cos(a)} {r * np.sin(a)} {(r * np.cos(a) + 1) / 2} {(r * np.sin(a) + 1) / 2} 1"
        for r in (0.1, 1.0)
        for a in around
    ]
    path.write_text("\n".join(["1", "8 2", *nodes]))
    place = np.array([[0.5 * np.cos(-0.3), 0.5 * np.sin(-0.3)]])
    assert np.allclose(read_mesh(path, 1.0).shown_at(place), (place + 1) / 2)


def test_obj_with_texture_coordinates(tmp_path):
    path = tmp_path / "screen.obj"
    path.write_text(
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 -1/-1\n"
    )
    assert np.allclose(read_mesh(path, 1.0).shown_at(np.array([[0.5, -0.5]])), [[0.75, 0.25]])


@pytest.mark.parametrize(
    ("name", "text", "reason"),
    [
        ("a.data", "hello", "no warp mesh"),
        ("a.data", "7\n2 2\n", "kind 7"),
        ("a.data", "2\n1 9\n", "1 by 9"),
        ("a.data", "2\n2 2\n1 2 3", "20 numbers, and there are 3"),
        ("a.data", "2\n2 2\n" + "x " * 20, "not a number"),
        ("a.data", "2\n2 2\n" + "nan 0 0 0 1\n" * 4, "not finite"),
        ("a.data", "2\n2 2\n" + "0 0 3 0 1\n" * 4, "outside 0 to 1"),
        ("a.data", "2\n2 2\n" + "0 0 0 0 -1\n" * 4, "switched on"),
        ("a.obj", "v 0 0 0\nf 1 1 1\n", "line 2.*without texture"),
        ("a.obj", "v 0 0 0\n", "no faces"),
        ("a.obj", "v 0 0 0\nvt 0 0\nf 1/1 2/1 1/1\n", "that there is not"),
    ],
)
def test_broken_file_is_one_clear_error(tmp_path, name, text, reason):
    (tmp_path / name).write_text(text)
    with pytest.raises(MeshError, match=reason):
        read_mesh(tmp_path / name, 1.0)


def test_binary_file_is_no_mesh(tmp_path):
    (tmp_path / "a.data").write_bytes(bytes([0xFF, 0xFE, 0x80]))
    with pytest.raises(MeshError, match="not a text file"):
        read_mesh(tmp_path / "a.data", 1.0)
