attribute highp vec4 position; attribute vec2 uv;
uniform mediump mat4 m;
varying lowp vec2 coordinate;
precision mediump float;
void main() { coordinate = uv; gl_Position = m * position; }
