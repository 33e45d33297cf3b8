# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A lit ball of the fixed function in a wxPython window, for scripts/strangers."""
import wx
from OpenGL import GL
from wx import glcanvas

from ball import ball


class Canvas(glcanvas.GLCanvas):
    def __init__(self, parent):
        super().__init__(parent, attribList=[glcanvas.WX_GL_RGBA, glcanvas.WX_GL_DOUBLEBUFFER, glcanvas.WX_GL_DEPTH_SIZE, 24])
        self.context = glcanvas.GLContext(self)
        self.angle = 0
        self.Bind(wx.EVT_PAINT, self.paint)
        self.timer = wx.Timer(self)
        self.Bind(wx.EVT_TIMER, lambda event: self.Refresh(False), self.timer)
        self.timer.Start(40)

    def paint(self, event):
        wx.PaintDC(self)
        self.SetCurrent(self.context)
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glEnable(GL.GL_LIGHTING)
        GL.glEnable(GL.GL_LIGHT0)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glMatrixMode(GL.GL_PROJECTION)
        GL.glLoadIdentity()
        GL.glOrtho(-1.2, 1.2, -1.2, 1.2, -2, 2)
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glLoadIdentity()
        GL.glRotatef(self.angle, 0.3, 1, 0)
        GL.glBegin(GL.GL_TRIANGLES)
        for corner in ball():
            GL.glNormal3f(*corner)
            GL.glVertex3f(*corner)
        GL.glEnd()
        self.SwapBuffers()
        self.angle += 3


app = wx.App()
frame = wx.Frame(None, size=(320, 300), title="ball")
Canvas(frame)
frame.Show()
app.MainLoop()
