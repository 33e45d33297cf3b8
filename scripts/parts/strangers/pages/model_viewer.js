// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A model that the page writes as glTF, in the viewer of Google, with its shadow on the ground.
import "@google/model-viewer/dist/model-viewer-umd.min.js";
import * as THREE from "three";
import { GLTFExporter } from "three/examples/jsm/exporters/GLTFExporter.js";
const scene = new THREE.Scene();
[[new THREE.SphereGeometry(0.6, 12, 8), 0xdd4444, -1.2], [new THREE.TorusKnotGeometry(0.4, 0.15, 40, 6), 0x44cc66, 0.2], [new THREE.CylinderGeometry(0.4, 0.4, 1.1, 9), 0x4488dd, 1.4]].forEach(([geometry, color, x]) => {
  const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color, roughness: 0.4 }));
  mesh.position.x = x;
  scene.add(mesh);
});
new GLTFExporter().parse(scene, (data) => {
  const viewer = document.createElement("model-viewer");
  viewer.style.cssText = "width: 460px; height: 340px; background: #345";
  viewer.setAttribute("shadow-intensity", "1");
  viewer.setAttribute("auto-rotate", "");
  viewer.setAttribute("auto-rotate-delay", "0");
  viewer.setAttribute("rotation-per-second", "60deg");
  viewer.setAttribute("interaction-prompt", "none");
  viewer.src = URL.createObjectURL(new Blob([data], { type: "model/gltf-binary" }));
  document.body.appendChild(viewer);
}, console.error, { binary: true });
