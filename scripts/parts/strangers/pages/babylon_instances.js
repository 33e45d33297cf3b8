// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Thin instances, a tube on bones, a ribbon that waves, a difference of solids, and ambient occlusion with geometry buffers.
import * as BABYLON from "babylonjs";
import { box } from "./canvas_stage.js";
const engine = new BABYLON.Engine(box(), false);
const scene = new BABYLON.Scene(engine);
const eye = new BABYLON.ArcRotateCamera("eye", 1.3, 1.1, 10, BABYLON.Vector3.Zero(), scene);
new BABYLON.HemisphericLight("sky", new BABYLON.Vector3(0.5, 1, 0.4), scene);
const build = BABYLON.MeshBuilder, paint = (r, g, b) => { const one = new BABYLON.StandardMaterial("paint", scene); one.diffuseColor = new BABYLON.Color3(r, g, b); one.backFaceCulling = false; return one; };
const balls = build.CreateSphere("balls", { diameter: 0.5, segments: 3 }, scene);
balls.material = paint(0.8, 0.5, 0.3);
for (let i = 0; i < 24; i++) balls.thinInstanceAdd(BABYLON.Matrix.Translation(-3.3 + 0.95 * (i % 8), 1.4 + 0.6 * Math.floor(i / 8), 1));
const tube = build.CreateCylinder("tube", { height: 3, diameter: 0.8, tessellation: 8, subdivisions: 8 }, scene);
const skeleton = new BABYLON.Skeleton("skeleton", "skeleton", scene);
const low = new BABYLON.Bone("low", skeleton, null, BABYLON.Matrix.Translation(0, -1.5, 0)), high = new BABYLON.Bone("high", skeleton, low, BABYLON.Matrix.Translation(0, 1.5, 0));
const at = tube.getVerticesData(BABYLON.VertexBuffer.PositionKind), which = [], weight = [];
for (let i = 0; i < at.length / 3; i++) { const share = Math.min(1, Math.max(0, at[3 * i + 1] + 0.5)); which.push(0, 1, 0, 0); weight.push(1 - share, share, 0, 0); }
tube.setVerticesData(BABYLON.VertexBuffer.MatricesIndicesKind, which);
tube.setVerticesData(BABYLON.VertexBuffer.MatricesWeightsKind, weight);
tube.skeleton = skeleton;
tube.position.set(-2.4, -0.6, 0);
tube.material = paint(0.4, 0.7, 0.4);
const wave = (t) => Array.from({ length: 9 }, (_, i) => Array.from({ length: 9 }, (_, j) => new BABYLON.Vector3(0.35 * i - 1.4, 0.35 * Math.sin(0.8 * i + t) * Math.cos(0.7 * j), 0.35 * j - 1.4)));
let ribbon = build.CreateRibbon("ribbon", { pathArray: wave(0), updatable: true }, scene);
ribbon.material = paint(0.4, 0.5, 0.9);
ribbon.position.set(0.2, -0.6, 0);
const solid = BABYLON.CSG.FromMesh(build.CreateBox("box", { size: 1.4 }, scene)).subtract(BABYLON.CSG.FromMesh(build.CreateSphere("hole", { diameter: 1.8, segments: 5 }, scene)));
scene.getMeshByName("box").dispose();
scene.getMeshByName("hole").dispose();
const rest = solid.toMesh("rest", paint(0.9, 0.8, 0.3), scene);
rest.position.set(2.6, -0.6, 0);
new BABYLON.SSAO2RenderingPipeline("occlusion", scene, { ssaoRatio: 0.5, blurRatio: 1 }, [eye]);
let frame = 0;
engine.runRenderLoop(() => {
  frame++;
  high.setRotation(new BABYLON.Vector3(0, 0, 0.8 * Math.sin(0.1 * frame)), BABYLON.Space.LOCAL);
  ribbon = build.CreateRibbon("ribbon", { pathArray: wave(0.1 * frame), instance: ribbon });
  rest.rotation.y = tube.rotation.y = 0.04 * frame;
  scene.render();
});
