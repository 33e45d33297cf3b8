# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A sphere, a cone with edges, a tube and an outline in VTK, for scripts/strangers."""
import vtk


def actor(source, colour, edges=False):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetColor(*colour)
    result.GetProperty().SetSpecular(0.5)
    result.GetProperty().SetEdgeVisibility(edges)
    return result


sphere = vtk.vtkSphereSource()
sphere.SetThetaResolution(10)
sphere.SetPhiResolution(8)
cone = vtk.vtkConeSource()
cone.SetResolution(8)
cone.SetCenter(1.2, 0, 0)
torus = vtk.vtkParametricFunctionSource()
torus.SetParametricFunction(vtk.vtkParametricTorus())
for resolution in (torus.SetUResolution, torus.SetVResolution, torus.SetWResolution):
    resolution(12)
renderer = vtk.vtkRenderer()
renderer.SetBackground(0.1, 0.2, 0.3)
for one in (actor(sphere, (1, 0.4, 0.2)), actor(cone, (0.2, 0.8, 0.3), edges=True), actor(torus, (0.3, 0.4, 1))):
    renderer.AddActor(one)
window = vtk.vtkRenderWindow()
window.SetSize(320, 240)
window.AddRenderer(renderer)
for _ in range(40):
    window.Render()
    renderer.GetActiveCamera().Azimuth(3)
    renderer.GetActiveCamera().Elevation(1)
    renderer.ResetCameraClippingRange()
