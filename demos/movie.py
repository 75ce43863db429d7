"""A film on a large screen before the viewer, in a hall that its light falls into.

    python movie.py [FILE] [--start SECONDS]

FILE is anything that PyAV reads. Without one the demo makes a short clip of its own, once, and keeps it in
the user's cache folder. A thread decodes; the picture goes through a pixel buffer into the screen's texture.
The film keeps its own time: what comes too late is dropped.

Keys: space pauses, r starts anew, w and x or the mouse wheel move nearer and back, t text; drag or arrows to
look around; h shows all of them; ESC quits.
"""

import argparse
import math
import os
import queue
import sys
import threading
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np
from masonry import box, compiled, plane
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
from paint import between, fractal, kept, texture
from stage import Stage

try:
    import av
except ImportError:
    sys.exit("movie.py reads films with PyAV: pip install av")

AHEAD = 6
"""Decoded pictures that wait for their time."""
LATE = 0.1
"""Seconds by which a picture may be late before it is dropped unseen."""
WIDE, FAR, MIDDLE = 11.6, 5.5, 1.7
"""The screen's width, its distance, and its middle's height over the eye, metres."""
FLOOR, CEILING, SIDE, BACK = -1.8, 6.4, 8.0, 9.0
CLIP = "film-1.mp4"
CLIP_SIZE, CLIP_RATE, CLIP_SECONDS = (1280, 720), 30, 6


def clip_pictures():
    """The demo's own clip, picture by picture, (height, width, 3): coloured inks that stir."""
    width, tall = CLIP_SIZE[0] // 2, CLIP_SIZE[1] // 2
    y, x = np.mgrid[-1 : 1 : tall * 1j, -1.78 : 1.78 : width * 1j].astype("f")
    for number in range(CLIP_RATE * CLIP_SECONDS):
        turn = 2 * math.pi * number / (CLIP_RATE * CLIP_SECONDS)
        u, v = x.copy(), y.copy()
        for scale in (1.3, 2.3, 4.1, 7.0, 11.0):
            u, v = (
                u + 0.9 / scale * np.sin(scale * v + 1.7 * scale + math.sin(turn) + turn),
                v + 0.9 / scale * np.cos(scale * u + 0.9 * scale + math.cos(turn) - turn),
            )
        colours = np.stack([0.5 + 0.5 * np.sin(1.6 * u + phase + 0.8 * v) for phase in (0.2, 1.3, 2.2)], -1)
        colours *= (0.45 + 0.55 * np.cos(2.2 * v - u)[..., None] ** 2) * 255.0
        yield clock(colours, x, y, turn).astype(np.uint8)


def clock(colours: np.ndarray, x: np.ndarray, y: np.ndarray, turn: float) -> np.ndarray:
    """A film leader's hand in the corner, once around in the clip: it shows that time is kept."""
    off, angle = np.hypot(x - 1.45, y + 0.68), np.arctan2(x - 1.45, -(y + 0.68)) % (2 * math.pi)
    ring = np.clip(1.5 - abs(off - 0.2) * 90.0, 0.0, 1.0)
    swept = np.clip((0.185 - off) * 90.0, 0.0, 1.0) * np.where(angle < turn, 0.65, 0.12)
    share = np.maximum(ring, swept)[..., None]
    return colours * (1.0 - share) + 255.0 * share


def made_clip() -> Path:
    """The clip's file, from the cache folder or made and put there."""
    file = kept(CLIP)
    if file.exists():
        return file
    print("Making a short film ...", flush=True)
    file.parent.mkdir(parents=True, exist_ok=True)
    unfinished = file.with_name(f"{os.getpid()}.mp4")
    with av.open(str(unfinished), "w") as film:
        codec = "libx264" if "libx264" in av.codecs_available else "mpeg4"
        stream = film.add_stream(codec, CLIP_RATE)
        stream.width, stream.height = CLIP_SIZE
        stream.pix_fmt, stream.bit_rate = "yuv420p", 6_000_000
        for pixels in clip_pictures():
            picture = av.VideoFrame.from_ndarray(pixels, "rgb24").reformat(*CLIP_SIZE, "yuv420p")
            film.mux(stream.encode(picture))
        film.mux(stream.encode())
    unfinished.replace(file)
    return file


@dataclass(frozen=True)
class Shown:
    """A picture that waits for its time: seconds since the film's start, loops counted on; BGRA rows."""

    when: float
    pixels: np.ndarray


