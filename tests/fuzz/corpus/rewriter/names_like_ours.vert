#version 130
in vec3 glark_chunk0, position; vec3 glark_lattice = position; out vec3 glark_w;
#line 7 3
void main() { glark_w = glark_lattice; gl_Position = vec4(glark_chunk0, 1); }
