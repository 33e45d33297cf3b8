// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Objects with edges, x-rayed and highlighted ones, ambient occlusion, a section, in the viewer of xeokit.
import { buildCylinderGeometry, buildSphereGeometry, buildTorusGeometry, EdgeMaterial, Mesh, PhongMaterial, ReadableGeometry, SceneModel, SectionPlane, Viewer } from "@xeokit/xeokit-sdk";
import { box, turn } from "./canvas_stage.js";
const canvas = box();
canvas.id = "canvas";
const viewer = new Viewer({ canvasId: "canvas", transparent: false, saoEnabled: true });
const scene = viewer.scene;
scene.camera.eye = [0, 3, 8];
scene.camera.look = [0, 0, 0];
const add = (build, color, position, more = {}) => new Mesh(scene, { geometry: new ReadableGeometry(scene, build), material: new PhongMaterial(scene, { diffuse: color }), position, edges: true, ...more });
add(buildSphereGeometry({ radius: 0.9, heightSegments: 8, widthSegments: 12 }), [0.9, 0.3, 0.3], [-2.6, 1, 0]);
add(buildTorusGeometry({ radius: 0.7, tube: 0.25, radialSegments: 12, tubeSegments: 8 }), [0.3, 0.8, 0.4], [0, 1, 0], { highlighted: true });
add(buildCylinderGeometry({ radiusTop: 0.3, radiusBottom: 0.7, height: 1.4, radialSegments: 9, heightSegments: 1 }), [0.3, 0.5, 0.9], [2.6, 1, 0], { xrayed: true });
const model = new SceneModel(scene, { id: "model", isModel: true });
const ball = buildSphereGeometry({ radius: 0.8, heightSegments: 8, widthSegments: 10 });
model.createGeometry({ id: "ball", primitive: "triangles", positions: ball.positions, normals: ball.normals, indices: ball.indices });
model.createMesh({ id: "one", geometryId: "ball", position: [-1.3, -1.2, 0], color: [0.9, 0.8, 0.3] });
model.createMesh({ id: "two", geometryId: "ball", position: [1.3, -1.2, 0], color: [0.8, 0.5, 0.8] });
model.createEntity({ id: "first", meshIds: ["one"], isObject: true });
model.createEntity({ id: "second", meshIds: ["two"], isObject: true });
model.finalize();
new SectionPlane(scene, { pos: [0, 0, 0.4], dir: [0, 0, -1] });
turn(() => scene.camera.orbitYaw(2));
