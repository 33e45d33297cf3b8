#version 450
#if 0
in vec3 position[;
#elif defined
void main( { gl_Position = /* 
