// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A cut through three objects, whose cut faces are filled by the stencil buffer.
import * as THREE from "three";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage();
renderer.localClippingEnabled = true;
const plane = new THREE.Plane(new THREE.Vector3(0, 0, -1), 0.2);
const stencil = (side, operation) => new THREE.MeshBasicMaterial({ depthWrite: false, depthTest: false, colorWrite: false, stencilWrite: true, stencilFunc: THREE.AlwaysStencilFunc, side, clippingPlanes: [plane],
  stencilFail: operation, stencilZFail: operation, stencilZPass: operation });
const objects = [[new THREE.SphereGeometry(0.9, 12, 8), -2], [new THREE.TorusKnotGeometry(0.6, 0.22, 48, 8), 0.2], [new THREE.CylinderGeometry(0.5, 0.8, 1.6, 9), 2.2]].map(([geometry, x], i) => {
  const group = new THREE.Group();
  group.position.set(x, 0.3, 0);
  const back = new THREE.Mesh(geometry, stencil(THREE.BackSide, THREE.IncrementWrapStencilOp)), front = new THREE.Mesh(geometry, stencil(THREE.FrontSide, THREE.DecrementWrapStencilOp));
  back.renderOrder = front.renderOrder = 3 * i + 1;
  const body = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color: new THREE.Color().setHSL(i / 3, 0.6, 0.5), side: THREE.DoubleSide, clippingPlanes: [plane] }));
  body.renderOrder = 20;
  group.add(back, front, body);
  const cap = put(scene, new THREE.PlaneGeometry(8, 6), new THREE.MeshStandardMaterial({ color: 0xe91e63, stencilWrite: true, stencilRef: 0, stencilFunc: THREE.NotEqualStencilFunc,
    stencilFail: THREE.ReplaceStencilOp, stencilZFail: THREE.ReplaceStencilOp, stencilZPass: THREE.ReplaceStencilOp }), 0, 0, 0.2);
  cap.onAfterRender = () => renderer.clearStencil();
  cap.renderOrder = 3 * i + 2;
  scene.add(group);
  return { group, cap };
});
turn((frame) => {
  plane.constant = 0.3 * Math.sin(0.05 * frame);
  objects.forEach(({ group, cap }) => { group.children.forEach((one) => { one.rotation.x = 0.03 * frame; }); cap.position.z = plane.constant; });
  renderer.render(scene, camera);
});
