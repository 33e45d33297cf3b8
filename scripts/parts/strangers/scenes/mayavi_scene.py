# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A coarse surface, tubes and balls in Mayavi, for scripts/strangers."""
import numpy
from mayavi import mlab

mlab.figure(size=(400, 300))
theta, phi = numpy.mgrid[0:numpy.pi:8j, 0:2 * numpy.pi:12j]
mlab.mesh(numpy.sin(theta) * numpy.cos(phi), numpy.sin(theta) * numpy.sin(phi), numpy.cos(theta))
turn = numpy.linspace(0, 4 * numpy.pi, 40)
mlab.plot3d(1.5 * numpy.cos(turn), 1.5 * numpy.sin(turn), turn / 6 - 1, turn, tube_radius=0.1, tube_sides=6)
mlab.points3d([2, 2, -2], [2, -2, 2], [0, 0.5, 1], scale_factor=0.8, resolution=6)


@mlab.animate(delay=100, ui=False)
def turned():
    while True:
        mlab.gcf().scene.camera.azimuth(4)
        mlab.gcf().scene.render()
        yield


animation = turned()
mlab.show()
