"""The shaders' weights even in angle against their numpy twins."""

import numpy as np
import pytest

from domeshim.lens.weights import line_weights, triangle_weights
from domeshim.shading.snippets import snippet
from tests.shading.feedback import caught

RNG = np.random.default_rng(2006)


def homogeneous(values):
    """(n, 2 or 3) -> (n, 4) float32, ones where there is nothing."""
    return np.hstack([values, np.ones((len(values), 4 - values.shape[1]))]).astype(np.float32)


@pytest.mark.parametrize("corners", [2, 3], ids=["line", "triangle"])
def test_even_weights_agree_with_numpy(driver, corners):
    """Inside, on edges and at corners, up to the widest angle and at any distances."""
    n = 20_000
    shares = RNG.dirichlet(np.full(corners, 0.7), n)
    shares[: n // 2, 0] = 0
    shares /= shares.sum(1, keepdims=True)
    shares[:corners] = np.eye(corners)
    angles = 10 ** RNG.uniform(-7, np.log10(1.75), (n, 1 if corners == 2 else 3))
    distances = 10 ** RNG.uniform(-12, 12, (n, corners))
    names = {2: ("line", "xy", "x"), 3: ("triangle", "xyz", "xyz")}
    shape, swizzle, of_angle = names[corners]
    text = "\n".join(
        [
            "#version 400 compatibility",
            snippet(f"tessellate/{shape}_weights"),
            "void main() {",
            f"vec{corners} b = evenWeights(gl_Vertex.{swizzle}, gl_MultiTexCoord0.{of_angle},",
            f"    gl_MultiTexCoord1.{swizzle});",
            f"gl_Position = vec4(b, {'0.0, 0.0' if corners == 2 else '0.0'});",
            "}",
        ]
    )
    given = [homogeneous(values) for values in (shares, angles, distances)]
    got = caught(driver, text, given[0], coordinates=given[1:])[:, :corners]
    shares, angles, distances = (
        values[:, :size].astype(float)
        for values, size in zip(given, (corners, angles.shape[1], corners), strict=True)
    )
    want = (
        line_weights(shares, angles[:, 0], distances)
        if corners == 2
        else triangle_weights(shares, angles, distances)
    )
    assert np.abs(got - want).max() < 1e-5
    assert (got[:corners] == np.eye(corners)).all()
    assert np.abs(got.sum(1) - 1).max() < 1e-6


def test_neighbours_find_the_same_weights_on_their_edge_bit_by_bit(driver):
    """Whatever the third corner is, and whichever way round the edge goes."""
    n = 20_000
    s = RNG.uniform(size=n).astype(np.float32)
    zero = np.zeros_like(s)
    angles = RNG.uniform(1e-4, 1.75, (n, 3))
    distances = 10 ** RNG.uniform(-6, 6, (n, 3))
    text = "\n".join(
        [
            "#version 400 compatibility",
            snippet("tessellate/triangle_weights"),
            "void main() {",
            "vec3 b = evenWeights(gl_Vertex.xyz, gl_MultiTexCoord0.xyz, gl_MultiTexCoord1.xyz);",
            "gl_Position = vec4(b, 0.0);",
            "}",
        ]
    )

    def weights(shares, angles, distances):
        given = [homogeneous(values) for values in (shares, angles, distances)]
        return caught(driver, text, given[0], coordinates=given[1:])[:, :3]

    one = weights(np.stack([1 - s, s, zero], -1), angles, distances)
    other_angles, other_distances = RNG.uniform(1e-4, 1.75, (n, 3)), 10 ** RNG.uniform(-6, 6, (n, 3))
    other_angles[:, 0], other_distances[:, 1:] = angles[:, 2], distances[:, 1::-1]
    other = weights(np.stack([zero, s, 1 - s], -1), other_angles, other_distances)
    assert (one[:, 0] == other[:, 2]).all()
    assert (one[:, 1] == other[:, 1]).all()
