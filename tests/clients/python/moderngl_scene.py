# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""usage: moderngl_scene.py FRAMES OUT.ppm: a turning prism, lit per pixel, instanced, in a framebuffer of ModernGL."""
import array
import math
import pathlib
import sys

import moderngl

SIZE = 256
VERTEX = """#version 330
in vec3 position;
in vec3 normal;
uniform mat4 turn;
out vec3 n;
out vec3 tint;
void main() {
  vec3 place = vec3(float(gl_InstanceID % 3) - 1.0, float(gl_InstanceID / 3) - 1.0, 0.0) * 0.6;
  n = mat3(turn) * normal;
  tint = vec3(0.3 + 0.1 * float(gl_InstanceID), 0.6, 0.9 - 0.1 * float(gl_InstanceID));
  gl_Position = vec4(mat3(turn) * position * 0.25 + place, 1.0);
}"""
FRAGMENT = """#version 330
in vec3 n;
in vec3 tint;
out vec4 color;
void main() { color = vec4(tint * (0.2 + 0.8 * max(dot(normalize(n), vec3(0.37, 0.56, -0.74)), 0.0)), 1.0); }"""


def prism(sides: int = 6) -> array.array:
    corners = []
    for i in range(sides):
        a, b = (2 * math.pi * (i + k) / sides for k in (0, 1))
        quad = [(math.cos(t), math.sin(t), z) for t, z in ((a, -1), (b, -1), (b, 1), (a, -1), (b, 1), (a, 1))]
        for x, y, z in quad:
            corners += [x, y, z, x, y, 0]
        for z in (-1, 1):
            for x, y in ((0, 0), (math.cos(a), math.sin(a)), (math.cos(b), math.sin(b))):
                corners += [x, y, z, 0, 0, z]
    return array.array("f", corners)


def turn(angle: float) -> array.array:
    c, s, e, f = math.cos(angle), math.sin(angle), math.cos(0.6), math.sin(0.6)
    return array.array("f", [c, s * f, -s * e, 0, 0, e, f, 0, s, -c * f, c * e, 0, 0, 0, 0, 1])


frames, path = int(sys.argv[1]), pathlib.Path(sys.argv[2])
context = moderngl.create_standalone_context()
framebuffer = context.framebuffer(context.renderbuffer((SIZE, SIZE)), context.depth_renderbuffer((SIZE, SIZE)))
framebuffer.use()
context.enable(moderngl.DEPTH_TEST)
program = context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
mesh = context.vertex_array(program, context.buffer(prism().tobytes()), "position", "normal")
for frame in range(frames):
    framebuffer.clear(0.1, 0.2, 0.3)
    program["turn"].write(turn(0.3 + 0.1 * frame).tobytes())
    mesh.render(instances=9)
    pixels = framebuffer.read()
path.write_bytes(b"P6\n%d %d\n255\n" % (SIZE, SIZE) + pixels)
