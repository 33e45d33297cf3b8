// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Primitives with shadows, a pane, and a camera that turns.
import * as pc from "playcanvas";
import { box } from "./canvas_stage.js";
const app = new pc.Application(box(), {});
app.start();
app.scene.ambientLight = new pc.Color(0.25, 0.25, 0.3);
const entity = (name, kind, what, x, y, z) => { const one = new pc.Entity(name); one.addComponent(kind, what); one.setPosition(x, y, z); app.root.addChild(one); return one; };
const eye = entity("eye", "camera", { clearColor: new pc.Color(0.2, 0.25, 0.35) }, 0, 2.5, 7);
eye.lookAt(0, 0, 0);
entity("sun", "light", { type: "directional", castShadows: true, shadowBias: 0.2, normalOffsetBias: 0.05, shadowDistance: 20, shadowResolution: 512 }, 0, 0, 0).setEulerAngles(45, 30, 0);
entity("lamp", "light", { type: "omni", color: new pc.Color(1, 0.6, 0.3), range: 8, castShadows: true }, -1, 2.5, 2);
const paint = (r, g, b, opacity = 1) => { const one = new pc.StandardMaterial(); one.diffuse = new pc.Color(r, g, b); one.gloss = 0.6; one.opacity = opacity; if (opacity < 1) one.blendType = pc.BLEND_NORMAL; one.update(); return one; };
const shape = (geometry, material, x, z) => {
  const one = entity("shape", "render", { meshInstances: [new pc.MeshInstance(pc.Mesh.fromGeometry(app.graphicsDevice, geometry), material)], castShadows: true, receiveShadows: true }, x, 0.3, z);
  return one;
};
const things = [shape(new pc.SphereGeometry({ radius: 0.7, latitudeBands: 8, longitudeBands: 12 }), paint(0.9, 0.3, 0.3), -2.2, 0), shape(new pc.TorusGeometry({ tubeRadius: 0.25, ringRadius: 0.55, sides: 12, segments: 8 }), paint(0.3, 0.8, 0.4), -0.3, -0.5),
  shape(new pc.CapsuleGeometry({ radius: 0.4, height: 1.5, heightSegments: 1, sides: 8 }), paint(0.3, 0.5, 0.9), 1.3, 0), shape(new pc.ConeGeometry({ baseRadius: 0.6, peakRadius: 0, height: 1.3, heightSegments: 2, capSegments: 9 }), paint(0.9, 0.8, 0.3), 2.6, -0.4),
  shape(new pc.CylinderGeometry({ radius: 0.4, height: 1.1, heightSegments: 1, capSegments: 9 }), paint(0.8, 0.5, 0.8, 0.5), 0.4, 1.5), shape(new pc.BoxGeometry(), paint(0.7, 0.7, 0.7), -1.4, 1.6)];
const ground = entity("ground", "render", { type: "plane", material: paint(0.5, 0.55, 0.5) }, 0, -0.6, 0);
ground.setLocalScale(12, 1, 12);
app.on("update", () => { things.forEach((thing, i) => thing.rotate(0.5 * i, 3, 0)); });
