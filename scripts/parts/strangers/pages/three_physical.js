// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Glass with transmission, clear coat, a room as environment, and a ball that mirrors the others by a cube camera.
import * as THREE from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage();
scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
const target = new THREE.WebGLCubeRenderTarget(64, { generateMipmaps: true, minFilter: THREE.LinearMipmapLinearFilter });
const eye = new THREE.CubeCamera(0.1, 50, target);
scene.add(eye);
const mirror = put(scene, new THREE.SphereGeometry(0.8, 14, 10), new THREE.MeshStandardMaterial({ envMap: target.texture, metalness: 1, roughness: 0.05 }), 0, 0.6, 0);
eye.position.copy(mirror.position);
const things = [put(scene, new THREE.SphereGeometry(0.8, 12, 8), new THREE.MeshPhysicalMaterial({ transmission: 1, roughness: 0.1, thickness: 0.6, ior: 1.4 }), -1.9, 0.2, 0.8),
  put(scene, new THREE.TorusKnotGeometry(0.5, 0.2, 48, 8), new THREE.MeshPhysicalMaterial({ color: 0xaa2222, clearcoat: 1, roughness: 0.5 }), 1.9, 0.3, 0.4),
  put(scene, new THREE.BoxGeometry(0.8, 0.8, 0.8), new THREE.MeshPhysicalMaterial({ color: 0x2244aa, iridescence: 1 }), -0.7, -0.4, 2),
  put(scene, new THREE.CylinderGeometry(0.3, 0.3, 2.2, 8), new THREE.MeshPhysicalMaterial({ color: 0xddaa33, metalness: 1, roughness: 0.3 }), -1.7, 0.6, -1.5)];
turn((frame) => {
  things.forEach((thing) => { thing.rotation.set(0.02 * frame, 0.05 * frame, 0); });
  mirror.visible = false;
  eye.update(renderer, scene);
  mirror.visible = true;
  renderer.render(scene, camera);
});
