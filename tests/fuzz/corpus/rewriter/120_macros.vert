#version 120
#define JOIN(a, b) a##b
#define LIGHTS 3
#ifdef GL_ARB_gpu_shader5
#extension GL_ARB_gpu_shader5 : require
#endif
attribute vec3 JOIN(pos, ition);
varying vec3 lights[LIGHTS];
void main() { for (int i = 0; i < LIGHTS; ++i) lights[i] = JOIN(pos, ition) * float(i);
  gl_Position = vec4(position, 1.0); }
