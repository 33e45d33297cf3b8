# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A ball, a torus and an arrow in Open3D's viewer, for scripts/strangers."""
import open3d

viewer = open3d.visualization.Visualizer()
viewer.create_window(width=400, height=300)
SHAPES = (open3d.geometry.TriangleMesh.create_sphere(1, resolution=6), open3d.geometry.TriangleMesh.create_torus(1.6, 0.3, 12, 8),
          open3d.geometry.TriangleMesh.create_arrow(0.2, 0.4, 1.5, 1, 8, 2, 1))
for shape, colour in zip(SHAPES, ((0.9, 0.4, 0.2), (0.3, 0.7, 0.3), (0.3, 0.4, 0.9))):
    shape.compute_vertex_normals()
    shape.paint_uniform_color(colour)
    viewer.add_geometry(shape)
while viewer.poll_events():
    viewer.get_view_control().rotate(12, 5)
    viewer.update_renderer()
