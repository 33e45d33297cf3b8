// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Shapes with shadows in Hilo3d.
import { box } from "./canvas_stage.js";
import "hilo3d/build/Hilo3d.js";
const H = window.Hilo3d;
const camera = new H.PerspectiveCamera({ aspect: 460 / 340, far: 100, near: 0.1, y: 2, z: 8 });
camera.lookAt(new H.Vector3(0, 0, 0));
const stage = new H.Stage({ container: box("div"), camera, clearColor: new H.Color(0.2, 0.25, 0.3), width: 460, height: 340, pixelRatio: 1 });
const paint = (r, g, b, more) => new H.BasicMaterial({ diffuse: new H.Color(r, g, b), ...more });
const add = (geometry, material, x, y) => { const mesh = new H.Mesh({ geometry, material, x, y, onUpdate() { this.rotationY += 3; this.rotationX += 1; } }); stage.addChild(mesh); return mesh; };
add(new H.SphereGeometry({ radius: 0.9, heightSegments: 8, widthSegments: 12 }), paint(0.9, 0.3, 0.3), -2.2, 0.9);
add(new H.BoxGeometry({ width: 1.2, height: 1.2, depth: 1.2 }), paint(0.3, 0.8, 0.4), 0, 0.9);
add(new H.SphereGeometry({ radius: 0.9, heightSegments: 6, widthSegments: 8 }), paint(0.3, 0.5, 0.9, { transparency: 0.5, transparent: true }), 2.2, 0.9);
add(new H.SphereGeometry({ radius: 0.8, heightSegments: 6, widthSegments: 9 }), paint(0.9, 0.8, 0.3, { wireframe: true }), -1.2, -1.2);
add(new H.PlaneGeometry({ width: 1.6, height: 1.6, widthSegments: 3, heightSegments: 3 }), paint(0.8, 0.5, 0.8, { side: H.constants.FRONT_AND_BACK }), 1.2, -1.2);
stage.addChild(new H.AmbientLight({ color: new H.Color(1, 1, 1), amount: 0.3 }));
stage.addChild(new H.DirectionalLight({ color: new H.Color(1, 1, 1), direction: new H.Vector3(-1, -2, -2), shadow: { width: 512, height: 512 } }));
const ticker = new H.Ticker(60);
ticker.addTick(stage);
ticker.start(true);
