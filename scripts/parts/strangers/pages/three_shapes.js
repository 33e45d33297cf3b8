// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A plate with a hole and bevels, a lathe, a tube, a Klein bottle, a convex hull, a polyhedron, and a decal on a ball.
import * as THREE from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import { DecalGeometry } from "three/examples/jsm/geometries/DecalGeometry.js";
import { ParametricGeometry } from "three/examples/jsm/geometries/ParametricGeometry.js";
import { klein } from "three/examples/jsm/geometries/ParametricFunctions.js";
import { put, stage } from "./three_stage.js";
const { renderer, scene, camera, turn } = stage();
const paint = (color, more) => new THREE.MeshPhongMaterial({ color, shininess: 50, ...more });
const plate = new THREE.Shape();
plate.moveTo(-0.6, -0.6).lineTo(0.6, -0.6).quadraticCurveTo(0.9, 0, 0.6, 0.6).lineTo(0, 0.3).lineTo(-0.6, 0.6);
plate.holes.push(new THREE.Path().absarc(0, -0.2, 0.2, 0, 2 * Math.PI));
const extruded = new THREE.ExtrudeGeometry(plate, { depth: 0.3, curveSegments: 4, bevelEnabled: true, bevelSize: 0.05, bevelThickness: 0.06, bevelSegments: 2 });
const profile = [[0, -0.8], [0.5, -0.75], [0.3, -0.3], [0.6, 0.2], [0.35, 0.6], [0.4, 0.8]].map(([x, y]) => new THREE.Vector2(x, y));
const path = new THREE.CatmullRomCurve3([[-0.7, 0, 0], [0, 0.7, 0.3], [0.6, 0, -0.3], [0, -0.7, 0.2]].map((p) => new THREE.Vector3(...p)), true);
const hull = Array.from({ length: 24 }, (_, i) => new THREE.Vector3(0.7 * Math.sin(i * 1.7), 0.7 * Math.cos(i * 2.3), 0.7 * Math.sin(i * 3.1)));
const bottle = new ParametricGeometry(klein, 16, 16);
bottle.scale(0.09, 0.09, 0.09);
const things = [put(scene, extruded, paint(0xeeaa33), -2.1, 1.2, 0), put(scene, new THREE.LatheGeometry(profile, 9), paint(0x66bb66, { side: THREE.DoubleSide }), 0, 1.2, 0),
  put(scene, new THREE.TubeGeometry(path, 24, 0.16, 6, true), paint(0xdd5577), 2.1, 1.2, 0), put(scene, bottle, paint(0x5599dd, { side: THREE.DoubleSide }), -2.1, -0.8, 0.6),
  put(scene, new ConvexGeometry(hull), paint(0xbbbbbb), 2.1, -0.8, 0.6), put(scene, new THREE.DodecahedronGeometry(0.5, 0), paint(0xaa66dd), 0.9, -1, 1.5)];
const ball = put(scene, new THREE.SphereGeometry(0.7, 14, 10), paint(0xdddddd), -0.4, -0.7, 0.8);
ball.updateMatrixWorld();
const decal = new DecalGeometry(ball, new THREE.Vector3(-0.3, -0.5, 1.4), new THREE.Euler(0, 0, 0), new THREE.Vector3(0.6, 0.6, 0.6));
scene.add(new THREE.Mesh(decal, paint(0x2233cc, { polygonOffset: true, polygonOffsetFactor: -4, depthWrite: false })));
turn((frame) => { things.forEach((thing) => { thing.rotation.y = 0.05 * frame; }); camera.position.x = Math.sin(0.04 * frame); camera.lookAt(0, 0.2, 0); renderer.render(scene, camera); });
