// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// dlsym, dlvsym and dlopen for the program. RTLD_NEXT, RTLD_DEFAULT and RUNPATH depend on the caller, which the dynamic
// linker finds by the return address. So we jump to the real function with the program's return address and arguments
// in place, and never call it.
#include <dlfcn.h>

#include "shim/linker/dynamic_linker.h"
#include "shim/names/name_table.h"
#include "shim/names/real_functions.h"

namespace glark::shim {
namespace {

// Returned in two registers: the answer, or `decided` 0 if the real function shall answer.
struct Decision {
  void* address = nullptr;
  long decided = 0;
};

void* look_up(void* handle, const char* name, const char* version) {
  const DynamicLinker& linker = real_linker();
  return version == nullptr ? linker.dlsym(handle, name) : linker.dlvsym(handle, name, version);
}

// Returns whether the program would find this name without us.
bool exists_without_us(const Name& entry) {
  if (entry.kind == NameKind::ours) return gl_is_loaded();
  if (void* symbol = next_symbol(entry.name); symbol != nullptr && symbol != entry.wrapper) return true;
  return symbol_of_loaded_gl(entry.name) != nullptr;
}

bool in_other_namespace(void* handle) {
  Lmid_t id = LM_ID_BASE;
  return dlinfo(handle, RTLD_DI_LMID, &id) == 0 && id != LM_ID_BASE;
}

// The global scope has our export first, or a definition by the program itself. In the second case, the program means
// its own function.
Decision decide_in_scope_with_us(const Name& entry) {
  if (look_up(RTLD_DEFAULT, entry.name, nullptr) != entry.wrapper) return {};
  if (entry.kind == NameKind::ours || exists_without_us(entry)) return {};
  next_symbol(entry.name);  // fails, and sets the error that the program expects, except for the object's name
  return {nullptr, 1};
}

Decision decide(void* handle, const char* name, const char* version) {
  real_linker();
  if (handle == RTLD_NEXT || name == nullptr) return {};
  const Name* entry = find_name(name);
  if (entry == nullptr) return {};
  if (handle == RTLD_DEFAULT) return decide_in_scope_with_us(*entry);
  if (in_other_namespace(handle)) return {};
  if (entry->kind == NameKind::ours) return gl_is_loaded() ? Decision{entry->wrapper, 1} : Decision{};
  void* real = look_up(handle, name, version);
  if (real == nullptr) return {nullptr, 1};
  if (real == entry->wrapper) return decide_in_scope_with_us(*entry);
  if (in_main_program(real)) return {real, 1};
  if (entry->kind == NameKind::window_system) note_real_window_function(name, real);
  return {entry->wrapper, 1};
}

}  // namespace
}  // namespace glark::shim

#define GLARK_HIDDEN extern "C" __attribute__((visibility("hidden"), used))

extern "C" {
__attribute__((visibility("hidden"), used)) constinit void* glark_real_dlsym = nullptr;
__attribute__((visibility("hidden"), used)) constinit void* glark_real_dlvsym = nullptr;
__attribute__((visibility("hidden"), used)) constinit void* glark_real_dlopen = nullptr;
}

GLARK_HIDDEN void glark_find_real_linker() {
  const glark::shim::DynamicLinker& linker = glark::shim::real_linker();
  glark_real_dlsym = reinterpret_cast<void*>(linker.dlsym);
  glark_real_dlvsym = reinterpret_cast<void*>(linker.dlvsym);
  glark_real_dlopen = reinterpret_cast<void*>(linker.dlopen);
}

// C++ functions with C names, because their return type is not a C type.
__attribute__((visibility("hidden"), used)) glark::shim::Decision glark_decide_dlsym(
    void* handle, const char* name) __asm__("glark_decide_dlsym");
__attribute__((visibility("hidden"), used)) glark::shim::Decision glark_decide_dlvsym(
    void* handle, const char* name, const char* version) __asm__("glark_decide_dlvsym");

glark::shim::Decision glark_decide_dlsym(void* handle, const char* name) {
  if (glark_real_dlopen == nullptr) glark_find_real_linker();
  return glark::shim::decide(handle, name, nullptr);
}

glark::shim::Decision glark_decide_dlvsym(void* handle, const char* name, const char* version) {
  if (glark_real_dlopen == nullptr) glark_find_real_linker();
  return glark::shim::decide(handle, name, version);
}

#if defined(__x86_64__)

