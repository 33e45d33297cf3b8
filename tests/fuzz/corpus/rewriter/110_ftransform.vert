 void main() {
  gl_Position = ftransform();
  gl_FrontColor = gl_Color; gl_BackColor = vec4(1);
}
