// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Sources, a surface with edges, glyphs, a pane, and a tube around a line.
import "@kitware/vtk.js/Rendering/Profiles/All";
import vtkActor from "@kitware/vtk.js/Rendering/Core/Actor";
import vtkArrowSource from "@kitware/vtk.js/Filters/Sources/ArrowSource";
import vtkConeSource from "@kitware/vtk.js/Filters/Sources/ConeSource";
import vtkCylinderSource from "@kitware/vtk.js/Filters/Sources/CylinderSource";
import vtkFullScreenRenderWindow from "@kitware/vtk.js/Rendering/Misc/FullScreenRenderWindow";
import vtkGlyph3DMapper from "@kitware/vtk.js/Rendering/Core/Glyph3DMapper";
import vtkMapper from "@kitware/vtk.js/Rendering/Core/Mapper";
import vtkPolyDataNormals from "@kitware/vtk.js/Filters/Core/PolyDataNormals";
import vtkSphereSource from "@kitware/vtk.js/Filters/Sources/SphereSource";
import { box, turn } from "./canvas_stage.js";
const view = vtkFullScreenRenderWindow.newInstance({ rootContainer: box("div"), containerStyle: { width: "460px", height: "340px" }, background: [0.2, 0.25, 0.3] });
const renderer = view.getRenderer(), things = [];
const add = (source, mapper, color, at, change = () => {}) => {
  const actor = vtkActor.newInstance();
  mapper.setInputConnection(source.getOutputPort());
  actor.setMapper(mapper);
  actor.getProperty().setColor(...color);
  actor.setPosition(...at);
  change(actor.getProperty());
  renderer.addActor(actor);
  things.push(actor);
};
const ball = vtkSphereSource.newInstance({ radius: 0.8, thetaResolution: 10, phiResolution: 8 });
add(ball, vtkMapper.newInstance(), [0.9, 0.4, 0.3], [-2, 1, 0]);
add(ball, vtkMapper.newInstance(), [0.4, 0.8, 0.4], [0, 1, 0], (property) => { property.setEdgeVisibility(true); property.setEdgeColor(0, 0, 0); });
add(vtkConeSource.newInstance({ resolution: 9, height: 1.4, radius: 0.6 }), vtkMapper.newInstance(), [0.4, 0.6, 0.9], [2, 1, 0]);
const normals = vtkPolyDataNormals.newInstance();
normals.setInputConnection(vtkCylinderSource.newInstance({ resolution: 10, height: 1.4, radius: 0.6 }).getOutputPort());
add(normals, vtkMapper.newInstance(), [0.9, 0.8, 0.4], [-2, -1, 0], (property) => property.setOpacity(0.6));
const arrows = vtkGlyph3DMapper.newInstance({ scaleFactor: 0.5, orientationArray: "Normals" });
arrows.setInputConnection(vtkArrowSource.newInstance({ tipResolution: 8, shaftResolution: 8 }).getOutputPort(), 1);
add(vtkSphereSource.newInstance({ radius: 0.6, thetaResolution: 6, phiResolution: 5 }), arrows, [0.8, 0.5, 0.8], [0, -1, 0]);
add(ball, vtkMapper.newInstance(), [0.8, 0.8, 0.8], [2, -1, 0], (property) => property.setRepresentationToWireframe());
renderer.resetCamera();
turn(() => { things.forEach((thing) => { thing.rotateY(3); thing.rotateX(1); }); view.getRenderWindow().render(); });
