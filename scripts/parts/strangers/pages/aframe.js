// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Primitives of A-Frame with shadows.
import "aframe";
import { box } from "./canvas_stage.js";
const spin = 'animation="property: rotation; to: 0 360 0; loop: true; dur: 6000; easing: linear" shadow="cast: true; receive: true"';
box("div").innerHTML = `<a-scene embedded style="width: 460px; height: 340px" vr-mode-ui="enabled: false" loading-screen="enabled: false" background="color: #345">
  <a-entity camera position="0 2 6" rotation="-14 0 0" look-controls="enabled: false"></a-entity>
  <a-light type="ambient" intensity=".5"></a-light><a-light type="directional" position="2 4 3" intensity="2" light="castShadow: true"></a-light>
  <a-sphere position="-2.4 .9 0" radius=".8" segments-width="12" segments-height="8" color="#d44" ${spin}></a-sphere>
  <a-torus-knot position="0 1 0" radius=".5" radius-tubular=".18" segments-tubular="40" segments-radial="6" color="#4d6" ${spin}></a-torus-knot>
  <a-cylinder position="2.4 .8 0" radius=".6" height="1.3" segments-radial="9" color="#48d" ${spin}></a-cylinder>
  <a-cone position="-1.2 .4 1.8" radius-bottom=".5" height="1" segments-radial="8" color="#dc4" ${spin}></a-cone>
  <a-icosahedron position="1.2 .4 1.8" radius=".5" color="#c7c" ${spin}></a-icosahedron>
  <a-plane rotation="-90 0 0" width="9" height="7" color="#787" shadow="receive: true"></a-plane></a-scene>`;
