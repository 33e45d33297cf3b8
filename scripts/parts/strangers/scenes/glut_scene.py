# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The shapes of GLUT and GLU, coarse and lit, for scripts/strangers."""
from OpenGL import GL, GLU, GLUT

quadric = None
angle = 0
SHAPES = (
    lambda: (GL.glFrontFace(GL.GL_CW), GLUT.glutSolidTeapot(0.7), GL.glFrontFace(GL.GL_CCW)),
    lambda: GLUT.glutSolidSphere(0.9, 10, 7),
    lambda: GLUT.glutSolidCone(0.8, 1.4, 9, 2),
    lambda: GLUT.glutSolidTorus(0.3, 0.7, 8, 12),
    lambda: GLUT.glutSolidCube(1.2),
    GLUT.glutSolidIcosahedron, GLUT.glutSolidOctahedron,
    lambda: (GL.glScalef(0.6, 0.6, 0.6), GLUT.glutSolidDodecahedron()),
    lambda: GLU.gluSphere(quadric, 0.9, 8, 6),
    lambda: (GLU.gluCylinder(quadric, 0.6, 0.3, 1.2, 9, 2), GL.glRotatef(180, 1, 0, 0), GLU.gluDisk(quadric, 0.2, 0.6, 9, 1)),
    lambda: GLU.gluPartialDisk(quadric, 0.3, 0.9, 10, 2, 0, 240),
    lambda: (GLU.gluCylinder(quadric, 0.5, 0.5, 1, 7, 1), GL.glTranslatef(0, 0, 1), GLU.gluSphere(quadric, 0.5, 7, 6)),
)


def draw():
    GL.glClearColor(0.15, 0.15, 0.2, 1)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(35, 4 / 3, 1, 40)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    for i, shape in enumerate(SHAPES):
        GL.glLoadIdentity()
        GL.glTranslatef(2.4 * (i % 4 - 1.5), 2.4 * (1 - i // 4), -13)
        GL.glRotatef(angle, 0.5, 1, 0.2)
        GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE, (0.3 + 0.2 * (i % 4), 0.8 - 0.2 * (i // 4), 0.5, 1))
        shape()
    GLUT.glutSwapBuffers()


def turn(_):
    global angle
    angle += 3
    GLUT.glutPostRedisplay()
    GLUT.glutTimerFunc(40, turn, 0)


GLUT.glutInit(["shapes"])
GLUT.glutInitDisplayMode(GLUT.GLUT_RGB | GLUT.GLUT_DOUBLE | GLUT.GLUT_DEPTH)
GLUT.glutInitWindowSize(480, 360)
GLUT.glutCreateWindow(b"shapes")
quadric = GLU.gluNewQuadric()
for state in (GL.GL_DEPTH_TEST, GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_NORMALIZE):
    GL.glEnable(state)
GL.glLightModeli(GL.GL_LIGHT_MODEL_TWO_SIDE, 1)
GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (0.6, 0.6, 0.6, 1))
GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, 30)
GLUT.glutDisplayFunc(draw)
turn(0)
GLUT.glutMainLoop()
