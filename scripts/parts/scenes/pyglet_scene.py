# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A lit ball of the fixed function and a label in a pyglet window, for scripts/strangers."""
import pyglet
from pyglet import gl

from ball import ball

window = pyglet.window.Window(300, 300, config=gl.Config(depth_size=24, double_buffer=True))
flat = [value for corner in ball() for value in corner]
shape = pyglet.graphics.vertex_list(len(flat) // 3, ("v3f/static", flat), ("n3f/static", flat))
label = pyglet.text.Label("pyglet", x=10, y=10)
turned = 0


@window.event
def on_draw():
    global turned
    window.clear()
    label.draw()
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glPushMatrix()
    gl.glTranslatef(150, 150, 0)
    gl.glScalef(100, 100, 0.9)
    gl.glRotatef(turned, 0.3, 1, 0)
    gl.glEnable(gl.GL_NORMALIZE)
    shape.draw(gl.GL_TRIANGLES)
    gl.glPopMatrix()
    gl.glDisable(gl.GL_LIGHTING)
    gl.glDisable(gl.GL_DEPTH_TEST)
    turned += 2


pyglet.clock.schedule_interval(lambda seconds: None, 1 / 30)
pyglet.app.run()
