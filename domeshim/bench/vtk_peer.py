"""VTK's own way to a dome, vtkPanoramicProjectionPass, on the bench's meshes: a cube map, resampled.

Its time is against VTK's own monitor picture, in turns; its error is against the same truth. Needs vtk.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from domeshim.bench.colour_error import colour_rms, true_picture
from domeshim.bench.edge_error import FINE, EdgeError, summary, telling
from domeshim.bench.meshes import Mesh, of_lines
from domeshim.bench.results import Cost, Row, Seconds
from domeshim.bench.scenes import FAR, FOVY, NEAR, Scene
from domeshim.lens.models import lens_of

FAMILY = "VTK panoramic"
_WARM = 2


def installed() -> bool:
    """The package vtk is there."""
    return find_spec("vtk") is not None


def rows(scene: Scene, size: int, faces: Sequence[int], rounds: int, edges: int) -> Iterator[Row]:
    """A row for each size of the cube's faces; the dome is 180 degrees, equidistant."""
    lens = lens_of("equidistant", (), 180.0)
    true = true_picture(scene.look, lens, size) if scene.look is not None else None
    chosen = telling(scene.edges, lens, max(2, FINE // size) * size, edges)
    for face in faces:
        window = _Window(size, face)
        window.take(scene.meshes, lit=scene.lit)
        cost = window.cost(rounds)
        colour = colour_rms(window.picture(), true) if true is not None else None
        window.close()
        fine = _Window(max(2, FINE // size) * size, face)
        found = []
        for edge, curve in chosen:
            fine.take([of_lines(edge[None])])
            fine.show(dome=True)
            found.append(curve.deviations(fine.picture()[..., 0]))
        fine.close()
        error: EdgeError = summary(found, size)
        yield Row(scene.name, scene.title, size, FAMILY, str(face), cost, error, colour)


class _Window:
    """A window of VTK's, off screen, with the eye at the origin."""

    def __init__(self, size: int, face: int) -> None:
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # no screen is looked for
        import vtk  # noqa: PLC0415 - large, and rarely installed

        self._vtk: Any = vtk
        self._window = vtk.vtkRenderWindow()
        self._window.SetOffScreenRendering(1)
        self._window.SetMultiSamples(0)
        self._window.SetSize(size, size)
        self._renderer = vtk.vtkRenderer()
        self._renderer.SetBackground(0, 0, 0)
        self._renderer.GetCullers().RemoveAllItems()  # they leave out what the monitor's view does not show
        self._window.AddRenderer(self._renderer)
        self._pass = vtk.vtkPanoramicProjectionPass()
        self._pass.SetProjectionTypeToAzimuthal()
        self._pass.SetAngle(180)
        self._pass.SetCubeResolution(face)
        self._pass.InterpolateOn()
        self._pass.SetDelegatePass(vtk.vtkRenderStepsPass())

    def take(self, meshes: Sequence[Mesh], *, lit: bool = False) -> None:
        """Put these into the window in place of what was there."""
        self._renderer.RemoveAllViewProps()
        for mesh in meshes:
            self._renderer.AddActor(self._actor(mesh, lit=lit))
        camera = self._renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 0)
        camera.SetFocalPoint(0, 0, -1)
        camera.SetViewUp(0, 1, 0)
        camera.SetViewAngle(FOVY)
        camera.SetClippingRange(NEAR, FAR)

    def show(self, *, dome: bool) -> Seconds:
        """Draw a picture and wait until it is there."""
        wall, processor = time.perf_counter(), time.process_time()
        self._renderer.SetPass(self._pass if dome else None)
        self._window.Render()
        self._window.WaitForCompletion()
        return Seconds(time.perf_counter() - wall, time.process_time() - processor)

    def cost(self, rounds: int) -> Cost:
        """The dome's picture against the monitor's, in turns."""
        pairs = []
        for number in range(rounds + _WARM):
            monitor, dome = self.show(dome=False), self.show(dome=True)
            if number >= _WARM:
                pairs.append((dome, monitor))
        return Cost.of(pairs)

    def picture(self) -> NDArray[np.uint8]:
        """(size, size, 3), the top row first."""
        from vtk.util.numpy_support import vtk_to_numpy  # noqa: PLC0415 - as above

        width, height = self._window.GetSize()
        pixels = self._vtk.vtkUnsignedCharArray()
        self._window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
        return np.asarray(vtk_to_numpy(pixels).reshape(height, width, 3)[::-1], np.uint8)

    def close(self) -> None:
        """Let go of the window."""
        self._pass.ReleaseGraphicsResources(self._window)
        self._window.Finalize()

    def _actor(self, mesh: Mesh, *, lit: bool) -> Any:
        from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray  # noqa: PLC0415 - as above

        vtk = self._vtk
        data, points, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
        points.SetData(numpy_to_vtk(mesh.positions, deep=1))
        corners = mesh.corners.shape[1]
        offsets = np.arange(0, mesh.corners.size + 1, corners, dtype=np.int64)
        cells.SetData(
            numpy_to_vtkIdTypeArray(offsets, deep=1),
            numpy_to_vtkIdTypeArray(mesh.corners.ravel().astype(np.int64), deep=1),
        )
        data.SetPoints(points)
        (data.SetLines if corners == 2 else data.SetPolys)(cells)
        if mesh.normals is not None:
            data.GetPointData().SetNormals(numpy_to_vtk(mesh.normals, deep=1))
        if mesh.texcoords is not None:
            data.GetPointData().SetTCoords(numpy_to_vtk(mesh.texcoords, deep=1))
        mapper, actor = vtk.vtkPolyDataMapper(), vtk.vtkActor()
        mapper.SetInputData(data)
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*mesh.colour)
        actor.GetProperty().SetLighting(lit)
        if mesh.texture is not None:
            actor.SetTexture(self._texture(mesh.texture))
        return actor

    def _texture(self, texels: NDArray[np.uint8]) -> Any:
        from vtk.util.numpy_support import numpy_to_vtk  # noqa: PLC0415 - as above

        tall, wide = texels.shape[:2]
        image, texture = self._vtk.vtkImageData(), self._vtk.vtkTexture()
        image.SetDimensions(wide, tall, 1)
        image.GetPointData().SetScalars(numpy_to_vtk(texels.reshape(-1, 3), deep=1))
        texture.SetInputData(image)
        texture.InterpolateOn()
        return texture
