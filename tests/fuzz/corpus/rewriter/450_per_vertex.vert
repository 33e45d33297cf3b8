#version 450
#extension GL_ARB_shader_draw_parameters : require
layout(location = 0) in vec4 position;
out gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[2]; invariant float gl_PointSize; };
layout(location = 1, component = 2) out vec2 uv;
void main() { gl_Position = position + float(gl_DrawIDARB); gl_ClipDistance[0] = 1.0; uv = position.xy; }
