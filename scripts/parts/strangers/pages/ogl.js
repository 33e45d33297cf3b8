// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Ball, torus, cylinder and box with a shadow map, by programs of the page.
import { Box, Camera, Cylinder, Mesh, Plane, Program, Renderer, Shadow, Sphere, Torus, Transform } from "ogl";
import { turn } from "./canvas_stage.js";
const renderer = new Renderer({ width: 460, height: 340 }), gl = renderer.gl;
document.body.appendChild(gl.canvas);
gl.clearColor(0.2, 0.25, 0.3, 1);
const camera = new Camera(gl, { fov: 40 }), light = new Camera(gl, { left: -4, right: 4, bottom: -4, top: 4, near: 1, far: 20 });
camera.position.set(0, 2.5, 7);
camera.lookAt([0, 0, 0]);
light.position.set(3, 8, 4);
light.lookAt([0, 0, 0]);
const shadow = new Shadow(gl, { light, width: 512, height: 512 });
const vertex = `attribute vec3 position; attribute vec3 normal; uniform mat4 modelMatrix, viewMatrix, projectionMatrix, shadowViewMatrix, shadowProjectionMatrix; uniform mat3 normalMatrix;
  varying vec3 n; varying vec4 place;
  void main() { n = mat3(modelMatrix) * normal; vec4 world = modelMatrix * vec4(position, 1.); place = shadowProjectionMatrix * shadowViewMatrix * world; gl_Position = projectionMatrix * viewMatrix * world; }`;
const fragment = `precision highp float; varying vec3 n; varying vec4 place; uniform sampler2D tShadow; uniform vec3 color;
  float unpack(vec4 v) { return dot(v, vec4(1., 1. / 255., 1. / 65025., 1. / 16581375.)); }
  void main() { vec3 p = place.xyz / place.w * .5 + .5; float lit = unpack(texture2D(tShadow, p.xy)) + .005 < p.z ? .35 : 1.;
    gl_FragColor = vec4(color * (.25 + .75 * lit * max(dot(normalize(n), normalize(vec3(3, 8, 4))), 0.)), 1); }`;
const scene = new Transform();
const add = (geometry, color, x, y, z, casts = true) => {
  const mesh = new Mesh(gl, { geometry, program: new Program(gl, { vertex, fragment, uniforms: { color: { value: color } } }) });
  mesh.position.set(x, y, z);
  mesh.setParent(scene);
  shadow.add({ mesh, receive: true, cast: casts });
  return mesh;
};
const things = [add(new Sphere(gl, { radius: 0.8, widthSegments: 12, heightSegments: 8 }), [0.9, 0.3, 0.3], -2, 0.3, 0), add(new Torus(gl, { radius: 0.6, tube: 0.25, radialSegments: 8, tubularSegments: 12 }), [0.3, 0.8, 0.4], 0, 0.5, 0),
  add(new Cylinder(gl, { radiusTop: 0.4, radiusBottom: 0.6, height: 1.3, radialSegments: 9 }), [0.3, 0.5, 0.9], 2, 0.2, 0), add(new Box(gl), [0.9, 0.8, 0.3], 0.6, 0, 1.7)];
const ground = add(new Plane(gl, { width: 9, height: 7 }), [0.7, 0.7, 0.7], 0, -0.7, 0, false);
ground.rotation.x = -Math.PI / 2;
turn((frame) => { things.forEach((thing) => { thing.rotation.y = 0.05 * frame; }); shadow.render({ scene }); renderer.render({ scene, camera }); });
