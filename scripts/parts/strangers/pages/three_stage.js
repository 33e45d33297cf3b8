// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A renderer, a camera and lights for the pages of three.js.
import * as THREE from "three";

export function stage(options = {}) {
  const renderer = new THREE.WebGLRenderer({ antialias: options.antialias ?? false, stencil: true });
  renderer.setSize(460, 340);
  document.body.appendChild(renderer.domElement);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x334455);
  const camera = new THREE.PerspectiveCamera(45, 460 / 340, 0.1, 60);
  camera.position.set(0, 2.4, 6.5);
  camera.lookAt(0, 0.2, 0);
  const sun = new THREE.DirectionalLight(0xffffff, 2.5);
  sun.position.set(3, 5, 4);
  scene.add(sun, new THREE.HemisphereLight(0x99bbff, 0x553322, 0.8));
  const turn = (draw) => {
    let frame = 0;
    renderer.setAnimationLoop(() => draw(frame++));
  };
  return { renderer, scene, camera, sun, turn };
}

export function put(scene, geometry, material, x, y, z) {
  const mesh = new THREE.Mesh(geometry, material);
  mesh.position.set(x, y, z);
  scene.add(mesh);
  return mesh;
}
