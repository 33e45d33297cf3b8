#version 330 core
layout(location = 0) in vec3 a, b[2];
layout(location = 4) in ivec4 n;
out vec3 color;
void main()
{
    // the end
    color = a + b[1] * float(n.x);
    gl_Position = vec4(color, 1.0);
}
