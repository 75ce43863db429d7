"""Lines cut on the CPU, evenly in angle, into strips: for GL without the shaders, and lines that these spoil.

GL counts a stipple pattern along a strip and begins it anew with the next, so that the pieces of one line,
and lines that the program joined, must be one strip.
"""

from __future__ import annotations

import numpy as np

from domeshim.draw.patches import LINE_STRIP, Indices
from domeshim.draw.split import Floats, Limit, ahead_of_viewer, edges_of, makes_color
from domeshim.lens.weights import line_weights
from domeshim.record.runs import Block, Run

_MOST_PIECES = 1 << 14
"""Of one line: it may pass straight behind, where no number of even pieces would do."""


def line_strips(
    run: Run, lines: Indices, to_eye: Floats, limit: Limit, *, flat: bool, counting: bool = False
) -> Run:
    """Some lines of a run, each cut into even pieces within a limit.

    lines: (n, 2) indices of the run's vertices; one that begins where the one before ends goes on with its
    strip. to_eye: (4, 4), the run's space to eye space; flat: each line has its second end's colour;
    counting: the result has the attribute "pieces", of each line.
    """
    positions = _homogeneous(run.positions)
    lines = lines[np.isfinite(positions[lines]).all((1, 2))]
    whole = np.broadcast_to(np.eye(2), (len(lines), 2, 2))
    seen, _ = ahead_of_viewer(np.concatenate([positions[lines], whole], -1), np.arange(len(lines)), to_eye)
    seen, shown = seen[:, :, :4], seen[:, :, 4:]
    angles, limits, distances = edges_of(seen @ to_eye.T, limit)
    pieces = np.clip(np.ceil(angles / limits)[:, 0], 1, _MOST_PIECES).astype(int)
    entire = (shown == whole).all((1, 2))
    goes_on = (lines[1:, 0] == lines[:-1, 1]) & entire[1:] & entire[:-1]
    ends = np.append(~goes_on, True)[: len(lines)]
    counts = pieces + ends
    rows = np.repeat(np.arange(len(lines)), counts)
    steps = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    second = steps / pieces[rows]
    shares = np.stack([1 - second, second], -1)
    weights = (line_weights(shares, angles[rows, 0], distances[rows])[:, None] @ shown[rows])[:, 0]

    def blended(values: Floats, weights: Floats) -> Floats:
        mixed: Floats = np.einsum("ij,ijk->ik", weights, values[lines[rows]])
        return mixed

    last = np.stack([steps == 0, steps > 0], -1).astype(float)
    attributes = {
        name: blended(values, last if flat and makes_color(name) else weights).astype(np.float32)
        for name, values in run.attributes.items()
    }
    if counting:
        attributes["pieces"] = pieces[rows, None].astype(np.float32)
    stops = np.cumsum(counts)[ends].tolist()
    blocks = tuple(Block(LINE_STRIP, a, b) for a, b in zip([0, *stops], stops, strict=False))
    return Run(blended(positions, weights).astype(np.float32), attributes, blocks, constant=run.constant)


def _homogeneous(positions: Floats) -> Floats:
    """(n, 3 or 4) positions as (n, 4) in float64."""
    if positions.shape[1] == 3:
        positions = np.hstack([positions, np.ones((len(positions), 1), np.float32)])
    return positions.astype(float)
