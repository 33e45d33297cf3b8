#version 300 es
layout(location = 0) in vec4 position; in uint kind;
flat out highp uint k; out vec2 uv;
void main() { k = kind + uint(gl_InstanceID); uv = position.xy; gl_Position = position; }
