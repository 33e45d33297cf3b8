# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A lit ball in a pyglet window, for scripts/strangers."""
import pyglet
from pyglet.graphics import shader

from ball import ball

VERTEX = """#version 150 core
in vec3 position; in vec3 normal; out vec3 shade; uniform float angle;
void main() {
  mat3 turn = mat3(cos(angle), 0, -sin(angle), 0, 1, 0, sin(angle), 0, cos(angle));
  shade = vec3(.2, .5, .9) * (.2 + .8 * max(dot(turn * normal, normalize(vec3(1, 1, -2))), 0.));
  vec3 p = turn * position * .7; gl_Position = vec4(p.xy, p.z * .5, 1);
}"""
FRAGMENT = "#version 150 core\nin vec3 shade; out vec4 colour; void main() { colour = vec4(shade, 1); }"

window = pyglet.window.Window(300, 300, config=pyglet.gl.Config(depth_size=24, double_buffer=True))
program = shader.ShaderProgram(shader.Shader(VERTEX, "vertex"), shader.Shader(FRAGMENT, "fragment"))
flat = [value for corner in ball() for value in corner]
shape = program.vertex_list(len(flat) // 3, pyglet.gl.GL_TRIANGLES, position=("f", flat), normal=("f", flat))
turned = 0.0


@window.event
def on_draw():
    global turned
    window.clear()
    pyglet.gl.glEnable(pyglet.gl.GL_DEPTH_TEST)
    program.use()
    program["angle"] = turned
    shape.draw(pyglet.gl.GL_TRIANGLES)
    turned += 0.02


pyglet.clock.schedule_interval(lambda seconds: None, 1 / 30)
pyglet.app.run()
