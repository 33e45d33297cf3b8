// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Shadows of a sun, a spot light and a point light, on smooth, flat and boxy objects.
import * as THREE from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, sun, turn } = stage();
renderer.shadowMap.enabled = true;
const spot = new THREE.SpotLight(0xff8844, 60, 20, 0.5, 0.4);
spot.position.set(-4, 5, 2);
const lamp = new THREE.PointLight(0x66aaff, 12);
lamp.position.set(1, 3, 1.5);
for (const light of [sun, spot, lamp]) { light.castShadow = true; light.shadow.bias = -0.002; scene.add(light); }
const paint = (color, more) => new THREE.MeshStandardMaterial({ color, roughness: 0.45, ...more });
const things = [
  put(scene, new THREE.SphereGeometry(0.7, 12, 8), paint(0xdd3333), -2, 0.2, 0),
  put(scene, new THREE.TorusKnotGeometry(0.5, 0.18, 40, 6), paint(0x33dd66), 0, 0.3, 0),
  put(scene, new THREE.CylinderGeometry(0.5, 0.5, 1.2, 9), paint(0xdddd44), 2, 0.1, 0),
  put(scene, new RoundedBoxGeometry(0.9, 0.9, 0.9, 2, 0.15), paint(0x4488dd), -1, 0.2, 1.6),
  put(scene, new THREE.IcosahedronGeometry(0.6, 1), paint(0xcc66cc, { flatShading: true }), 1, 0.1, 1.7),
  put(scene, new THREE.CapsuleGeometry(0.35, 0.7, 3, 8), paint(0xeeeeee), 0, 0.2, -1.6),
];
const ground = put(scene, new THREE.PlaneGeometry(12, 12), paint(0x778877), 0, -0.6, 0);
ground.rotation.x = -Math.PI / 2;
for (const thing of [...things, ground]) { thing.castShadow = thing !== ground; thing.receiveShadow = true; }
turn((frame) => { things.forEach((thing, i) => { thing.rotation.y = 0.05 * frame + i; }); renderer.render(scene, camera); });
