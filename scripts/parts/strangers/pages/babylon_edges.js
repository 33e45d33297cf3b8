// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Edges, outlines, overlays, wires over a surface, a pane with a depth pass before it, and a clip plane.
import * as BABYLON from "babylonjs";
import { box } from "./canvas_stage.js";
const engine = new BABYLON.Engine(box(), true, { stencil: true });
const scene = new BABYLON.Scene(engine);
new BABYLON.ArcRotateCamera("eye", 1.3, 1.15, 9, BABYLON.Vector3.Zero(), scene);
new BABYLON.HemisphericLight("sky", new BABYLON.Vector3(0.5, 1, 0.4), scene);
const paint = (r, g, b) => { const one = new BABYLON.StandardMaterial("paint", scene); one.diffuseColor = new BABYLON.Color3(r, g, b); return one; };
const build = BABYLON.MeshBuilder;
const things = [build.CreateSphere("ball", { diameter: 1.5, segments: 4 }, scene), build.CreateBox("box", { size: 1.2 }, scene), build.CreateTorus("ring", { diameter: 1.4, thickness: 0.5, tessellation: 14 }, scene),
  build.CreateCapsule("capsule", { radius: 0.5, height: 1.7, tessellation: 9, capSubdivisions: 3 }, scene), build.CreateCylinder("cut", { height: 1.6, diameter: 1.2, tessellation: 10 }, scene), build.CreateIcoSphere("gem", { radius: 0.8, subdivisions: 2, flat: true }, scene)];
things.forEach((thing, i) => { thing.position.set(-2.4 + 2.4 * (i % 3), i < 3 ? 1.2 : -1.1, 0); thing.material = paint(0.9 - 0.12 * i, 0.3 + 0.1 * i, 0.2 + 0.13 * i); });
things[1].enableEdgesRendering();
things[1].edgesWidth = 6;
things[2].renderOutline = true;
things[2].outlineWidth = 0.06;
things[3].material.alpha = 0.5;
things[3].material.needDepthPrePass = true;
things[4].material.clipPlane = new BABYLON.Plane(1, 0.3, 0, 0);
things[4].material.backFaceCulling = false;
const wires = things[0].clone("wires");
wires.material = paint(0, 0, 0);
wires.material.wireframe = true;
wires.material.zOffset = -2;
let frame = 0;
engine.runRenderLoop(() => { frame++; [...things, wires].forEach((thing) => { thing.rotation.y = 0.05 * frame; }); scene.render(); });
