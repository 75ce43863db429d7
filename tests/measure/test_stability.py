"""The dome's promise on stiff and extreme geometry: within the tolerance, by every method that subdivides."""

import numpy as np
import pytest

from domeshim.measure.extremes import EXTREMES
from domeshim.measure.formulas import formula_errors
from domeshim.measure.reference import disc_directions
from domeshim.measure.room import FACES, cast, colors, true_picture
from domeshim.measure.stability import METHODS, measure, ratio
from domeshim.settings import ACCEPTED

SIZES, TOLERANCE = (1024, 8192), 0.5
RATIOS = tuple(ratio(size, TOLERANCE) for size in SIZES)
QUICK = [case for case in EXTREMES if case.fov < 360 or case.mode == 1]


@pytest.fixture(scope="module")
def rows():
    found, renderer = measure(QUICK, dict.fromkeys(("auto", "geometry"), RATIOS), lambda row: row)
    assert renderer
    return found


def test_every_case_keeps_the_tolerance(rows):
    assert len(rows) == 2 * len(QUICK)
    off = {
        f"{row.case.name}, {row.method}, {size}": row.pixels(size, TOLERANCE).edges
        for row in rows
        for size in SIZES
    }
    assert {name: pixels for name, pixels in off.items() if pixels > TOLERANCE} == {}


def test_what_is_left_out_straight_behind_is_narrower_than_the_tolerance():
    around = [case for case in EXTREMES if case.name == "fov 360, triangle around straight behind"]
    [row], _ = measure(around, {"auto": (2048.0,)}, lambda row: row)
    assert 0.1 < row.pixels(2048, TOLERANCE).edges <= 0.6 * TOLERANCE


def test_places_inside_a_surface_are_off_by_little_more(rows):
    inside = [row.pixels(size, TOLERANCE).inside for row in rows for size in SIZES]
    assert 0 < max(inside) < 3 * TOLERANCE


def test_without_subdivision_the_tolerance_is_broken():
    found, _ = measure(EXTREMES[:1], dict.fromkeys(("paper", "vertex", "cpu"), RATIOS[:1]), lambda row: row)
    paper, vertex, cpu = (row.pixels(1024, TOLERANCE).edges for row in found)
    assert min(paper, vertex) > 100
    assert cpu < TOLERANCE


def test_every_method_is_measured():
    accepted = {name.split(":")[0] for name in ACCEPTED["method"].split(" (")[0].split(", ")}
    assert accepted - {"cubemap"} == set(METHODS)


def test_our_formula_is_exact_at_every_distance_and_theirs_are_not():
    errors = {(error.formula.split(",")[0], error.distance): error.radii for error in formula_errors()}
    ours = [radii for (name, _), radii in errors.items() if name.startswith("ours")]
    assert len(ours) == 3
    assert max(ours) < 1e-5
    assert errors["acos(-z / r)", 1.0] > 1e-4
    assert errors["method paper: atan(rxy", 1e-20] > 1


def test_rays_meet_the_walls_that_the_program_draws():
    for face, corners in enumerate(FACES):
        for s, t in ((0.25, 0.25), (0.5, 0.5), (0.125, 0.75)):
            place = corners[0] + s * (corners[1] - corners[0]) + t * (corners[3] - corners[0])
            assert cast(place) == pytest.approx(colors(face, np.array(s), np.array(t)), abs=1e-12)


def test_the_true_picture_is_what_rays_through_its_pixels_meet():
    size = 256
    directions, inside = disc_directions(size, 180.0, 0.0)
    off = np.abs(true_picture(size) - 255 * cast(directions))[inside]
    assert np.median(off) < 1
    assert np.quantile(off, 0.95) < 8
