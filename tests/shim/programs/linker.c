// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Prints the dynamic linker's answers. The output must be the same with and without the shim.
#include <dlfcn.h>
#include <stdio.h>

static void report(const char* what, void* found) {
  const char* error = dlerror();
  printf("%s: %s, %s\n", what, found ? "found" : "not found", error ? error : "no error");
}

int main(void) {
  report("default without GL", dlsym(RTLD_DEFAULT, "glDrawArrays"));
  report("default egl without GL", dlsym(RTLD_DEFAULT, "eglMakeCurrent"));
  report("new function without GL", dlsym(RTLD_DEFAULT, "glNoSuchFunction"));
  void* math = dlopen("libm.so.6", RTLD_NOW);
  report("other library", dlsym(math, "glDrawArrays"));
  report("other library by version", dlvsym(math, "glDrawArrays", "GLIBC_2.2.5"));
  report("other function", dlsym(math, "cos"));
  report("next", dlsym(RTLD_NEXT, "getenv"));
  report("no next", dlsym(RTLD_NEXT, "main"));
  report("no library", dlopen("libNoSuchLibrary.so", RTLD_NOW));
  void* program = dlopen(NULL, RTLD_NOW);
  report("program without GL", dlsym(program, "glDrawArrays"));
  void* mesa = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  (void)dlsym(mesa, "glNoSuchFunction");
  report("error is replaced by success", dlsym(mesa, "glDrawArrays"));
  (void)dlsym(mesa, "glNoSuchFunction");
  printf("error is kept: %s\n", dlerror() ? "yes" : "no");
  return 0;
}
