"""Lenses of every model, for tests that hold for all of them."""

import numpy as np

from domeshim.lens.models import lens_of

BLENDER = (-1.1735143712967577e-05, -0.019988736953434998, -3.3525322965709175e-06, 3.099275275886036e-06)
BLENDER = (*BLENDER, -2.6064646454854524e-08)
"""What Blender itself begins with: its 50 mm lens."""
BLENDER_WIDE = (0.0, -5.79e-02, 0.0, 9.48e-05, -7.67e-06)
"""Nearly stereographic, 74 degrees at the edge of 36 mm."""
PAPER_LIKE = (0.62, 0.03, -0.012, 0.004, -0.0006)
OPENCV = (-0.02, 0.004, -0.003, 0.0005)


def measured(count=19, farthest=95.0):
    """A table as of an equisolid lens, its radii with three decimals."""
    angles = np.linspace(0, farthest, count)[1:]
    radii = np.round(np.sin(np.radians(angles) / 2) / np.sin(np.pi / 4), 3)
    return tuple(np.stack([angles, radii], -1).ravel().tolist())


def every_lens():
    """Each model, at narrow, common and wide fields of view."""
    return [
        lens_of(name, numbers, fov)
        for name, numbers, fovs in (
            ("equidistant", (), (60, 180, 220, 360)),
            ("equisolid", (), (60, 180, 300, 360)),
            ("stereographic", (), (60, 180, 300, 340, 359)),
            ("orthographic", (), (60, 150, 180)),
            ("polynomial", PAPER_LIKE, (100, 180, 240)),
            ("opencv", OPENCV, (100, 180)),
            ("opencv", (*OPENCV, 0.64), (180,)),
            ("blender", BLENDER, (30, 180)),
            ("blender", BLENDER_WIDE, (100, 140)),
            ("blender", (*BLENDER_WIDE, 44.0), (180,)),
            ("measured", measured(), (100, 190)),
            ("measured", measured(191), (180,)),
        )
        for fov in fovs
    ]
