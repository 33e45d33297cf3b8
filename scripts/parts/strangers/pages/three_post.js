// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Passes behind the picture: ambient occlusion from a pass of normals, outlines of a selection, bloom.
import * as THREE from "three";
import { EffectComposer } from "three/examples/jsm/postprocessing/EffectComposer.js";
import { GTAOPass } from "three/examples/jsm/postprocessing/GTAOPass.js";
import { OutlinePass } from "three/examples/jsm/postprocessing/OutlinePass.js";
import { OutputPass } from "three/examples/jsm/postprocessing/OutputPass.js";
import { RenderPass } from "three/examples/jsm/postprocessing/RenderPass.js";
import { UnrealBloomPass } from "three/examples/jsm/postprocessing/UnrealBloomPass.js";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage();
const paint = (color, more) => new THREE.MeshStandardMaterial({ color, ...more });
const things = [put(scene, new THREE.SphereGeometry(0.8, 12, 8), paint(0xbb4444), -1.6, 0.2, 0), put(scene, new THREE.TorusGeometry(0.6, 0.25, 8, 12), paint(0x44bb66), 0.2, 0.3, 0),
  put(scene, new THREE.CylinderGeometry(0.1, 0.6, 1.3, 8), paint(0x222222, { emissive: 0xffaa33 }), 1.9, 0.1, 0)];
put(scene, new THREE.BoxGeometry(8, 0.3, 5), paint(0x888899), 0, -0.75, 0);
const composer = new EffectComposer(renderer);
const outline = new OutlinePass(new THREE.Vector2(460, 340), scene, camera, [things[1]]);
outline.edgeStrength = 5;
composer.addPass(new RenderPass(scene, camera));
composer.addPass(new GTAOPass(scene, camera, 460, 340));
composer.addPass(outline);
composer.addPass(new UnrealBloomPass(new THREE.Vector2(230, 170), 0.4, 0.3, 0.8));
composer.addPass(new OutputPass());
turn((frame) => { things.forEach((thing) => { thing.rotation.y = 0.06 * frame; thing.rotation.x = 0.02 * frame; }); composer.render(); });
