// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Needs no GL library: reaches OSMesa by dlsym, a dlsym from dlvsym, or OSMesaGetProcAddress, or through a plug-in that
// is linked with it.
#include <stdlib.h>

#include "draw.h"

static void* by_dlsym(void* library, const char* name) { return dlsym(library, name); }

// GL libraries have no versions: dlvsym is how programs look for the dlsym behind an interposer.
static void* by_dlvsym(void* library, const char* name) {
  void* libc = dlopen("libc.so.6", RTLD_NOW);
  void* (*find)(void*, const char*) = (void* (*)(void*, const char*))dlvsym(libc, "dlsym", "GLIBC_2.34");
  if (find == NULL)
    find = (void* (*)(void*, const char*))dlvsym(dlopen("libdl.so.2", RTLD_NOW), "dlsym", "GLIBC_2.2.5");
  return find(library, name);
}

static void* by_get_proc(void* library, const char* name) {
  OSMESAproc (*get_proc)(const char*) = (OSMESAproc(*)(const char*))dlsym(library, "OSMesaGetProcAddress");
  return (void*)get_proc(name);
}

static int draw_by(void* (*find)(void*, const char*), void* library) {
  struct Functions gl;
  *(void**)&gl.clear = find(library, "glClear");
  *(void**)&gl.draw_arrays = find(library, "glDrawArrays");
  *(void**)&gl.vertex_pointer = find(library, "glVertexPointer");
  *(void**)&gl.enable_client_state = find(library, "glEnableClientState");
  *(void**)&gl.color = find(library, "glColor3f");
  *(void**)&gl.finish = find(library, "glFinish");
  *(void**)&gl.get_string = find(library, "glGetString");
  *(void**)&gl.get_error = find(library, "glGetError");
  *(void**)&gl.create = find(library, "OSMesaCreateContextExt");
  *(void**)&gl.make_current = find(library, "OSMesaMakeCurrent");
  *(void**)&gl.destroy = find(library, "OSMesaDestroyContext");
  printf("glDrawArrays is %s\n", is_ours(*(void**)&gl.draw_arrays) ? "ours" : "the driver's");
  printf("glClear is %s\n", is_ours(*(void**)&gl.clear) ? "ours" : "the driver's");
  printf("glDrawARP is %s\n", is_ours(find(library, "glDrawARP")) ? "ours" : "the driver's");
  return draw(&gl);
}

static int draw_by_plugin(const char* file, int flags) {
  void* library = dlopen(file, flags);
  if (library == NULL) return 4;
  int (*draw_as_plugin)(void) = (int (*)(void))dlsym(library, "draw_as_plugin");
  return draw_as_plugin();
}

int main(int argc, char** argv) {
  const char* way = argc > 1 ? argv[1] : "";
  if (strcmp(way, "plugin") == 0) return draw_by_plugin(argv[2], RTLD_NOW | RTLD_LOCAL);
  if (strcmp(way, "deepbind") == 0) return draw_by_plugin(argv[2], RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) return 4;
  if (strcmp(way, "dlsym") == 0) return draw_by(by_dlsym, library);
  if (strcmp(way, "dlvsym") == 0) return draw_by(by_dlvsym, library);
  if (strcmp(way, "get_proc") == 0) return draw_by(by_get_proc, library);
  return 5;
}
