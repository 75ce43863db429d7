"""Lens models in numpy: forward, back, slope, end; and what they refuse."""

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from domeshim.lens.catalogue import MODELS
from domeshim.lens.knots import radius_at, rising_slopes
from domeshim.lens.models import LensError, lens_of
from domeshim.shading.snippets import snippet
from tests.lens.lenses import BLENDER, BLENDER_WIDE, OPENCV, every_lens, measured

RNG = np.random.default_rng(5)
LENSES = pytest.mark.parametrize("lens", every_lens(), ids=lambda lens: f"{type(lens).__name__} {lens.fov}")


def test_every_model_is_among_those_that_are_tested():
    tested = {type(lens).__name__.lower() for lens in every_lens()}
    assert {*MODELS, "measured"} == tested


@LENSES
def test_the_inverse_leads_back(lens):
    phi = np.concatenate([RNG.uniform(0, lens.end, 100_000), 10.0 ** -np.arange(12), [0.0, lens.end]])
    phi = phi[phi <= lens.end]
    assert np.abs(lens.angle(lens.radius(phi)) - phi).max() < 1e-6


@LENSES
def test_the_radius_rises_from_0_and_beyond_the_end(lens):
    phi = np.linspace(0, np.pi, 10_001)
    radius = lens.radius(phi)
    assert radius[0] == 0
    assert np.diff(radius[phi <= lens.end]).min() > 0
    assert np.diff(radius).min() >= -1e-15
    assert np.isnan(lens.angle(np.array(radius.max() * 1.1)))


@LENSES
def test_the_slope_is_the_radiuss_own(lens):
    phi = RNG.uniform(1e-3, lens.end - 1e-3, 1000)
    numeric = (lens.radius(phi + 1e-6) - lens.radius(phi - 1e-6)) / 2e-6
    assert lens.slope(phi) == pytest.approx(numeric, rel=1e-4)


@LENSES
def test_the_snippet_is_there(lens):
    assert "float lensRadius(float phi)" in snippet(f"lens/{lens.name}")


@pytest.mark.parametrize("name", ["equidistant", "equisolid", "stereographic", "orthographic", "opencv"])
def test_lenses_without_a_size_fill_the_disc(name):
    numbers = OPENCV if name == "opencv" else ()
    for fov in (40, 110, 180):
        assert lens_of(name, numbers, fov).rim == pytest.approx(1)


def test_formulas():
    at = {name: lens_of(name, (), 180).radius(np.radians([30.0, 60.0])) for name in list(MODELS)[:4]}
    assert at["equidistant"] == pytest.approx([1 / 3, 2 / 3])
    assert at["equisolid"] == pytest.approx([0.3660254, 0.7071068])
    assert at["stereographic"] == pytest.approx([0.2679492, 0.5773503])
    assert at["orthographic"] == pytest.approx([0.5, 0.8660254])
    # 0.64 * (1 - 0.02 + 0.004 - 0.003 + 0.0005) at one radian.
    assert lens_of("opencv", (*OPENCV, 0.64), 180).radius(np.array(1.0)) == pytest.approx(0.62816)


def test_blenders_lens_is_the_angle_by_the_radius():
    millimetres = np.array([1.0, 5.0, 12.0, 18.0])
    angles = -np.polyval(BLENDER_WIDE[::-1], millimetres)
    assert lens_of("blender", BLENDER_WIDE, 190).radius(angles) == pytest.approx(millimetres / 18)
    assert lens_of("blender", (*BLENDER_WIDE, 24.0), 120).radius(angles[:3]) == pytest.approx(
        millimetres[:3] / 12
    )
    # Blender's first setting is its perspective of 50 mm on 36 mm.
    seen = lens_of("blender", BLENDER, 180).angle(np.array([0.5, 1.0]))
    assert np.tan(seen) * 50 == pytest.approx([9, 18], rel=0.01)


def test_a_measured_lens_goes_through_its_points_and_between_them_as_scipys():
    numbers = measured()
    lens = lens_of("measured", numbers, 180)
    angles, radii = np.radians(numbers[::2]), np.array(numbers[1::2])
    assert lens.radius(angles) == pytest.approx(radii, abs=1e-12)
    x = np.concatenate([-angles[::-1], [0], angles])
    y = np.concatenate([-radii[::-1], [0], radii])
    between = np.linspace(0, angles[-1], 999)
    assert lens.radius(between) == pytest.approx(PchipInterpolator(x, y)(between), abs=1e-12)


def test_the_rising_curve_is_scipys_for_any_rising_points():
    for _ in range(20):
        x, y = (np.cumsum(RNG.exponential(size=12)) for _ in "xy")
        knots = np.stack([x, y, rising_slopes(x, y)], -1)
        between = np.linspace(x[0], x[-1], 500)
        assert radius_at(knots, between) == pytest.approx(PchipInterpolator(x, y)(between), abs=1e-9)
        assert np.diff(radius_at(knots, between)).min() >= 0


def test_a_long_table_keeps_within_a_thousandth():
    numbers = measured(500)
    lens = lens_of("measured", numbers, 180)
    assert len(lens.knots) == 64
    assert np.abs(lens.radius(np.radians(numbers[::2])) - numbers[1::2]).max() < 1e-3


@pytest.mark.parametrize(
    ("name", "numbers", "fov", "why"),
    [
        ("orthographic", (), 181, "folds back .*180 degrees at most, DOME_FOV is 181"),
        ("stereographic", (), 360, "infinitely far out.*359 degrees at most, DOME_FOV is 360"),
        ("polynomial", (1.0, -0.5), 180, r"stops rising 57\.3 degrees .*90 degrees, half of DOME_FOV"),
        ("polynomial", (0.0, 1.0), 180, "stops rising 0 degrees"),
        ("opencv", (-0.5,), 180, "stops rising"),
        ("opencv", (0, 0, 0, 0, -1.0), 180, "stops rising 0 degrees"),
        ("blender", (0.1, -0.05, 0, 0, 0), 180, "k0 is the angle on the axis"),
        ("blender", (0, -0.1, 0.005, 0, 0), 180, r"stops rising at 28\.6.* degrees, 10 mm from the axis"),
        ("blender", (0, -0.1, 0, 0, 0, 0.0), 180, "width must be over 0"),
        ("measured", measured(10, 60.0), 180, "the table ends 60 degrees .*before 90 degrees"),
    ],
)
def test_what_a_model_cannot_do_is_refused(name, numbers, fov, why):
    with pytest.raises(LensError, match=why):
        lens_of(name, numbers, fov)


def test_a_rough_table_is_refused():
    angles = np.linspace(1, 100, 400)
    radii = angles / 100 + 0.003 * np.sin(np.arange(400) * 0.6) * (np.arange(400) % 7 == 0)
    radii = np.maximum.accumulate(radii) + angles * 1e-6
    with pytest.raises(LensError, match="too rough for 64 points of a curve"):
        lens_of("measured", tuple(np.stack([angles, radii], -1).ravel()), 180)


def test_equisolid_reaches_straight_behind():
    assert lens_of("equisolid", (), 360).radius(np.array(np.pi)) == pytest.approx(1)
