
#version 150 compatibility
struct S { vec3 a; float b[2]; };
in vec3 position; in mat4 instance;
out Face { vec3 normal; S s; flat int id; } face[2];
layout(std140) uniform Camera { mat4 m; };
void main() { face[0].normal = position; face[1].s.b[1] = 2.0; face[1].id = gl_VertexID; gl_Position = instance * m * vec4(position, 1); }
