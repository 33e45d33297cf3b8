#version 400
subroutine vec3 look(vec3 c);
subroutine(look) vec3 same(vec3 c) { return c; }
subroutine uniform look chosen;
in vec3 p; out vec3 c; void main() { c = chosen(p); gl_Position = vec4(p, 1); }
