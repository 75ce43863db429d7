"""glutSolid... and glutWire...: GLUT's shapes, drawn at the origin under the program's matrices.

They look as freeglut 3.4 draws them: size, place, normals, lines. Where a count is too small, nothing is
drawn, as there; nor for negative counts, at which freeglut would end the program. The tea set's outside is
clockwise, so glCullFace with GL's defaults shows its inside, as there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache

from domeshim.GLUT.arrays import draw_solid, draw_wire
from domeshim.GLUT.shapes import platonic, sponge, teapot
from domeshim.GLUT.shapes import round as turned
from domeshim.GLUT.shapes.mesh import Solid, Wire
from domeshim.GLUT.shapes.platonic import Faces
from domeshim.GLUT.shapes.rhombic import rhombic_dodecahedron_faces

__all__ = [
    "glutSolidCone",
    "glutSolidCube",
    "glutSolidCylinder",
    "glutSolidDodecahedron",
    "glutSolidIcosahedron",
    "glutSolidOctahedron",
    "glutSolidRhombicDodecahedron",
    "glutSolidSierpinskiSponge",
    "glutSolidSphere",
    "glutSolidTeacup",
    "glutSolidTeapot",
    "glutSolidTeaspoon",
    "glutSolidTetrahedron",
    "glutSolidTorus",
    "glutWireCone",
    "glutWireCube",
    "glutWireCylinder",
    "glutWireDodecahedron",
    "glutWireIcosahedron",
    "glutWireOctahedron",
    "glutWireRhombicDodecahedron",
    "glutWireSierpinskiSponge",
    "glutWireSphere",
    "glutWireTeacup",
    "glutWireTeapot",
    "glutWireTeaspoon",
    "glutWireTetrahedron",
    "glutWireTorus",
]


def glutSolidSphere(radius: float, slices: int, stacks: int, *_more: object) -> None:
    """Draw a ball with so many slices about the z axis and stacks along it."""
    _draw_solid(turned.sphere(float(radius), int(slices), int(stacks)))


def glutWireSphere(radius: float, slices: int, stacks: int, *_more: object) -> None:
    """Draw a ball's meridians and parallels."""
    _draw_wire(turned.wire_sphere(float(radius), int(slices), int(stacks)))


def glutSolidCone(base: float, height: float, slices: int, stacks: int, *_more: object) -> None:
    """Draw a cone from z = 0, with radius base, up to its tip at z = height."""
    _draw_solid(turned.cone(float(base), float(height), int(slices), int(stacks)))


def glutWireCone(base: float, height: float, slices: int, stacks: int, *_more: object) -> None:
    """Draw a cone's rings and the lines to its tip."""
    _draw_wire(turned.wire_cone(float(base), float(height), int(slices), int(stacks)))


def glutSolidCylinder(radius: float, height: float, slices: int, stacks: int, *_more: object) -> None:
    """Draw a closed tube from z = 0 to z = height."""
    _draw_solid(turned.cylinder(float(radius), float(height), int(slices), int(stacks)))


def glutWireCylinder(radius: float, height: float, slices: int, stacks: int, *_more: object) -> None:
    """Draw a tube's rings and the lines along it."""
    _draw_wire(turned.wire_cylinder(float(radius), float(height), int(slices), int(stacks)))


def glutSolidTorus(innerRadius: float, outerRadius: float, sides: int, rings: int, *_more: object) -> None:
    """Draw a ring about the z axis: a tube of radius innerRadius whose middle runs at outerRadius."""
    _draw_solid(turned.torus(float(innerRadius), float(outerRadius), int(sides), int(rings)))


def glutWireTorus(innerRadius: float, outerRadius: float, sides: int, rings: int, *_more: object) -> None:
    """Draw a ring's cross-sections and the circles along it."""
    _draw_wire(turned.wire_torus(float(innerRadius), float(outerRadius), int(sides), int(rings)))


def glutSolidCube(size: float, *_more: object) -> None:
    """Draw a cube with edges of this length."""
    _draw_solid(_solid_of(platonic.cube_faces, float(size)))


def glutWireCube(size: float, *_more: object) -> None:
    """Draw a cube's edges."""
    _draw_wire(_wire_of(platonic.cube_faces, float(size)))


