// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// The primitives of twgl by one program.
import * as twgl from "twgl.js";
import { box, turn } from "./canvas_stage.js";
const gl = box().getContext("webgl"), m4 = twgl.m4;
const program = twgl.createProgramInfo(gl, [`uniform mat4 all, world; attribute vec4 position; attribute vec3 normal; varying vec3 n; void main() { n = (world * vec4(normal, 0)).xyz; gl_Position = all * position; }`,
  `precision mediump float; varying vec3 n; uniform vec3 color; void main() { vec3 u = normalize(n); gl_FragColor = vec4(color * (.25 + .75 * max(dot(u, normalize(vec3(1, 2, 3))), 0.)) + .4 * pow(max(dot(u, normalize(vec3(1, 2, 5))), 0.), 40.), 1); }`]);
const make = twgl.primitives;
const shapes = [make.createSphereBufferInfo(gl, 0.8, 12, 8), make.createTorusBufferInfo(gl, 0.6, 0.25, 12, 8), make.createTruncatedConeBufferInfo(gl, 0.7, 0.2, 1.4, 9, 2), make.createCylinderBufferInfo(gl, 0.5, 1.3, 9, 1),
  make.createCubeBufferInfo(gl, 1), make.createCresentBufferInfo(gl, 0.8, 0.8, 0.5, 0.3, 8), make.create3DFBufferInfo(gl), make.createDiscBufferInfo(gl, 0.8, 10)];
turn((frame) => {
  gl.enable(gl.DEPTH_TEST);
  gl.clearColor(0.2, 0.25, 0.3, 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.useProgram(program.program);
  const view = m4.multiply(m4.perspective(0.8, 460 / 340, 0.5, 30), m4.inverse(m4.lookAt([0, 1, 7], [0, 0, 0], [0, 1, 0])));
  shapes.forEach((shape, i) => {
    let world = m4.rotateX(m4.rotateY(m4.translation([-3 + 2 * (i % 4), i < 4 ? 1.1 : -1.1, 0]), 0.05 * frame), 0.02 * frame);
    if (i === 6) world = m4.translate(m4.scale(world, [0.009, -0.009, 0.009]), [-50, -75, -15]);
    twgl.setBuffersAndAttributes(gl, program, shape);
    twgl.setUniforms(program, { world, all: m4.multiply(view, world), color: [0.4 + 0.5 * ((i * 0.37) % 1), 0.4 + 0.5 * ((i * 0.61) % 1), 0.4 + 0.5 * ((i * 0.83) % 1)] });
    twgl.drawBufferInfo(gl, shape);
  });
});
