// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// A globe with bars, arcs, rings, labels, and an atmosphere.
import Globe from "globe.gl";
import { box } from "./canvas_stage.js";
const places = [...Array(30).keys()].map((i) => ({ lat: 70 * Math.sin(i * 2.1), lng: 360 * (i * 0.37 % 1) - 180, size: 0.1 + 0.4 * (i % 5) / 5, color: ["tomato", "gold", "skyblue"][i % 3] }));
const globe = new Globe(box("div"), { animateIn: false }).width(460).height(340).backgroundColor("#223").globeCurvatureResolution(12).showGraticules(true)
  .pointsData(places).pointAltitude("size").pointColor("color").pointRadius(2).pointResolution(8).pointsTransitionDuration(0)
  .arcsData(places.slice(0, 8).map((one, i) => ({ startLat: one.lat, startLng: one.lng, endLat: places[i + 9].lat, endLng: places[i + 9].lng }))).arcStroke(1.2).arcColor(() => "lime").arcsTransitionDuration(0)
  .hexBinPointsData(places).hexBinPointWeight(1).hexBinResolution(1).hexAltitude(0.15).hexTopColor(() => "orchid").hexSideColor(() => "purple").hexTransitionDuration(0);
globe.globeMaterial().color.set("#58a");
globe.controls().autoRotate = true;
globe.controls().autoRotateSpeed = 6;
