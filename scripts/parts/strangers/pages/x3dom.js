// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// X3D in a page: primitives, an extrusion, an elevation grid, a crease angle, shadows.
import "x3dom/x3dom.js";
import { box } from "./canvas_stage.js";
const shape = (at, color, geometry, more = "") => `<Transform translation="${at}" rotation="0 1 0 0" class="thing"><Shape><Appearance><Material diffuseColor="${color}" specularColor=".4 .4 .4" ${more}></Material></Appearance>${geometry}</Shape></Transform>`;
const place = box("div");
place.innerHTML = `<X3D width="460px" height="340px"><Scene><Background skyColor=".2 .25 .3"></Background><Viewpoint position="0 2.4 8" orientation="1 0 0 -.25"></Viewpoint>
  <DirectionalLight direction="-1 -2 -1" intensity=".9" shadowIntensity=".6" shadowMapSize="512"></DirectionalLight>
  ${shape("-2.6 1 0", ".9 .3 .3", '<Sphere radius=".8" subdivision="12,8"></Sphere>')}${shape("0 1 0", ".3 .8 .4", '<Torus innerRadius=".25" outerRadius=".7" subdivision="10,12"></Torus>')}
  ${shape("2.6 1 0", ".3 .5 .9", '<Cylinder radius=".6" height="1.3" subdivision="9"></Cylinder>')}${shape("-2.6 -.8 1", ".9 .8 .3", '<Cone bottomRadius=".7" height="1.3" subdivision="9"></Cone>', 'transparency=".4"')}
  ${shape("0 -.8 1", ".8 .5 .8", '<Extrusion solid="false" creaseAngle="1" crossSection=".4 0 0 .4 -.4 0 0 -.4 .4 0" spine="-.8 -.5 0 -.3 0 .3 .3 .3 0 .8 .6 -.3"></Extrusion>')}
  ${shape("2 -.8 .4", ".6 .6 .6", '<ElevationGrid solid="false" creaseAngle="3" xDimension="5" zDimension="5" xSpacing=".4" zSpacing=".4" height="0 .1 .2 .1 0 .1 .4 .6 .4 .1 .2 .6 1 .6 .2 .1 .4 .6 .4 .1 0 .1 .2 .1 0"></ElevationGrid>')}
  <Transform translation="0 -1.7 0"><Shape><Appearance><Material diffuseColor=".5 .55 .5"></Material></Appearance><Box size="9 .2 6"></Box></Shape></Transform></Scene></X3D>`;
let angle = 0;
setInterval(() => { angle += 0.05; for (const one of document.querySelectorAll(".thing")) one.setAttribute("rotation", `0 1 0 ${angle}`); }, 60);
