// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// The primitives of p5: with strokes and without, by lights, a normal material, and a model that it builds.
import p5 from "p5";
new p5((p) => {
  p.setup = () => { p.createCanvas(460, 340, p.WEBGL); p.pixelDensity(1); };
  p.draw = () => {
    p.background(50, 60, 80);
    p.ambientLight(80);
    p.directionalLight(255, 255, 255, -0.5, 1, -0.7);
    p.pointLight(120, 80, 40, 200, -200, 200);
    const at = (x, y, paint, shape) => { p.push(); p.translate(x, y, 0); p.rotateY(0.05 * p.frameCount); p.rotateX(0.03 * p.frameCount); paint(); shape(); p.pop(); };
    at(-150, -80, () => { p.noStroke(); p.specularMaterial(220, 80, 80); p.shininess(20); }, () => p.sphere(50, 10, 8));
    at(0, -80, () => { p.noStroke(); p.fill(90, 200, 110); }, () => p.torus(40, 15, 12, 8));
    at(150, -80, () => { p.stroke(0); p.fill(90, 140, 220); }, () => p.cylinder(35, 80, 9, 1));
    at(-150, 80, () => { p.noStroke(); p.normalMaterial(); }, () => p.ellipsoid(40, 55, 30, 10, 8));
    at(0, 80, () => { p.stroke(255); p.fill(220, 200, 90); }, () => p.box(60));
    at(150, 80, () => { p.noStroke(); p.fill(200, 120, 200, 140); }, () => p.cone(40, 80, 9, 2));
  };
});
