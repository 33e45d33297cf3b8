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
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPushMatrix()
    gl.glLoadIdentity()
    gl.glOrtho(-1.5, 1.5, -1.5, 1.5, -2, 2)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glPushMatrix()
    gl.glLoadIdentity()
    gl.glRotatef(turned, 0.3, 1, 0)
    shape.draw(gl.GL_TRIANGLES)
    gl.glPopMatrix()
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPopMatrix()
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glDisable(gl.GL_LIGHTING)
    gl.glDisable(gl.GL_DEPTH_TEST)
    turned += 2


pyglet.clock.schedule_interval(lambda seconds: None, 1 / 30)
pyglet.app.run()