def glutSolidTetrahedron(*_more: object) -> None:
    """Draw a tetrahedron with its corners on the unit sphere."""
    _draw_solid(_solid_of(platonic.tetrahedron_faces))


def glutWireTetrahedron(*_more: object) -> None:
    """Draw a tetrahedron's edges."""
    _draw_wire(_wire_of(platonic.tetrahedron_faces))


def glutSolidOctahedron(*_more: object) -> None:
    """Draw an octahedron with its corners on the unit sphere."""
    _draw_solid(_solid_of(platonic.octahedron_faces))


def glutWireOctahedron(*_more: object) -> None:
    """Draw an octahedron's edges."""
    _draw_wire(_wire_of(platonic.octahedron_faces))


def glutSolidDodecahedron(*_more: object) -> None:
    """Draw a dodecahedron with its corners at distance sqrt(3)."""
    _draw_solid(_solid_of(platonic.dodecahedron_faces))


def glutWireDodecahedron(*_more: object) -> None:
    """Draw a dodecahedron's edges."""
    _draw_wire(_wire_of(platonic.dodecahedron_faces))


def glutSolidIcosahedron(*_more: object) -> None:
    """Draw an icosahedron with its corners on the unit sphere."""
    _draw_solid(_solid_of(platonic.icosahedron_faces))


def glutWireIcosahedron(*_more: object) -> None:
    """Draw an icosahedron's edges."""
    _draw_wire(_wire_of(platonic.icosahedron_faces))


def glutSolidRhombicDodecahedron(*_more: object) -> None:
    """Draw a rhombic dodecahedron with tips at z = 1 and -1."""
    _draw_solid(_solid_of(rhombic_dodecahedron_faces))


def glutWireRhombicDodecahedron(*_more: object) -> None:
    """Draw a rhombic dodecahedron's edges."""
    _draw_wire(_wire_of(rhombic_dodecahedron_faces))


def glutSolidSierpinskiSponge(num_levels: int, offset: Sequence[float], scale: float, *_more: object) -> None:
    """Draw a Sierpinski sponge of so many levels about offset (x, y, z), its corners at distance scale."""
    _draw_solid(sponge.sponge(int(num_levels), _place(offset), float(scale)))


def glutWireSierpinskiSponge(num_levels: int, offset: Sequence[float], scale: float, *_more: object) -> None:
    """Draw a Sierpinski sponge's edges."""
    _draw_wire(sponge.wire_sponge(int(num_levels), _place(offset), float(scale)))


def glutSolidTeapot(size: float, *_more: object) -> None:
    """Draw the teapot, with texture coordinates."""
    _draw_solid(teapot.teapot(float(size)))


def glutWireTeapot(size: float, *_more: object) -> None:
    """Draw the teapot's patches as nets."""
    _draw_wire(teapot.wire_teapot(float(size)))


def glutSolidTeacup(size: float, *_more: object) -> None:
    """Draw the teacup with its saucer, with texture coordinates."""
    _draw_solid(teapot.teacup(float(size)))


def glutWireTeacup(size: float, *_more: object) -> None:
    """Draw the teacup's patches as nets."""
    _draw_wire(teapot.wire_teacup(float(size)))


def glutSolidTeaspoon(size: float, *_more: object) -> None:
    """Draw the teaspoon, with texture coordinates."""
    _draw_solid(teapot.teaspoon(float(size)))


def glutWireTeaspoon(size: float, *_more: object) -> None:
    """Draw the teaspoon's patches as nets."""
    _draw_wire(teapot.wire_teaspoon(float(size)))


def _draw_solid(solid: Solid | None) -> None:
    if solid is not None:
        draw_solid(solid)


def _draw_wire(wire: Wire | None) -> None:
    if wire is not None:
        draw_wire(wire)


@lru_cache(maxsize=64)
def _solid_of(faces: Callable[[], Faces], size: float = 1.0) -> Solid:
    return platonic.solid(faces()).scaled(size)


@lru_cache(maxsize=64)
def _wire_of(faces: Callable[[], Faces], size: float = 1.0) -> Wire:
    return platonic.wire(faces()).scaled(size)


def _place(offset: Sequence[float]) -> tuple[float, float, float]:
    x, y, z = offset
    return float(x), float(y), float(z)
