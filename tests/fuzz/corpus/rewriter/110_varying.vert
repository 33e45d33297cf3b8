
attribute vec3 position;
varying vec4 color;
uniform mat4 m;
void main() { gl_Position = m * vec4(position, 1.0); color = gl_Color; gl_TexCoord[0] = gl_MultiTexCoord0; }
