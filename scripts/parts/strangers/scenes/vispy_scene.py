# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A coarse lit ball, a cube and axes in VisPy, for scripts/strangers."""
from vispy import app, scene
from vispy.geometry import create_sphere

app.use_app("pyqt5")
canvas = scene.SceneCanvas(size=(320, 240), show=True)
view = canvas.central_widget.add_view()
view.camera = scene.TurntableCamera(distance=6, fov=40)
ball = create_sphere(8, 12, radius=1.0)
scene.visuals.Mesh(vertices=ball.get_vertices(), faces=ball.get_faces(), shading="smooth", color=(1, 0.5, 0.2, 1), parent=view.scene)
box = scene.visuals.Box(width=1, height=1, depth=1, color=(0.2, 0.5, 1, 1), edge_color="black", parent=view.scene)
box.transform = scene.transforms.STTransform(translate=(2, 0, 0))
scene.visuals.XYZAxis(parent=view.scene)
for _ in range(40):
    view.camera.azimuth += 4
    canvas.update()
    app.process_events()
