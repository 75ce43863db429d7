"""The shaders' weights even in angle against their numpy twins."""

import numpy as np
import pytest

from domeshim.lens.weights import line_weights, quad_weights, triangle_weights
from domeshim.shading.snippets import snippet
from tests.shading.feedback import caught

RNG = np.random.default_rng(2006)


def homogeneous(values):
    """(n, 2 or 3) -> (n, 4) float32, ones where there is nothing."""
    return np.hstack([values, np.ones((len(values), 4 - values.shape[1]))]).astype(np.float32)


def weights(driver, corners, shares, angles, distances):
    """(n, corners) of the shader, from float32 arrays: (n, 2 or 3), (n, 1, 3 or 4), (n, corners)."""
    needed, called = {
        2: ([], "evenOnEdge(gl_Vertex.xy, gl_MultiTexCoord0.x, gl_MultiTexCoord1.xy), 0.0, 0.0"),
        3: (["triangle"], "evenWeights(gl_Vertex.xyz, gl_MultiTexCoord0.xyz, gl_MultiTexCoord1.xyz), 0.0"),
        4: (["quad"], "evenWeights(gl_Vertex.xy, gl_MultiTexCoord0, gl_MultiTexCoord1)"),
    }[corners]
    text = "\n".join(
        [
            "#version 400 compatibility",
            snippet("tessellate/edge_weights"),
            *(snippet(f"tessellate/{shape}_weights") for shape in needed),
            "void main() {",
            f"gl_Position = vec4({called});",
            "}",
        ]
    )
    given = [homogeneous(values) for values in (shares, angles, distances)]
    return caught(driver, text, given[0], coordinates=given[1:])[:, :corners]


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
    shares, angles, distances = (np.float32(values) for values in (shares, angles, distances))
    got = weights(driver, corners, shares, angles, distances)
    shares, angles, distances = (values.astype(float) for values in (shares, angles, distances))
    want = (
        line_weights(shares, angles[:, 0], distances)
        if corners == 2
        else triangle_weights(shares, angles, distances)
    )
    assert np.abs(got - want).max() < 1e-5
    assert (got[:corners] == np.eye(corners)).all()
    assert np.abs(got.sum(1) - 1).max() < 1e-6


def test_a_parallelograms_weights_agree_with_numpy(driver):
    """Inside, on edges and at corners, up to the widest angle and at any distances."""
    n = 20_000
    shares = RNG.uniform(size=(n, 2))
    side = np.arange(n // 2)
    shares[side, side % 2] = side // 2 % 2
    shares[:4] = [[0, 0], [1, 0], [1, 1], [0, 1]]
    angles = 10 ** RNG.uniform(-7, np.log10(1.75), (n, 4))
    distances = 10 ** RNG.uniform(-12, 12, (n, 4))
    given = [np.float32(values) for values in (shares, angles, distances)]
    got = weights(driver, 4, *given)
    assert np.abs(got - quad_weights(*(values.astype(float) for values in given))).max() < 1e-5
    assert (got[:4] == np.eye(4)).all()
    assert np.abs(got.sum(1) - 1).max() < 1e-6


def test_neighbours_find_the_same_weights_on_their_edge_bit_by_bit(driver):
    """Lines, triangles and quads, whatever their other corners are, and whichever way round the edge goes."""
    n = 20_000
    s = (RNG.integers(1, 2**16, n) / 2**16).astype(np.float32)  # 1 - s is exact, as the tessellator's are
    angle = np.float32(RNG.uniform(1e-4, 1.75, n))
    ends = np.float32(10 ** RNG.uniform(-6, 6, (n, 2)))
    want = weights(driver, 2, np.stack([1 - s, s], -1), angle[:, None], ends)
    for first in range(3):
        for a, b in ((first, (first + 1) % 3), ((first + 1) % 3, first)):
            shares = np.zeros((n, 3))
            shares[:, a], shares[:, b] = 1 - s, s
            angles, distances = RNG.uniform(1e-4, 1.75, (n, 3)), 10 ** RNG.uniform(-6, 6, (n, 3))
            angles[:, 3 - a - b] = angle
            distances[:, [a, b]] = ends
            assert (weights(driver, 3, shares, angles, distances)[:, [a, b]] == want).all()
    for side, (a, b) in enumerate(((0, 1), (1, 2), (3, 2), (0, 3))):
        for share, (c, d) in ((s, (a, b)), (1 - s, (b, a))):
            shares = np.full((n, 2), 1.0 if side in (1, 2) else 0.0)
            shares[:, side % 2] = share
            angles, distances = RNG.uniform(1e-4, 1.75, (n, 4)), 10 ** RNG.uniform(-6, 6, (n, 4))
            angles[:, side] = angle
            distances[:, [c, d]] = ends
            assert (weights(driver, 4, shares, angles, distances)[:, [c, d]] == want).all()
