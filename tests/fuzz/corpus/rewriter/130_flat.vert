‚#version 130
in vec4 position; flat out ivec2 cell; noperspective out vec3 c; centroid out float d;
int counter = 1;
void main() { counter++; cell = ivec2(position.xy); c = position.xyz; d = float(counter); gl_Position = position; }
