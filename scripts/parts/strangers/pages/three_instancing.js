// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Instanced balls with their own colours, a batch of different objects, and a group with levels of detail.
import * as THREE from "three";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage({ antialias: true });
const balls = new THREE.InstancedMesh(new THREE.SphereGeometry(0.28, 8, 6), new THREE.MeshLambertMaterial(), 30);
const matrix = new THREE.Matrix4(), color = new THREE.Color();
for (let i = 0; i < 30; i++) {
  balls.setMatrixAt(i, matrix.makeTranslation(-2.5 + (i % 10) * 0.55, 1.2 + Math.floor(i / 10) * 0.5, -1));
  balls.setColorAt(i, color.setHSL(i / 30, 0.7, 0.5));
}
scene.add(balls);
const batch = new THREE.BatchedMesh(12, 4000, 8000, new THREE.MeshStandardMaterial({ roughness: 0.4 }));
const shapes = [new THREE.ConeGeometry(0.3, 0.7, 8), new THREE.TorusGeometry(0.3, 0.12, 6, 10), new THREE.BoxGeometry(0.5, 0.5, 0.5)].map((one) => batch.addGeometry(one));
const ids = Array.from({ length: 12 }, (_, i) => batch.addInstance(shapes[i % 3]));
ids.forEach((id, i) => batch.setColorAt(id, color.setHSL(i / 12, 0.5, 0.5)));
scene.add(batch);
const lod = new THREE.LOD();
[16, 8, 5].forEach((n, i) => lod.addLevel(new THREE.Mesh(new THREE.TorusKnotGeometry(0.5, 0.2, 6 * n, n), new THREE.MeshNormalMaterial()), 3 * i));
lod.position.set(0, -0.3, 1);
scene.add(lod);
turn((frame) => {
  ids.forEach((id, i) => batch.setMatrixAt(id, matrix.makeRotationY(0.05 * frame + i).setPosition(-2.6 + (i % 6) * 1.05, -0.2 - Math.floor(i / 6) * 0.9, 0)));
  lod.position.z = 1 + 2 * Math.sin(0.05 * frame);
  balls.rotation.y = 0.3 * Math.sin(0.04 * frame);
  renderer.render(scene, camera);
});
