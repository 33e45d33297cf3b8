// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// The bunny and the teapot of npm on a plane, with a shadow map that has positions only.
import createRegl from "regl";
import angleNormals from "angle-normals";
import bunny from "bunny";
import teapot from "teapot";
import { m4 } from "twgl.js";
import { box } from "./canvas_stage.js";
const regl = createRegl({ canvas: box(), attributes: { antialias: false } });
const plane = { positions: [[-30, 0, -30], [30, 0, -30], [30, 0, 30], [-30, 0, 30]], cells: [[0, 2, 1], [0, 3, 2]] };
const map = regl.framebuffer({ color: regl.texture({ width: 512, height: 512, type: "uint8" }), depth: true });
const model = (one) => ({ positions: regl.buffer(one.positions), normals: regl.buffer(angleNormals(one.cells, one.positions)), elements: regl.elements(one.cells) });
const both = { elements: regl.prop("elements"), uniforms: { light: regl.prop("light"), model: regl.prop("model") } };
const depth = regl({ ...both, attributes: { position: regl.prop("positions") }, framebuffer: map, vert: `precision highp float; attribute vec3 position; uniform mat4 light, model; varying float far; void main() { gl_Position = light * model * vec4(position, 1); far = gl_Position.z * .5 + .5; }`,
  frag: `precision highp float; varying float far; void main() { vec3 v = fract(far * vec3(1., 255., 65025.)); gl_FragColor = vec4(v - v.yzz * vec3(1. / 255., 1. / 255., 0.), 1.); }` });
const color = regl({ ...both, attributes: { position: regl.prop("positions"), normal: regl.prop("normals") }, uniforms: { ...both.uniforms, eye: regl.prop("eye"), color: regl.prop("color"), map },
  vert: `precision highp float; attribute vec3 position, normal; uniform mat4 light, model, eye; varying vec3 n, place; void main() { vec4 world = model * vec4(position, 1); n = mat3(model) * normal; place = (light * world).xyz * .5 + .5; gl_Position = eye * world; }`,
  frag: `precision highp float; varying vec3 n, place; uniform sampler2D map; uniform vec3 color; void main() { float lit = dot(texture2D(map, place.xy).xyz, vec3(1., 1. / 255., 1. / 65025.)) + .01 < place.z ? .3 : 1.; gl_FragColor = vec4(color * (.25 + .75 * lit * max(dot(normalize(n), normalize(vec3(2, 3, 2))), 0.)), 1); }` });
const models = [[model(bunny), [0.8, 0.6, 0.5], -8], [model(teapot), [0.4, 0.6, 0.9], 10], [model(plane), [0.6, 0.7, 0.6], 0]];
const light = m4.multiply(m4.ortho(-35, 35, -35, 35, 1, 120), m4.inverse(m4.lookAt([40, 60, 40], [0, 0, 0], [0, 1, 0])));
regl.frame(({ tick }) => {
  const eye = m4.multiply(m4.perspective(0.8, 460 / 340, 1, 200), m4.inverse(m4.lookAt([35 * Math.sin(0.04 * tick), 25, 35 * Math.cos(0.04 * tick)], [0, 3, 0], [0, 1, 0])));
  const draws = models.map(([parts, paint, x], i) => ({ ...parts, color: paint, eye, light, model: m4.scale(m4.translation([x, 0, 0]), i === 1 ? [0.7, 0.7, 0.7] : [1, 1, 1]) }));
  regl.clear({ framebuffer: map, color: [1, 1, 1, 1], depth: 1 });
  depth(draws);
  regl.clear({ color: [0.2, 0.25, 0.3, 1], depth: 1 });
  color(draws);
});
