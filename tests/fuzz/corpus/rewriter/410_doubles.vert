#version 410
in dvec3 position; in dmat3x2 m; in vec3 normal; out vec3 n;
void main() { precise vec3 p = vec3(position); n = normal; gl_Position = vec4(p.xy + vec2(m[1]), p.z, 1.0); }
