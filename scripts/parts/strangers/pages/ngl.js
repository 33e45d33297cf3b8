// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A helix as a cartoon, licorice, a tube, and shapes that the page adds.
import * as NGL from "ngl/dist/ngl.umd.js";
import { box } from "./canvas_stage.js";
import { helix } from "./molecule_stage.js";
const view = new NGL.Stage(box("div"), { backgroundColor: "#223", impostor: false, quality: "low" });
view.loadFile(new Blob([helix()]), { ext: "pdb" }).then((one) => {
  one.addRepresentation("cartoon", { sele: "1-14", disableImpostor: true });
  one.addRepresentation("licorice", { sele: "12-18", disableImpostor: true, sphereDetail: 0, radialSegments: 6 });
  one.addRepresentation("spacefill", { sele: "19-24", disableImpostor: true, sphereDetail: 1, opacity: 0.7 });
  const shape = new NGL.Shape("shapes", { disableImpostor: true, radialSegments: 8 });
  shape.addArrow([8, 0, -10], [8, 0, 4], [1, 0.6, 0], 0.9);
  shape.addEllipsoid([-9, 0, 6], [0.4, 0.8, 0.6], 1.5, [2.5, 0, 0], [0, 1.5, 0]);
  shape.addTorus([-9, 0, -6], [0.6, 0.5, 0.9], 2, [0, 1, 0], [1, 0, 0]);
  view.addComponentFromObject(shape).addRepresentation("buffer");
  view.autoView();
  setInterval(() => view.viewerControls.spin({ x: 1, y: 0.2, z: 0 }, 0.06), 60);
});
