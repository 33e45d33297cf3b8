#version 320 es
precision highp float;
layout(location = 0) in vec3 position; out Block { vec3 n; } b;
void main() { b.n = position; gl_Position = vec4(position, 1.0); }
