// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A surface with contours, a mesh from points, cones and balls in one plot.
import Plotly from "plotly.js-gl3d-dist-min";
import { box } from "./canvas_stage.js";
const side = [...Array(16).keys()], chart = box("div");
const z = side.map((i) => side.map((j) => 3 * Math.sin(0.4 * i) * Math.cos(0.5 * j)));
const cloud = Array.from({ length: 40 }, (_, i) => [4 + 3 * Math.sin(1.7 * i), 4 + 3 * Math.cos(2.3 * i), 8 + 2 * Math.sin(3.1 * i)]);
Plotly.newPlot(chart, [{ type: "surface", z, contours: { z: { show: true } }, showscale: false },
  { type: "mesh3d", x: cloud.map((p) => p[0]), y: cloud.map((p) => p[1]), z: cloud.map((p) => p[2]), alphahull: 0, color: "#d54", flatshading: false },
  { type: "cone", x: [11, 13], y: [4, 4], z: [8, 8], u: [1, 1], v: [0, 1], w: [2, 1], showscale: false, sizeref: 2 },
  { type: "scatter3d", x: side, y: side, z: side.map((i) => 6 + Math.sin(i)), mode: "markers+lines", marker: { size: 5 } }],
{ width: 460, height: 340, margin: { l: 0, r: 0, t: 0, b: 0 }, showlegend: false });
let frame = 0;
setInterval(() => Plotly.relayout(chart, { "scene.camera.eye": { x: 1.7 * Math.cos(0.05 * ++frame), y: 1.7 * Math.sin(0.05 * frame), z: 0.9 } }), 60);
