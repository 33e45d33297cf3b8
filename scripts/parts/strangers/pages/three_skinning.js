// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A tube on four bones, and a ball with two morph targets.
import * as THREE from "three";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, sun, turn } = stage();
renderer.shadowMap.enabled = true;
sun.castShadow = true;
sun.shadow.bias = -0.003;
const tube = new THREE.CylinderGeometry(0.35, 0.6, 4, 8, 8);
const at = tube.attributes.position, indices = [], weights = [];
for (let i = 0; i < at.count; i++) {
  const place = Math.min(2.999, (at.getY(i) + 2) / 4 * 3), bone = Math.floor(place);
  indices.push(bone, bone + 1, 0, 0);
  weights.push(1 - (place - bone), place - bone, 0, 0);
}
tube.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(indices, 4));
tube.setAttribute("skinWeight", new THREE.Float32BufferAttribute(weights, 4));
const bones = [0, 1, 2, 3].map((i) => { const bone = new THREE.Bone(); bone.position.y = i ? 4 / 3 : -2; return bone; });
bones.forEach((bone, i) => i && bones[i - 1].add(bone));
const arm = new THREE.SkinnedMesh(tube, new THREE.MeshPhongMaterial({ color: 0xee9955, shininess: 60 }));
arm.add(bones[0]);
arm.bind(new THREE.Skeleton(bones));
arm.position.set(-1.3, 1.2, 0);
const ball = new THREE.SphereGeometry(0.9, 12, 8), round = ball.attributes.position;
ball.morphAttributes.position = [1, 2].map((which) => new THREE.Float32BufferAttribute(Array.from(round.array, (v, i) => (which === 1 ? (i % 3 === 1 ? v * 1.5 : v) : Math.sign(v) * Math.min(Math.abs(v), 0.55))), 3));
const blob = put(scene, ball, new THREE.MeshPhongMaterial({ color: 0x55bbee }), 1.5, 0.6, 0);
blob.updateMorphTargets();
const ground = put(scene, new THREE.PlaneGeometry(14, 14), new THREE.MeshPhongMaterial({ color: 0x667766 }), 0, -0.8, 0);
ground.rotation.x = -Math.PI / 2;
ground.receiveShadow = arm.castShadow = blob.castShadow = true;
scene.add(arm);
turn((frame) => {
  bones.forEach((bone, i) => { if (i) bone.rotation.z = 0.5 * Math.sin(0.1 * frame + i); });
  blob.morphTargetInfluences = [0.5 + 0.5 * Math.sin(0.1 * frame), 0.5 + 0.5 * Math.cos(0.13 * frame)];
  renderer.render(scene, camera);
});