class Film:
    """Decodes a file in a thread of its own, again and again, a few pictures ahead of the clock."""

    def __init__(self, path: Path, start: float) -> None:
        with av.open(str(path)) as film:
            if not film.streams.video:
                raise ValueError("there is no picture in it")
            video = film.streams.video[0]
            self.size = video.codec_context.width, video.codec_context.height
            self.rate = float(video.average_rate or Fraction(25))
        self.path, self.clock, self.dropped = path, start, 0
        self.waiting: queue.Queue[Shown] = queue.Queue(AHEAD)
        threading.Thread(target=self.decode, args=(start,), daemon=True).start()
        self.next: Shown | None = self.waiting.get(timeout=20.0)

    def decode(self, start: float) -> None:
        begun = 0.0  # when this round of the film began
        while True:
            end = begun
            with av.open(str(self.path)) as film:
                film.streams.video[0].thread_type = "AUTO"
                for picture in film.decode(video=0):
                    when = begun + (picture.time or 0.0)
                    end = when + 1.0 / self.rate
                    if when < start:
                        continue
                    if when < self.clock - LATE:  # do not even change its colours
                        self.dropped += 1
                        continue
                    self.waiting.put(Shown(when, picture.to_ndarray(format="bgra")))
            begun = end

    def picture(self, now: float) -> np.ndarray | None:
        """The last picture whose time has come; None if it is on the screen already. Others are dropped."""
        self.clock = now
        due = None
        while self.next is not None and self.next.when <= now:
            self.dropped += due is not None
            due, self.next = self.next.pixels, self.take()
        if self.next is None:
            self.next = self.take()
        return due

    def take(self) -> Shown | None:
        try:
            return self.waiting.get_nowait()
        except queue.Empty:
            return None


class Screen:
    """A texture that pixel buffers fill: while GL takes one, the next picture goes into the other."""

    def __init__(self, size: tuple[int, int]) -> None:
        self.size, self.turn = size, 0
        self.texture, self.buffers = glGenTextures(1), glGenBuffers(2)
        glBindTexture(GL_TEXTURE_2D, self.texture)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, *size, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, None)
        for name in (GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER):
            glTexParameteri(GL_TEXTURE_2D, name, GL_LINEAR)
        for name in (GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T):
            glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE)

    def show(self, pixels: np.ndarray) -> None:
        self.turn = 1 - self.turn
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, self.buffers[self.turn])
        glBufferData(GL_PIXEL_UNPACK_BUFFER, pixels.nbytes, pixels, GL_STREAM_DRAW)
        glBindTexture(GL_TEXTURE_2D, self.texture)
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, *self.size, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, GLvoidp(0))
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0)


class Movie(Stage):
    """The hall, the screen in it, and the clock that both go by."""

    title = "Film"
    fovy, near, far = 88.0, 0.1, 60.0

    def __init__(self, film: Film) -> None:
        super().__init__()
        self.film, self.begun = film, film.clock
        self.pitch, self.nearer = 8.0, 0.0
        self.light = np.ones(3)
        self.shown, self.text = 0, True
        self.keys = {
            "w": ("nearer", lambda: self.wheel(True)),
            "x": ("back", lambda: self.wheel(False)),
            "t": ("text", lambda: setattr(self, "text", not self.text)),
            **self.keys,
        }

    def set_up(self) -> None:
        glClearColor(0.0, 0.0, 0.0, 1.0)
        glEnable(GL_DEPTH_TEST)
        self.screen = Screen(self.film.size)
        self.half = WIDE / 2.0, WIDE / 2.0 * self.film.size[1] / self.film.size[0]
        cloth = cloth_texture()
        self.hall = compiled(lambda: draw_hall(cloth))

    def draw(self) -> None:
        pixels = self.film.picture(self.begun + self.seconds)
        if pixels is not None:
            self.screen.show(pixels)
            self.shown += 1
            self.light = 0.8 + 4.5 * pixels[::16, ::16, 2::-1].mean((0, 1)) / 255.0
        self.look()
        glTranslatef(0.0, 0.0, self.nearer)
        self.draw_screen()  # first: what it hides need not be drawn
        self.draw_light()
        glCallList(self.hall)
        glDisable(GL_LIGHTING)

    def draw_light(self) -> None:
        """The screen lights the hall as a lamp at its middle, in the colour of its picture."""
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (0.16, 0.13, 0.12, 1.0))
        glLightfv(GL_LIGHT0, GL_POSITION, (0.0, MIDDLE, -FAR + 1.2, 1.0))
        glLightfv(GL_LIGHT0, GL_DIFFUSE, (*self.light, 1.0))
        glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.12)
        glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.012)
        glEnable(GL_COLOR_MATERIAL)

    def draw_screen(self) -> None:
        glEnable(GL_TEXTURE_2D)
        glBindTexture(GL_TEXTURE_2D, self.screen.texture)
        glColor3f(1.0, 1.0, 1.0)
        across, up = self.half
        glBegin(GL_QUADS)
        for s, t in ((0, 1), (1, 1), (1, 0), (0, 0)):
            glTexCoord2f(s, t)
            glVertex3f((2 * s - 1) * across, MIDDLE + (1 - 2 * t) * up, -FAR)
        glEnd()
        glDisable(GL_TEXTURE_2D)

    def write_over(self) -> None:
        if self.text:
            super().write_over()

    def status(self) -> list[str]:
        size = "x".join(map(str, self.film.size))
        rate = self.shown / self.seconds if self.seconds > 1.0 else 0.0
        counted = f"{rate:.1f} shown a second, {self.film.dropped} dropped" if rate else "starting"
        return [
            f"{self.film.path.name}: {size}, {self.film.rate:g} pictures a second; {counted}",
            *super().status(),
        ]

    def wheel(self, up: bool) -> None:
        self.nearer = max(-4.0, min(3.5, self.nearer + (0.2 if up else -0.2)))


