// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A mirror on the ground and a wall of glass, each with a picture of its own.
import * as THREE from "three";
import { Reflector } from "three/examples/jsm/objects/Reflector.js";
import { Refractor } from "three/examples/jsm/objects/Refractor.js";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage();
const paint = (color) => new THREE.MeshStandardMaterial({ color, roughness: 0.4 });
const things = [put(scene, new THREE.SphereGeometry(0.8, 12, 8), paint(0xee4444), -1.6, 0.4, 0), put(scene, new THREE.TorusKnotGeometry(0.5, 0.2, 48, 8), paint(0x44ee88), 0.4, 0.5, -0.6),
  put(scene, new THREE.ConeGeometry(0.6, 1.4, 8), paint(0xddcc55), 2.1, 0.2, 0)];
const floor = new Reflector(new THREE.PlaneGeometry(9, 7), { textureWidth: 256, textureHeight: 256, color: 0xaaaaaa });
floor.rotation.x = -Math.PI / 2;
floor.position.y = -0.55;
const glass = new Refractor(new THREE.PlaneGeometry(1.4, 1.4), { textureWidth: 128, textureHeight: 128, color: 0x99bbff });
glass.position.set(0.5, 0.4, 1.6);
scene.add(floor, glass);
turn((frame) => { things.forEach((thing, i) => { thing.rotation.y = 0.05 * frame; thing.position.y = 0.4 + 0.2 * Math.sin(0.1 * frame + i); }); renderer.render(scene, camera); });
