"""Lens files: what they hold, and what is refused in them."""

import pytest

from domeshim.lens.table import read_table


def written(tmp_path, text, name="lens.csv"):
    (tmp_path / name).write_text(text)
    return tmp_path / name


def test_points_come_in_the_order_of_their_angles(tmp_path):
    path = written(tmp_path, "radius angle\n0.9 80\n0.3 20\n0 0\n0.6 50\n")
    assert read_table(path) == (20, 0.3, 50, 0.6, 80, 0.9)
    path = written(tmp_path, "angle = [20, 50, 80]\nradius = [0.3, 0.6, 0.9]", "lens.toml")
    assert read_table(path) == (20, 0.3, 50, 0.6, 80, 0.9)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("20,0.3\n50,0.6\n", "2 points off the axis; a table needs 3 or more"),
        ("", "0 points off the axis"),
        ("20,0.3\n50,0.6\n50,0.61\n80,1\n", "line 2 and line 3 contradict each other: 50 degrees twice"),
        ("20,0.3\n50,0.25\n80,1\n", "line 2: the radius 0.25 at 50 degrees is not above 0.3 at 20"),
        ("0,0.1\n20,0.3\n50,0.6\n80,1\n", "line 1: the angle 0 has the radius 0.1 and not 0"),
        ("20,300\n50,600\n80,900\n", "line 1: a radius of 300, where 1 is the disc's rim"),
    ],
)
def test_what_is_refused(tmp_path, text, why):
    with pytest.raises(ValueError, match=why):
        read_table(written(tmp_path, text))
