# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""usage: glut_teapot.py FRAMES: the solids of GLUT in a window, lit, through PyOpenGL."""
import sys

from OpenGL import GL, GLU, GLUT

frames = int(sys.argv[1])
drawn = 0
SOLIDS = [lambda: GLUT.glutSolidTeapot(0.6), lambda: GLUT.glutSolidTorus(0.2, 0.5, 10, 16),
          lambda: GLUT.glutSolidIcosahedron(), lambda: GLUT.glutSolidSphere(0.7, 12, 8)]


def display() -> None:
    global drawn
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    for i, solid in enumerate(SOLIDS):
        GL.glLoadIdentity()
        GLU.gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)
        GL.glTranslatef(i % 2 * 2 - 1, i // 2 * 2 - 1, 0)
        GL.glRotatef(30 + 5 * drawn, 1, 0.5, 0)
        GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_DIFFUSE, (0.3 + 0.2 * i, 0.8 - 0.2 * i, 0.4, 1))
        solid()
    GLUT.glutSwapBuffers()
    drawn += 1
    if drawn == frames:
        sys.exit(0)
    GLUT.glutPostRedisplay()


GLUT.glutInit(["glut_teapot"])
GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
GLUT.glutInitWindowSize(400, 300)
GLUT.glutCreateWindow(b"solids")
GL.glMatrixMode(GL.GL_PROJECTION)
GLU.gluPerspective(50, 4 / 3, 1, 20)
GL.glMatrixMode(GL.GL_MODELVIEW)
for state in (GL.GL_DEPTH_TEST, GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_NORMALIZE):
    GL.glEnable(state)
GLUT.glutDisplayFunc(display)
GLUT.glutMainLoop()
