// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Wires over surfaces, hidden lines, edges, fat lines, points, sprites, and panes that one sees through.
import * as THREE from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { WireframeGeometry2 } from "three/examples/jsm/lines/WireframeGeometry2.js";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage();
const ball = new THREE.SphereGeometry(0.8, 12, 8), knot = new THREE.TorusKnotGeometry(0.5, 0.2, 40, 6);
const things = [put(scene, ball, new THREE.MeshPhongMaterial({ color: 0xcc5555, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }), -2, 0.9, 0),
  put(scene, knot, new THREE.MeshPhongMaterial({ color: 0x55cc77 }), 0, 0.9, 0),
  put(scene, new THREE.TorusGeometry(0.6, 0.25, 6, 10), new THREE.MeshPhongMaterial({ color: 0x6688dd, wireframe: true }), 2, 0.9, 0),
  put(scene, ball, new THREE.MeshPhongMaterial({ color: 0xddaa55, transparent: true, opacity: 0.5, side: THREE.DoubleSide }), -1.5, -0.9, 1),
  put(scene, new THREE.CylinderGeometry(0.6, 0.6, 1.2, 10, 1, true), new THREE.MeshPhongMaterial({ color: 0x55bbbb, side: THREE.DoubleSide }), 0.4, -0.9, 1),
  put(scene, new THREE.IcosahedronGeometry(0.7, 0), new THREE.MeshPhongMaterial({ color: 0xbb77cc, flatShading: true }), 2, -0.9, 1)];
things[0].add(new THREE.LineSegments(new THREE.WireframeGeometry(ball), new THREE.LineBasicMaterial({ color: 0x000000 })));
things[1].add(new LineSegments2(new WireframeGeometry2(knot), new LineMaterial({ color: 0xffffff, linewidth: 1.5, resolution: new THREE.Vector2(460, 340) })));
things[5].add(new THREE.LineSegments(new THREE.EdgesGeometry(things[5].geometry), new THREE.LineBasicMaterial({ color: 0xffffff })));
const shell = new THREE.Mesh(ball, new THREE.MeshBasicMaterial({ color: 0x000000, wireframe: true }));
things[3].add(shell, new THREE.Points(ball, new THREE.PointsMaterial({ color: 0xffff00, size: 0.08 })));
for (let i = 0; i < 12; i++) {
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ color: new THREE.Color().setHSL(i / 12, 1, 0.6) }));
  sprite.scale.setScalar(0.18);
  sprite.position.set(3 * Math.cos(i * Math.PI / 6), 0, 3 * Math.sin(i * Math.PI / 6));
  scene.add(sprite);
}
turn((frame) => { things.forEach((thing) => { thing.rotation.y = 0.05 * frame; }); renderer.render(scene, camera); });
