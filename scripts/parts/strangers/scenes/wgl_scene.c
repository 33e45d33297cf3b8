// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Lit shapes in a Windows program, for Wine in scripts/strangers: a ball, a tube with lids and a box, in display lists.
#include <math.h>
#include <windows.h>

#include <GL/gl.h>

static const double pi = 3.14159265358979;

static void lathe_corner(double turn, double radius, double height, double slope) {
  glNormal3d(cos(turn) * cos(slope), sin(turn) * cos(slope), sin(slope));
  glVertex3d(radius * cos(turn), radius * sin(turn), height);
}

static void ball(void) {
  for (int i = 0; i < 6; i++) {
    const double low = pi * (i / 6. - .5), high = pi * ((i + 1) / 6. - .5);
    glBegin(GL_QUAD_STRIP);
    for (int j = 0; j <= 10; j++) {
      lathe_corner(2 * pi * j / 10, cos(high), sin(high), high);
      lathe_corner(2 * pi * j / 10, cos(low), sin(low), low);
    }
    glEnd();
  }
}

static void tube(void) {
  glBegin(GL_TRIANGLE_STRIP);
  for (int j = 0; j <= 8; j++) {
    lathe_corner(2 * pi * j / 8, .5, 1, 0);
    lathe_corner(2 * pi * j / 8, .5, -1, 0);
  }
  glEnd();
  for (int side = -1; side <= 1; side += 2) {
    glBegin(GL_TRIANGLE_FAN);
    glNormal3d(0, 0, side);
    glVertex3d(0, 0, side);
    for (int j = 0; j <= 8; j++) lathe_corner(side * 2 * pi * j / 8, .5, side, side * pi / 2);
    glEnd();
  }
}

static void box(void) {
  glBegin(GL_QUADS);
  for (int axis = 0; axis < 3; axis++)
    for (int side = -1; side <= 1; side += 2)
      for (int corner = 0; corner < 4; corner++) {
        double place[3], normal[3] = {0, 0, 0};
        normal[axis] = place[axis] = side;
        place[(axis + 1) % 3] = (corner == 1 || corner == 2) ? 1 : -1;
        place[(axis + 2) % 3] = corner >= 2 ? side : -side;
        glNormal3dv(normal);
        glVertex3d(.6 * place[0], .6 * place[1], .6 * place[2]);
      }
  glEnd();
}

static void make_lists(void) {
  void (*const shapes[3])(void) = {ball, tube, box};
  for (int i = 0; i < 3; i++) {
    glNewList(i + 1, GL_COMPILE);
    shapes[i]();
    glEndList();
  }
}

static void draw(double angle) {
  static const float colours[3][4] = {{.8F, .3F, .2F, 1}, {.3F, .7F, .3F, 1}, {.3F, .4F, .9F, 1}};
  glClearColor(.1F, .1F, .2F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-.4, .4, -.3, .3, 1, 20);
  glMatrixMode(GL_MODELVIEW);
  for (int i = 0; i < 3; i++) {
    glLoadIdentity();
    glTranslated(2.2 * (i - 1), 0, -9);
    glRotated(angle, .4, 1, .2);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, colours[i]);
    glCallList(i + 1);
  }
}

static LRESULT CALLBACK answer(HWND window, UINT message, WPARAM word, LPARAM more) {
  if (message == WM_CLOSE) ExitProcess(0);
  return DefWindowProc(window, message, word, more);
}

int WINAPI WinMain(HINSTANCE instance, HINSTANCE before, LPSTR line, int show) {
  (void)before, (void)line, (void)show;
  const WNDCLASS kind = {.style = CS_OWNDC, .lpfnWndProc = answer, .hInstance = instance, .lpszClassName = "shapes"};
  RegisterClass(&kind);
  HWND window = CreateWindow("shapes", "shapes", WS_OVERLAPPEDWINDOW | WS_VISIBLE, 20, 20, 400, 300, 0, 0, instance, 0);
  HDC device = GetDC(window);
  const PIXELFORMATDESCRIPTOR wanted = {.nSize = sizeof wanted,
                                        .nVersion = 1,
                                        .cColorBits = 24,
                                        .cDepthBits = 24,
                                        .dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER};
  SetPixelFormat(device, ChoosePixelFormat(device, &wanted), &wanted);
  wglMakeCurrent(device, wglCreateContext(device));
  make_lists();
  const int states[] = {GL_DEPTH_TEST, GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE};
  for (int i = 0; i < 5; i++) glEnable(states[i]);
  for (double angle = 0;; angle += 3) {
    MSG message;
    while (PeekMessage(&message, 0, 0, 0, PM_REMOVE)) DispatchMessage(&message);
    draw(angle);
    SwapBuffers(device);
    Sleep(30);
  }
}