// %rdi, %rsi, %rdx hold the arguments, %rax and %rdx the decision. Three pushes keep the stack aligned at the call.
asm(R"(
.macro GLARK_SAVE_ARGUMENTS
  pushq %rdi
  .cfi_adjust_cfa_offset 8
  pushq %rsi
  .cfi_adjust_cfa_offset 8
  pushq %rdx
  .cfi_adjust_cfa_offset 8
.endm
.macro GLARK_RESTORE_ARGUMENTS
  popq %rdx
  .cfi_adjust_cfa_offset -8
  popq %rsi
  .cfi_adjust_cfa_offset -8
  popq %rdi
  .cfi_adjust_cfa_offset -8
.endm
.macro GLARK_LOOKUP name
  .globl \name
  .type \name, @function
\name:
  .cfi_startproc
  endbr64
  GLARK_SAVE_ARGUMENTS
  call glark_decide_\name
  movq %rdx, %rcx
  GLARK_RESTORE_ARGUMENTS
  testq %rcx, %rcx
  jnz 1f
  movq glark_real_\name(%rip), %rax
  jmp *%rax
1: ret
  .cfi_endproc
  .size \name, . - \name
.endm

.text
GLARK_LOOKUP dlsym
GLARK_LOOKUP dlvsym

.globl dlopen
.type dlopen, @function
dlopen:
  .cfi_startproc
  endbr64
  andl $~8, %esi   # RTLD_DEEPBIND would hide us from the library
  cmpq $0, glark_real_dlopen(%rip)
  jne 1f
  GLARK_SAVE_ARGUMENTS
  call glark_find_real_linker
  GLARK_RESTORE_ARGUMENTS
1: movq glark_real_dlopen(%rip), %rax
  jmp *%rax
  .cfi_endproc
  .size dlopen, . - dlopen
)");
static_assert(RTLD_DEEPBIND == 8);

#elif defined(__i386__)

// The asm functions ask these where to jump. Null: `answer` is the program's.
GLARK_HIDDEN void* glark_target_of_dlsym(void* handle, const char* name, const char*, void** answer) {
  const glark::shim::Decision decision = glark_decide_dlsym(handle, name);
  *answer = decision.address;
  return decision.decided ? nullptr : glark_real_dlsym;
}

GLARK_HIDDEN void* glark_target_of_dlvsym(void* handle, const char* name, const char* version, void** answer) {
  const glark::shim::Decision decision = glark_decide_dlvsym(handle, name, version);
  *answer = decision.address;
  return decision.decided ? nullptr : glark_real_dlvsym;
}

GLARK_HIDDEN void* glark_target_of_dlopen() {
  if (glark_real_dlopen == nullptr) glark_find_real_linker();
  return glark_real_dlopen;
}

// Arguments are on the stack, above the return address. %eax gets the target, %edx the answer. dlsym has no version:
// the word in its place is not used.
asm(R"(
.macro GLARK_LOOKUP name
  .globl \name
  .type \name, @function
\name:
  .cfi_startproc
  endbr32
  subl $4, %esp
  .cfi_adjust_cfa_offset 4
  pushl %esp
  .cfi_adjust_cfa_offset 4
  pushl 20(%esp)
  .cfi_adjust_cfa_offset 4
  pushl 20(%esp)
  .cfi_adjust_cfa_offset 4
  pushl 20(%esp)
  .cfi_adjust_cfa_offset 4
  call glark_target_of_\name
  addl $16, %esp
  .cfi_adjust_cfa_offset -16
  popl %edx
  .cfi_adjust_cfa_offset -4
  testl %eax, %eax
  jz 1f
  jmp *%eax
1: movl %edx, %eax
  ret
  .cfi_endproc
  .size \name, . - \name
.endm

.text
GLARK_LOOKUP dlsym
GLARK_LOOKUP dlvsym

.globl dlopen
.type dlopen, @function
dlopen:
  .cfi_startproc
  endbr32
  andl $~8, 8(%esp)   # RTLD_DEEPBIND would hide us from the library
  call glark_target_of_dlopen
  jmp *%eax
  .cfi_endproc
  .size dlopen, . - dlopen
)");
static_assert(RTLD_DEEPBIND == 8);

#else

// An optimising compiler turns the last call of these functions into a jump, so the real function sees the program's
// return address.
#define GLARK_EXPORT extern "C" __attribute__((visibility("default")))

GLARK_EXPORT void* dlsym(void* handle, const char* name) noexcept {
  const glark::shim::Decision decision = glark_decide_dlsym(handle, name);
  if (decision.decided) return decision.address;
  return reinterpret_cast<void* (*)(void*, const char*)>(glark_real_dlsym)(handle, name);
}

GLARK_EXPORT void* dlvsym(void* handle, const char* name, const char* version) noexcept {
  const glark::shim::Decision decision = glark_decide_dlvsym(handle, name, version);
  if (decision.decided) return decision.address;
  return reinterpret_cast<void* (*)(void*, const char*, const char*)>(glark_real_dlvsym)(handle, name, version);
}

GLARK_EXPORT void* dlopen(const char* file, int flags) noexcept {
  if (glark_real_dlopen == nullptr) glark_find_real_linker();
  return reinterpret_cast<void* (*)(const char*, int)>(glark_real_dlopen)(file, flags & ~RTLD_DEEPBIND);
}

#endif