def cloth_texture() -> int:
    """Woven cloth, grey, for walls, floor and seats."""
    rows, columns = np.mgrid[0:128, 0:128] / 128.0
    rough = fractal(np.stack([rows, columns], -1) * 8, 4, 2, period=8)
    weave = 0.75 + 0.1 * np.sin(columns * 64 * math.pi) + 0.2 * rough
    return texture(np.repeat(weave[..., None], 3, -1))


def draw_hall(cloth: int) -> None:
    """Walls with pillars, a ceiling with lamps, rows of seats; it is lit at its corners."""
    glEnable(GL_TEXTURE_2D)
    glBindTexture(GL_TEXTURE_2D, cloth)
    glColor3f(0.36, 0.10, 0.10)
    plane((-SIDE, FLOOR, BACK), (2 * SIDE, 0, 0), (0, 0, -FAR - BACK))
    glColor3f(0.26, 0.25, 0.36)
    plane((-SIDE, CEILING, -FAR), (2 * SIDE, 0, 0), (0, 0, FAR + BACK))
    glColor3f(0.46, 0.17, 0.17)
    tall = CEILING - FLOOR
    plane((-SIDE, FLOOR, BACK), (0, 0, -FAR - BACK), (0, tall, 0))
    plane((SIDE, FLOOR, -FAR), (0, 0, FAR + BACK), (0, tall, 0))
    plane((SIDE, FLOOR, BACK), (-2 * SIDE, 0, 0), (0, tall, 0))
    glColor3f(0.05, 0.05, 0.06)
    plane((-SIDE, FLOOR, -FAR - 0.3), (2 * SIDE, 0, 0), (0, tall, 0))
    glColor3f(0.75, 0.60, 0.38)
    for z in np.arange(-FAR + 1.2, BACK, 2.4):
        for side in (-1, 1):
            box((side * (SIDE - 0.15), FLOOR, z), (0.5, tall, 0.5))
    for row, z in enumerate(np.arange(-2.6, BACK, 1.3)):
        for x in np.arange(-SIDE + 1.4 + 0.35 * (row % 2), SIDE - 1.2, 0.75):
            if abs(x) > 0.65:  # the gangway, where the viewer sits
                glColor3f(0.62, 0.13, 0.16)
                box((x, FLOOR, z), (0.6, 0.45, 0.55))
                box((x, FLOOR + 0.42, z + 0.22), (0.6, 0.55, 0.14))
    glDisable(GL_TEXTURE_2D)
    glDisable(GL_LIGHTING)
    for x, z in np.stack(np.meshgrid(np.linspace(-6, 6, 7), np.linspace(-4, 8, 7)), -1).reshape(-1, 2):
        glColor3f(*between(0.5 + 0.5 * math.sin(3 * x + z), ((1.0, 0.72, 0.4), (1.0, 0.9, 0.7))) * 0.8)
        glBegin(GL_TRIANGLE_FAN)
        for turn in np.arange(12) * math.pi / 6:
            glVertex3f(x + 0.09 * math.cos(turn), CEILING - 0.02, z + 0.09 * math.sin(turn))
        glEnd()


def main() -> None:
    parser = argparse.ArgumentParser(description="A film on a large screen.")
    parser.add_argument("file", nargs="?", type=Path, help="any film; without one, the demo's own")
    parser.add_argument("--start", type=float, default=0.0, metavar="SECONDS", help="where to begin")
    given = parser.parse_args()
    try:
        film = Film(given.file or made_clip(), given.start)
    except (OSError, ValueError) as error:  # av's own errors are both
        parser.error(f"cannot show {given.file}: {getattr(error, 'strerror', None) or error}")
    except queue.Empty:
        parser.error(f"--start={given.start:g}: no picture came from there")
    Movie(film).run()


if __name__ == "__main__":
    main()
