// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Soft shadows, metal and plastic, a glow, and a highlight around one object.
import * as BABYLON from "babylonjs";
import { box } from "./canvas_stage.js";
const engine = new BABYLON.Engine(box(), false, { stencil: true });
const scene = new BABYLON.Scene(engine);
new BABYLON.ArcRotateCamera("eye", 1.2, 1.1, 9, BABYLON.Vector3.Zero(), scene);
new BABYLON.HemisphericLight("sky", new BABYLON.Vector3(0, 1, 0), scene).intensity = 0.5;
const sun = new BABYLON.DirectionalLight("sun", new BABYLON.Vector3(-1, -2, -1), scene);
sun.position = new BABYLON.Vector3(5, 10, 5);
const shadows = new BABYLON.ShadowGenerator(512, sun);
shadows.useBlurExponentialShadowMap = true;
const glow = new BABYLON.GlowLayer("glow", scene), around = new BABYLON.HighlightLayer("around", scene);
const paint = (name, r, g, b, metal) => { const one = new BABYLON.PBRMaterial(name, scene); one.albedoColor = new BABYLON.Color3(r, g, b); one.metallic = metal; one.roughness = 0.35; return one; };
const build = BABYLON.MeshBuilder;
const things = [build.CreateSphere("ball", { diameter: 1.6, segments: 4 }, scene), build.CreateTorusKnot("knot", { radius: 0.6, tube: 0.2, radialSegments: 40, tubularSegments: 8 }, scene),
  build.CreateCylinder("cylinder", { height: 1.5, diameterTop: 0.5, diameterBottom: 1.2, tessellation: 9 }, scene), build.CreateTorus("ring", { diameter: 1.3, thickness: 0.4, tessellation: 14 }, scene)];
things.forEach((thing, i) => { thing.position.set(-3 + 2 * i, 0.4, i % 2); thing.material = paint(`paint ${i}`, 0.9 - 0.2 * i, 0.3 + 0.15 * i, 0.4, i % 2); thing.receiveShadows = true; shadows.addShadowCaster(thing); });
things[3].material.emissiveColor = new BABYLON.Color3(0.2, 0.7, 0.3);
glow.addIncludedOnlyMesh(things[3]);
around.addMesh(things[0], BABYLON.Color3.Yellow());
const ground = build.CreateGround("ground", { width: 12, height: 10 }, scene);
ground.position.y = -0.7;
ground.receiveShadows = true;
ground.material = paint("ground", 0.5, 0.5, 0.45, 0);
let frame = 0;
engine.runRenderLoop(() => { frame++; things.forEach((thing) => { thing.rotation.y = 0.05 * frame; thing.rotation.x = 0.02 * frame; }); scene.render(); });
