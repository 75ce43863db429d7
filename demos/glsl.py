"""An ocean at sunset, by the program's own GLSL 1.20: waves in a vertex shader, sky and glitter in another.

    python glsl.py [--hour SECONDS]

The mesh is a disc around the eye whose rings grow with distance. The vertex shader lifts it by seven waves
and ends, as such programs do, in gl_ModelViewProjectionMatrix; the sky ends in ftransform().

Keys: + and - a rougher or calmer sea, p the rings of the mesh, space pauses; drag or arrows to look around; h
shows all of them; ESC quits.
"""

import argparse
import math

import numpy as np
from OpenGL.GL import *
from OpenGL.GL.shaders import ShaderCompilationError, compileProgram, compileShader
from OpenGL.GLU import *
from OpenGL.GLUT import *
from paint import fractal, texture
from stage import Stage

RINGS, SPOKES = 170, 180
NEAREST, FARTHEST = 0.15, 900.0
"""Metres to the mesh's first and last ring."""
SKY = 800.0
SUN = (0.26, 0.085, -0.96)
"""Where the Sun stands; of length one, nearly."""
WAVES = (
    # direction in degrees, length and height in metres
    (10.0, 31.0, 0.50), (-25.0, 19.0, 0.30), (40.0, 11.0, 0.17), (-55.0, 6.7, 0.10), (75.0, 4.1, 0.055),
    (-5.0, 2.6, 0.036), (25.0, 1.7, 0.022),
)  # fmt: skip

EVENING = """#version 120
// The evening sky's colour in a direction; clouds: a tile of noise.
uniform sampler2D clouds;
uniform vec3 sun;
uniform float time;
vec3 evening(vec3 towards, bool clouded) {
    float up = max(towards.y, 0.0);
    float along = max(dot(towards, sun), 0.0);
    vec3 low = mix(vec3(0.52, 0.30, 0.36), vec3(1.00, 0.52, 0.20), along * along);
    vec3 high = mix(vec3(0.20, 0.26, 0.48), vec3(0.42, 0.36, 0.50), along);
    vec3 colour = mix(low, high, smoothstep(0.0, 0.32, up));
    colour = mix(colour, vec3(0.05, 0.09, 0.24), smoothstep(0.22, 0.95, up));
    if (clouded) {
        vec2 at = towards.xz / (up + 0.22);
        float thick = texture2D(clouds, at * 0.11 + vec2(0.002, 0.001) * time).r;
        thick += 0.45 * texture2D(clouds, at * 0.37 - vec2(0.003, 0.0) * time).r;
        float cover = smoothstep(0.70, 1.05, thick) * smoothstep(0.0, 0.10, up);
        vec3 lit = mix(vec3(0.42, 0.27, 0.36), vec3(1.0, 0.62, 0.38), pow(along, 1.5) + 0.25 * (1.0 - up));
        colour = mix(colour, lit, 0.8 * cover);
    }
    colour += vec3(1.0, 0.55, 0.25) * 0.55 * pow(along, 24.0);
    return colour + vec3(1.0, 0.85, 0.6) * 3.0 * smoothstep(0.9990, 0.9995, along);
}
"""
SKY_VERTEX = """#version 120
varying vec3 towards;
void main() {
    towards = gl_Vertex.xyz;
    gl_Position = ftransform();
}
"""
SKY_FRAGMENT = (
    EVENING
    + """
varying vec3 towards;
void main() {
    gl_FragColor = vec4(evening(normalize(towards), true), 1.0);
}
"""
)
SEA_VERTEX = """#version 120
uniform vec4 waves[COUNT]; // direction, wave number, height
uniform float time, rough, eye;
varying vec3 place;
varying vec3 up;
void main() {
    vec3 at = gl_Vertex.xyz;
    float away = length(at.xz);
    vec2 slope = vec2(0.0);
    for (int i = 0; i < COUNT; ++i) {
        vec2 along = waves[i].xy;
        float k = waves[i].z;
        // Waves too short for the mesh's rings out there are left out.
        float height = rough * waves[i].w * (1.0 - smoothstep(0.25, 0.9, away * GROWTH * k));
        float phase = k * dot(along, gl_Vertex.xz) - sqrt(9.81 * k) * time;
        at.y += height * sin(phase);
        at.xz += 0.6 * height * along * cos(phase);
        slope += height * k * along * cos(phase);
    }
    place = at - vec3(0.0, eye, 0.0);
    up = vec3(-slope.x, 1.0, -slope.y);
    gl_Position = gl_ModelViewProjectionMatrix * vec4(at, 1.0);
}
"""
SEA_FRAGMENT = (
    EVENING
    + """
uniform float rough;
varying vec3 place;
varying vec3 up;
void main() {
    vec3 view = normalize(place);
    float away = length(place);
    vec2 at = place.xz * 0.13;
    vec2 ripples = texture2D(clouds, at + vec2(0.021, 0.013) * time).gb
                 + texture2D(clouds, at * 2.7 - vec2(0.034, 0.008) * time).gb - 1.0;
    ripples *= 0.45 * rough / (1.0 + away * 0.02);
    vec3 normal = normalize(up + vec3(ripples.x, 0.0, ripples.y));
    float facing = max(dot(-view, normal), 0.02);
    float fresnel = 0.03 + 0.97 * pow(1.0 - facing, 5.0);
    vec3 mirrored = reflect(view, normal);
    mirrored.y = abs(mirrored.y);
    vec3 water = vec3(0.01, 0.05, 0.09) + vec3(0.02, 0.16, 0.15) * max(normal.x * sun.x - normal.z * 0.4, 0.0)
               + vec3(0.03, 0.10, 0.10) * pow(facing, 3.0);
    vec3 colour = mix(water, evening(mirrored, false), fresnel);
    float glitter = pow(max(dot(mirrored, sun), 0.0), 260.0);
    colour += vec3(1.0, 0.62, 0.30) * min(2.2 * glitter, 1.6);
    float haze = 1.0 - exp(-away / 420.0);
    gl_FragColor = vec4(mix(colour, evening(normalize(vec3(view.x, 0.01, view.z)), false), haze), 1.0);
}
"""
)


