// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A helix as a cartoon, balls and sticks, and a surface that one sees through.
import * as $3Dmol from "3dmol";
import { box } from "./canvas_stage.js";
import { helix } from "./molecule_stage.js";
const viewer = $3Dmol.createViewer(box("div"), { backgroundColor: "#223" });
viewer.addModel(helix(), "pdb");
viewer.setStyle({}, { cartoon: { color: "spectrum" } });
viewer.setStyle({ resi: "1-8" }, { stick: { radius: 0.25 }, sphere: { scale: 0.3 } });
viewer.addSurface($3Dmol.SurfaceType.VDW, { opacity: 0.6, color: "white" }, { resi: "16-20" });
viewer.addArrow({ start: { x: 8, y: 0, z: -10 }, end: { x: 8, y: 0, z: 6 }, radius: 0.8, color: "orange" });
viewer.addBox({ center: { x: -9, y: 0, z: 5 }, dimensions: { w: 4, h: 4, d: 4 }, color: "teal" });
viewer.addCylinder({ start: { x: -9, y: 0, z: -12 }, end: { x: -9, y: 0, z: -4 }, radius: 1.2, fromCap: 1, toCap: 2, color: "violet" });
viewer.zoomTo();
viewer.rotate(90, "y");
setInterval(() => { viewer.rotate(3, "x"); viewer.render(); }, 60);
