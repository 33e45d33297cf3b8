// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Balls, a cube and a plane with shadows, beside sprites of Pixi.
import * as PIXI from "pixi.js";
import { Camera, Light, LightingEnvironment, LightType, Mesh3D, ShadowCastingLight, ShadowQuality, StandardMaterial, Color } from "pixi3d";
const app = new PIXI.Application({ width: 460, height: 340, backgroundColor: 0x334455, antialias: false });
document.body.appendChild(app.view);
Camera.main.position.set(0, 2, 7);
Camera.main.rotationQuaternion.setEulerAngles(12, 180, 0);
const paint = (mesh, r, g, b) => { mesh.material = new StandardMaterial(); mesh.material.baseColor = new Color(r, g, b); mesh.material.roughness = 0.4; mesh.material.metallic = 0; return app.stage.addChild(mesh); };
const things = [paint(Mesh3D.createSphere(), 0.9, 0.3, 0.3), paint(Mesh3D.createCube(), 0.3, 0.8, 0.4), paint(Mesh3D.createSphere(), 0.3, 0.5, 0.9)];
things.forEach((thing, i) => { thing.position.set(-2.4 + 2.4 * i, 0.3, 0); thing.scale.set(0.8, i === 2 ? 1.2 : 0.8, 0.8); });
const ground = paint(Mesh3D.createPlane(), 0.6, 0.6, 0.55);
ground.position.y = -1;
ground.scale.set(6, 1, 4);
const sun = new Light();
sun.type = LightType.directional;
sun.intensity = 3;
sun.rotationQuaternion.setEulerAngles(50, -40, 0);
LightingEnvironment.main.lights.push(sun);
const shadow = new ShadowCastingLight(app.renderer, sun, { shadowTextureSize: 512, quality: ShadowQuality.medium });
shadow.softness = 1;
shadow.shadowArea = 12;
const pipeline = app.renderer.plugins.pipeline;
[...things, ground].forEach((thing) => pipeline.enableShadows(thing, shadow));
const flag = app.stage.addChild(new PIXI.Graphics());
flag.beginFill(0xffcc00).drawCircle(40, 40, 20).endFill();
let frame = 0;
app.ticker.add(() => { frame++; things.forEach((thing) => thing.rotationQuaternion.setEulerAngles(frame, 3 * frame, 0)); });