def program(vertex: str, fragment: str) -> int:
    """Both shaders, linked."""
    numbers = {"COUNT": str(len(WAVES)), "GROWTH": f"{math.log(FARTHEST / NEAREST) / RINGS:.5f}"}
    for name, number in numbers.items():
        vertex = vertex.replace(name, number)
    return compileProgram(
        compileShader(vertex, GL_VERTEX_SHADER), compileShader(fragment, GL_FRAGMENT_SHADER)
    )


def ripples() -> np.ndarray:
    """A tile of noise, (256, 256, 3): clouds in red, the slopes of ripples in green and blue."""
    at = np.stack(np.meshgrid(np.arange(256), np.arange(256)), -1) / 256.0 * 4.0
    cloud = 0.5 + 0.75 * fractal(at, 6, 5, period=4)
    water = fractal(at * 2.0, 5, 40, ridged=True, period=8)
    slopes = [0.5 + 6.0 * (np.roll(water, -1, axis) - np.roll(water, 1, axis)) for axis in (1, 0)]
    return np.dstack([cloud, *slopes])


def sea_mesh() -> tuple[np.ndarray, np.ndarray]:
    """Places (points, 3) on rings around the eye, and the triangles' corners (triangles, 3) among them."""
    away = np.r_[0.0, np.geomspace(NEAREST, FARTHEST, RINGS)]
    angles = np.arange(SPOKES) * 2 * math.pi / SPOKES
    places = np.stack(
        [np.outer(away, np.sin(angles)), np.zeros((len(away), SPOKES)), np.outer(away, -np.cos(angles))], -1
    ).reshape(-1, 3)
    ring, spoke = np.mgrid[0:RINGS, 0:SPOKES]
    beside = (spoke + 1) % SPOKES
    one, two, three, four = (
        r * SPOKES + s for r, s in ((ring, spoke), (ring, beside), (ring + 1, beside), (ring + 1, spoke))
    )
    triangles = np.concatenate([np.stack([one, two, three], -1), np.stack([one, three, four], -1)])
    return places.astype("f"), triangles.reshape(-1, 3).astype(np.uint32)


class Ocean(Stage):
    """The sea around the eye, under the evening sky."""

    title = "Ocean"
    fovy, near, far = 65.0, 0.2, 2000.0
    eye = 2.6

    def __init__(self, hour: float) -> None:
        super().__init__()
        self.hour, self.rough = hour, 1.0
        self.pitch = 6.0
        self.wire = False
        self.keys = {
            "+": ("rougher", lambda: self.stir(1.15)),
            "-": ("calmer", lambda: self.stir(1.0 / 1.15)),
            "p": ("the mesh", lambda: setattr(self, "wire", not self.wire)),
            **self.keys,
        }

    def set_up(self) -> None:
        glEnable(GL_DEPTH_TEST)
        self.sky = program(SKY_VERTEX, SKY_FRAGMENT)
        self.sea = program(SEA_VERTEX, SEA_FRAGMENT)
        rows = [
            (math.sin(math.radians(a)), -math.cos(math.radians(a)), 2 * math.pi / long, high)
            for a, long, high in WAVES
        ]
        glUseProgram(self.sea)
        glUniform4fv(glGetUniformLocation(self.sea, "waves"), len(WAVES), np.array(rows, "f"))
        glUniform1f(glGetUniformLocation(self.sea, "eye"), self.eye)
        for shader in (self.sky, self.sea):
            glUseProgram(shader)
            glUniform3fv(glGetUniformLocation(shader, "sun"), 1, np.array(SUN, "f") / np.linalg.norm(SUN))
            glUniform1i(glGetUniformLocation(shader, "clouds"), 0)
        glUseProgram(0)
        texture(ripples())
        self.places, self.triangles = sea_mesh()
        self.ball = gluNewQuadric()

    def draw(self) -> None:
        self.look()
        self.begin(self.sky)
        gluSphere(self.ball, SKY, 64, 48)
        self.begin(self.sea)
        glTranslatef(0.0, -self.eye, 0.0)
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE if self.wire else GL_FILL)
        glEnableClientState(GL_VERTEX_ARRAY)
        glVertexPointer(3, GL_FLOAT, 0, self.places)
        glDrawElements(GL_TRIANGLES, self.triangles.size, GL_UNSIGNED_INT, self.triangles)
        glDisableClientState(GL_VERTEX_ARRAY)
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
        glUseProgram(0)

    def begin(self, shader: int) -> None:
        glUseProgram(shader)
        glUniform1f(glGetUniformLocation(shader, "time"), self.hour + self.seconds)
        if shader == self.sea:
            glUniform1f(glGetUniformLocation(shader, "rough"), self.rough)

    def stir(self, factor: float) -> None:
        self.rough = max(0.15, min(2.0, self.rough * factor))


def main() -> None:
    parser = argparse.ArgumentParser(description="An ocean at sunset.")
    parser.add_argument(
        "--hour", type=float, default=40.0, metavar="SECONDS", help="how long the waves have run"
    )
    try:
        Ocean(parser.parse_args().hour).run()
    except ShaderCompilationError as error:
        parser.exit(1, f"the driver refuses a shader: {error}\n")


if __name__ == "__main__":
    main()
