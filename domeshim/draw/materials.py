"""Materials that change between the vertices of one primitive: they travel as texture coordinates."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from domeshim.record.attributes import MATERIAL_PARTS
from domeshim.record.runs import Run
from domeshim.shading.recipe import MATERIAL_UNITS, Face


def material_run(run: Run) -> tuple[Run, Face, bool]:
    """The run with one whole material a vertex, the face that it is for, and whether that says all.

    It does not where the two faces are given unlike materials; the front's is taken for both then.
    """
    sides = [
        side for side in ("front", "back") if any(name.startswith(side + " ") for name in run.attributes)
    ]
    side = sides[0]
    unset = np.full((len(run.positions), 4), np.nan, np.float32)
    units = [f"texture{unit}" for unit in MATERIAL_UNITS.values()]
    attributes = {k: v for k, v in run.attributes.items() if " " not in k and k not in units}
    attributes |= {f"{side} {part}": run.attributes.get(f"{side} {part}", unset) for part in MATERIAL_PARTS}
    if len(sides) == 1:
        return replace(run, attributes=attributes), "front" if side == "front" else "back", True
    alike = all(
        np.array_equal(
            run.attributes.get(f"front {part}", unset),
            run.attributes.get(f"back {part}", unset),
            equal_nan=True,
        )
        for part in MATERIAL_PARTS
    )
    return replace(run, attributes=attributes), "both", alike
