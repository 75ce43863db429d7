"""A program's own GLSL programs in one GL context: which is bound, and what it needs to end on the dome."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import c_float
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from domeshim.driver import Driver
from domeshim.lens.detail import cone
from domeshim.lens.landing import Lens
from domeshim.lens.orientation import Orientation
from domeshim.options import Options
from domeshim.state.clip_planes import LEGACY_PLANES, NOTHING, PARTS, Equation
from domeshim.state.perspective import Matrix, is_perspective, perspective_within, planar
from domeshim.state.placement import Placement
from domeshim.state.scene import GL_CLIP_PLANE0
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    from domeshim.draw.patches import Edged
    from domeshim.shading.exchange import OwnProgram
    from domeshim.shading.fragments import FragmentStage
    from domeshim.shading.own import Landing
    from domeshim.shading.program import Uniforms
    from domeshim.state.subdivision import Tolerance
    from domeshim.state.whereabouts import Seen

_CURRENT_PROGRAM = 0x8B8D


class Cut(NamedTuple):
    """What is on while a program of the program's own draws, so that it ends where the dome does."""

    enables: tuple[int, ...] = ()
    planes: tuple[tuple[int, Equation], ...] = ()
    """What GL's clip planes hold meanwhile, by number."""


class OwnPrograms:
    """Links, remembers and dresses the program's own GLSL programs."""

    def __init__(
        self,
        driver: Driver,
        options: Options,
        lens: Lens,
        orientation: Orientation,
        frame: Frame,
    ) -> None:
        self._driver = driver
        self._lens = lens
        self._orientation = orientation.turned_only if options.cubemap else orientation
        self._frame = frame
        self._face = options.cubemap
        self._beside = options.stereo != "off"
        self._near_behind = lens.singular and (options.fov > 180 or orientation.off_centre)
        self._programs: dict[int, OwnProgram] = {}
        self._stages: dict[int, FragmentStage] = {}
        self._last: tuple[Placement, Matrix, tuple[float, ...]] | None = None
        self.complaints: dict[int, str] = {}
        """Why a linked program is not on the dome, by its name."""
        self.current: OwnProgram | None = None
        """The one that is bound and ends on the dome by itself."""
        self.fragments: FragmentStage | None = None
        """The one that is bound, of fragment shaders alone."""

    @cached_property
    def _landing(self) -> Landing:
        from domeshim.shading.own import Landing  # noqa: PLC0415 - only a program with GLSL of its own pays

        return Landing(
            self._lens.snippets,
            self._orientation.aim,
            clip=self._lens.clip(exact=False),
            face=self._face,
            beside=self._beside,
            keystone=self._frame.keystone is not None,
            grid=self._frame.on_grid and not self._face,
            legacy=self._driver.legacy,
        )

    def link(self, name: int, original: Callable[[], object]) -> None:
        """Link a program with its positions ending on the dome; original: the program's own call."""
        from domeshim.shading.exchange import link  # noqa: PLC0415 - as above
        from domeshim.shading.fragments import FragmentStage  # noqa: PLC0415

        linked = link(self._driver, name, self._landing, original)
        if self.fragments is not None and self.fragments.name == name:
            self.fragments = None
        self.forget(name)
        if linked.program is not None:
            self._programs[name] = linked.program
        elif linked.fragments:
            self._add_stage(FragmentStage(self._driver, name, linked.fragments))
        elif linked.complaint is not None:
            self.complaints[name] = linked.complaint
        if self._driver.integer(_CURRENT_PROGRAM) == name:
            self.use(name)

    def use(self, name: int) -> None:
        """This program is bound from now on; 0: none."""
        self.current = self._programs.get(name)
        self.fragments = self._stages.get(name)

    @property
    def source(self) -> OwnProgram | None:
        """The program whose uniforms have the projection; None where GL's own matrix is it."""
        return self.current if self.current is not None and self.current.own_matrices else None

    def named(self, name: int) -> OwnProgram | None:
        """The program of this name if it ends on the dome by itself."""
        return self._programs.get(name)

    def subdivides_by(self, name: int) -> bool:
        """The program of this name draws in the place of one of the program's own."""
        return any(own.subdivided.has(name) for own in self._programs.values())

    def forget(self, name: int) -> None:
        """The program is deleted or linked anew."""
        gone = self._programs.pop(name, None)
        if gone is not None:
            gone.subdivided.delete()
        self.complaints.pop(name, None)
        stage = self._stages.get(name)
        if stage is not None and stage is not self.fragments:
            self._stages.pop(name).delete()

    def _add_stage(self, stage: FragmentStage) -> None:
        if stage.unknown is None:
            self._stages[stage.name] = stage
        else:
            self.complaints[stage.name] = f"its uniform {stage.unknown} cannot be handed over"
            stage.delete()

    def matrix_sent(self, location: int, aspect: float) -> Matrix | None:
        """A uniform of the bound program has got a matrix: the perspective in it, if that is news.

        aspect: the window's width over its height.
        """
        own = self.source
        if own is None:
            return None
        values = (c_float * 16)()
        self._driver.glGetUniformfv(own.name, location, values)
        matrix = np.array(values, float).reshape(4, 4).T
        if not is_perspective(matrix):
            return None
        used = self._perspectives(own)
        p = perspective_within(matrix, aspect, used)
        if p is None and used:
            p = used[0]
        if p is None or p is own.perspective:
            return None
        own.perspective = p
        return p

    def _perspectives(self, first: OwnProgram) -> list[Matrix]:
        """Those last seen in the programs' uniforms, each once though programs share it."""
        found = (each.perspective for each in (first, *self._programs.values()))
        return list({id(p): p for p in found if p is not None}.values())

    def projection(self, of_gl: Matrix) -> Matrix:
        """The projection that the bound program draws by; of_gl: GL's own."""
        own = self.source
        if own is None:
            return of_gl
        return own.perspective if own.perspective is not None else np.eye(4)

    # Around its draws.

    def cut(self, seen: Seen, planes: tuple[int, ...]) -> Cut:
        """What has to be on for the bound program to end where its draw belongs.

        planes: the clip planes that the program has enabled.
        """
        from domeshim.shading.own import EDGE_DISTANCES, RIM_DISTANCE  # noqa: PLC0415 - as above

        own, panel = self.current, seen.placement.place == "panel"
        assert own is not None
        if not own.cut:
            return Cut()
        if self._driver.legacy:
            free = [number for number in range(LEGACY_PLANES) if number not in planes]
            used = tuple(zip(free, PARTS if panel else PARTS[:1], strict=False))
            idle = ((number, NOTHING) for number in planes)
            return Cut(tuple(GL_CLIP_PLANE0 + number for number, _ in used), (*used, *idle))
        inner = (0, 1, 2, 3) if panel else seen.edges.inner
        wanted = (*(() if panel else (RIM_DISTANCE,)), *(EDGE_DISTANCES[i] for i in inner))
        return Cut(tuple(GL_CLIP_PLANE0 + i for i in wanted if i not in planes))

    def bend(self, program: Uniforms, seen: Seen, tolerance: Tolerance | None = None) -> None:
        """Let a program that is bound end where its draw belongs: the program's own, or one in its place.

        tolerance: what one that subdivides goes by.
        """
        placement, face = seen.placement, self._face
        panel = placement.place == "panel"
        program.set("domeMode", (2.0 if panel else 1.0,))
        program.set("domeFromClip", placement.view if panel else self._from_clip(placement, seen.projection))
        program.set("domeDepth", planar(placement.depth) if face else placement.depth)
        if not face:
            program.set("domeLens", self._lens.uniform)
        for uniform, values in self._orientation.uniforms:
            program.set(uniform, values)
        for uniform, values in self._frame.uniforms:
            program.set(uniform, values)
        left_out = self._lens.left_out(np.inf) if tolerance is None else tolerance.left_out
        program.set("domeRim", cone(left_out))
        program.set("domeEdges", seen.edges.bounds)
        program.set("domeWindow", seen.viewport)
        if tolerance is not None:
            program.set("domeDetail", (tolerance.detail,))
            program.set("domeWidest", (tolerance.widest,))
            program.set("domeAft", (*tolerance.aft, tolerance.least))

    def subdividing(self, kind: Edged) -> Uniforms | None:
        """What draws such primitives in the bound program's place, subdivided; None where nothing can."""
        from domeshim.shading.own_pieces import Judging  # noqa: PLC0415 - only what is subdivided pays

        own = self.current
        if own is None or not own.cut or self._face:
            return None
        landing = replace(self._landing, clip=self._lens.clip(exact=True))
        return own.subdivided.program(kind, landing, Judging(self._near_behind))

    @property
    def hands_over(self) -> bool:
        """Some program's uniforms are handed over to others, that draw in its place."""
        return bool(self._stages) or any(own.subdivided.made for own in self._programs.values())

    def uniforms_changed(self) -> None:
        """Any uniform of any program may have another value."""
        for own in self._programs.values():
            own.subdivided.uniforms_changed()
        for stage in self._stages.values():
            stage.uniforms_changed()

    def _from_clip(self, placement: Placement, projection: Matrix) -> tuple[float, ...]:
        """Clip coordinates to the dome's eye space, column-major; worked out once for each placement."""
        if self._last is None or self._last[0] is not placement or self._last[1] is not projection:
            from_clip = np.array(placement.view).reshape(4, 4).T @ np.linalg.pinv(projection)
            self._last = placement, projection, tuple(from_clip.T.ravel().tolist())
        return self._last[2]

    def leave_straight(self) -> None:
        """Let the bound program, if any is on the dome, draw as on the monitor."""
        if self.current is not None:
            self.current.set("domeMode", (0.0,))
