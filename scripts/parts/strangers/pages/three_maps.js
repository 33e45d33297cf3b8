// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A normal map, a displacement map, a vertex stage that waves, marching cubes that change in each frame, and a depth pass first.
import * as THREE from "three";
import { MarchingCubes } from "three/examples/jsm/objects/MarchingCubes.js";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage();
const picture = (paint) => {
  const data = new Uint8Array(4 * 64 * 64);
  for (let y = 0; y < 64; y++) for (let x = 0; x < 64; x++) data.set(paint(x, y), 4 * (64 * y + x));
  const texture = new THREE.DataTexture(data, 64, 64);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
};
const bumps = picture((x, y) => [128 + 100 * Math.sin(x * 0.8), 128 + 100 * Math.sin(y * 0.8), 220, 255]);
const hills = picture((x, y) => Array(3).fill(128 + 127 * Math.sin(x * 0.2) * Math.sin(y * 0.2)).concat(255));
const waving = new THREE.MeshStandardMaterial({ color: 0x55cc99 });
const time = { value: 0 };
waving.onBeforeCompile = (shader) => {
  shader.uniforms.time = time;
  shader.vertexShader = "uniform float time;\n" + shader.vertexShader.replace("#include <begin_vertex>", "vec3 transformed = position * (1. + .15 * sin(time + 5. * position.y));");
};
const things = [put(scene, new THREE.SphereGeometry(0.8, 12, 8), new THREE.MeshStandardMaterial({ color: 0xcc9966, normalMap: bumps }), -2, 0.8, 0),
  put(scene, new THREE.SphereGeometry(0.7, 20, 14), new THREE.MeshStandardMaterial({ color: 0x7788cc, displacementMap: hills, displacementScale: 0.3 }), 0, 0.8, 0),
  put(scene, new THREE.SphereGeometry(0.7, 14, 10), waving, 2, 0.8, 0)];
const blobs = new MarchingCubes(14, new THREE.MeshPhongMaterial({ color: 0xdd6666, shininess: 80 }), false, false, 6000);
blobs.position.set(-1, -0.9, 1);
const first = put(scene, new THREE.TorusKnotGeometry(0.5, 0.2, 40, 6), new THREE.MeshBasicMaterial({ colorWrite: false }), 1.3, -0.8, 1);
const second = put(scene, first.geometry, new THREE.MeshPhongMaterial({ color: 0x44aaff, transparent: true, opacity: 0.6, depthFunc: THREE.EqualDepth }), 1.3, -0.8, 1);
second.renderOrder = 1;
scene.add(blobs);
turn((frame) => {
  time.value = 0.1 * frame;
  things.forEach((thing) => { thing.rotation.y = 0.04 * frame; });
  first.rotation.y = second.rotation.y = 0.05 * frame;
  blobs.reset();
  for (let i = 0; i < 4; i++) blobs.addBall(0.5 + 0.22 * Math.sin(0.07 * frame + 2 * i), 0.5 + 0.2 * Math.cos(0.09 * frame + i), 0.5, 0.6, 12);
  blobs.update();
  renderer.render(scene, camera);
});
