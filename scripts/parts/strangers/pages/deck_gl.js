// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Columns, extruded polygons, grid cells, balls and models with light.
import { AmbientLight, Deck, DirectionalLight, LightingEffect, OrbitView, COORDINATE_SYSTEM } from "@deck.gl/core";
import { ColumnLayer, GridCellLayer, PolygonLayer, PointCloudLayer } from "@deck.gl/layers";
import { SimpleMeshLayer } from "@deck.gl/mesh-layers";
import { SphereGeometry } from "@luma.gl/engine";
import { box, turn } from "./canvas_stage.js";
const effect = new LightingEffect({ sky: new AmbientLight({ intensity: 0.8 }), sun: new DirectionalLight({ intensity: 1.5, direction: [-1, -2, -3], _shadow: false }) });
const points = [...Array(8).keys()].map((i) => ({ at: [4 * Math.cos(i * 0.8), 4 * Math.sin(i * 0.8), 0], size: 1 + (i % 4) }));
const common = { coordinateSystem: COORDINATE_SYSTEM.CARTESIAN, data: points, getPosition: (d) => d.at, material: { ambient: 0.3, diffuse: 0.7, shininess: 40 } };
const ball = new SphereGeometry({ nlat: 8, nlong: 12, radius: 0.8 });
const layers = [new ColumnLayer({ ...common, id: "columns", diskResolution: 9, radius: 0.7, extruded: true, radiusUnits: "common", getElevation: (d) => d.size, elevationScale: 1, getFillColor: (d) => [220, 60 * d.size, 80] }),
  new PolygonLayer({ ...common, id: "walls", data: [{ at: [[-2, -2], [2, -2], [2.4, 0], [0, 2], [-2, 1]] }], getPolygon: (d) => d.at, extruded: true, getElevation: 1, getFillColor: [90, 160, 220] }),
  new SimpleMeshLayer({ ...common, id: "balls", mesh: ball, getPosition: (d) => [1.6 * d.at[0], 1.6 * d.at[1], 1], getColor: (d) => [60 * d.size, 200, 120] }),
  new PointCloudLayer({ ...common, id: "cloud", pointSize: 8, getPosition: (d) => [d.at[0], d.at[1], 6], getNormal: [0, 0, 1], getColor: [255, 220, 80] })];
let angle = 0;
const deck = new Deck({ parent: box("div"), width: 460, height: 340, views: new OrbitView({ orbitAxis: "Z" }), effects: [effect], layers, viewState: { target: [0, 0, 1], rotationX: 35, rotationOrbit: 0, zoom: 4.3 }, parameters: { clearColor: [0.2, 0.25, 0.3, 1] } });
turn(() => deck.setProps({ viewState: { target: [0, 0, 1], rotationX: 35, rotationOrbit: (angle += 3), zoom: 4.3 } }));
