"""The lens that the user's options ask for: a fisheye's, or the one that a screen of another shape takes."""

from __future__ import annotations

from domeshim.lens.landing import Lens
from domeshim.lens.models import lens_of
from domeshim.options import Options


def lens_chosen(options: Options) -> Lens:
    """The lens for the options, which were checked."""
    kind, numbers = options.surface
    if kind == "cylinder":
        from domeshim.lens.cylinder import Cylinder  # noqa: PLC0415 - only for such a screen

        angle, bottom, top = map(float, numbers)
        return Cylinder(angle, bottom, top)
    return lens_of(*options.lens, options.fov)
