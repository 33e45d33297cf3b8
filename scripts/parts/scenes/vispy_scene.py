# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A shaded sphere, a surface and markers in vispy, for scripts/strangers."""
import numpy
from vispy import app, scene

app.use_app("pyqt5")
canvas = scene.SceneCanvas(size=(320, 240), show=True, bgcolor="#223")
view = canvas.central_widget.add_view()
view.camera = scene.cameras.TurntableCamera(distance=6, elevation=30, azimuth=0)
sphere = scene.visuals.Sphere(radius=1, method="latitude", rows=8, cols=10, color=(0.9, 0.5, 0.2, 1), shading="smooth", parent=view.scene)
y, x = numpy.mgrid[-2:2:12j, -2:2:12j]
surface = scene.visuals.SurfacePlot(x=x[0], y=y[:, 0], z=0.3 * numpy.sin(2 * x) * numpy.cos(2 * y) - 1.2, color=(0.3, 0.6, 0.9, 1),
                                    shading="smooth", parent=view.scene)
points = numpy.random.default_rng(1).normal(size=(40, 3))
scene.visuals.Markers(parent=view.scene).set_data(points, size=8)


@canvas.events.draw.connect
def step(event):
    view.camera.azimuth += 2


app.run()
