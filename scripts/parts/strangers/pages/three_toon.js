// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Toon shading with outlines: each object once more, its back faces moved along the normals.
import * as THREE from "three";
import { OutlineEffect } from "three/examples/jsm/effects/OutlineEffect.js";
import { TeapotGeometry } from "three/examples/jsm/geometries/TeapotGeometry.js";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage();
const steps = new THREE.DataTexture(new Uint8Array([80, 80, 80, 255, 160, 160, 160, 255, 255, 255, 255, 255]), 3, 1);
steps.needsUpdate = true;
const paint = (color) => new THREE.MeshToonMaterial({ color, gradientMap: steps });
const things = [put(scene, new THREE.SphereGeometry(0.8, 10, 7), paint(0xee5544), -2, 0.6, 0), put(scene, new TeapotGeometry(0.7, 3), paint(0x55aaee), 0.2, 0.2, 0),
  put(scene, new THREE.TorusGeometry(0.6, 0.25, 6, 10), paint(0x66cc55), 2.2, 0.6, 0), put(scene, new THREE.BoxGeometry(0.9, 0.9, 0.9), paint(0xddcc44), 0, -0.6, 1.8)];
const effect = new OutlineEffect(renderer, { defaultThickness: 0.008 });
turn((frame) => { things.forEach((thing) => { thing.rotation.y = 0.05 * frame; }); effect.render(scene, camera); });
