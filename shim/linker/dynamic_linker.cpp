// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/linker/dynamic_linker.h"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>

namespace glark::shim {
namespace {

// Returns an address of the dynamic section. glibc has already relocated it on most machines, but not on MIPS and
// RISC-V.
template <class T>
const T* dynamic_address(const link_map& object, ElfW(Addr) value) {
  return reinterpret_cast<const T*>(value >= object.l_addr ? value : value + object.l_addr);
}

struct SymbolTable {
  const ElfW(Sym) * symbols = nullptr;
  const char* strings = nullptr;
  const std::uint32_t* gnu_hash = nullptr;
};

SymbolTable symbol_table(const link_map& object) {
  SymbolTable table;
  for (const ElfW(Dyn)* entry = object.l_ld; entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_SYMTAB) table.symbols = dynamic_address<ElfW(Sym)>(object, entry->d_un.d_ptr);
    if (entry->d_tag == DT_STRTAB) table.strings = dynamic_address<char>(object, entry->d_un.d_ptr);
    if (entry->d_tag == DT_GNU_HASH) table.gnu_hash = dynamic_address<std::uint32_t>(object, entry->d_un.d_ptr);
  }
  return table;
}

// DT_GNU_HASH holds: bucket count, index of the first hashed symbol, words of the Bloom filter, its shift, the
// filter, the buckets, the chains (whose last entry has bit 0 set).
const ElfW(Sym) * find_defined(const SymbolTable& table, std::string_view name) {
  if (table.symbols == nullptr || table.strings == nullptr || table.gnu_hash == nullptr) return nullptr;
  const std::uint32_t bucket_count = table.gnu_hash[0];
  const std::uint32_t first_hashed = table.gnu_hash[1];
  const std::uint32_t* buckets = table.gnu_hash + 4 + table.gnu_hash[2] * (sizeof(ElfW(Addr)) / 4);
  const std::uint32_t* chains = buckets + bucket_count;
  std::uint32_t hash = 5381;
  for (const char c : name) hash = hash * 33 + static_cast<unsigned char>(c);
  for (std::uint32_t i = bucket_count == 0 ? 0 : buckets[hash % bucket_count]; i >= first_hashed && i != 0; ++i) {
    const std::uint32_t entry = chains[i - first_hashed];
    const ElfW(Sym)& symbol = table.symbols[i];
    if ((entry | 1) == (hash | 1) && symbol.st_shndx != SHN_UNDEF && name == table.strings + symbol.st_name)
      return &symbol;
    if (entry & 1) break;
  }
  return nullptr;
}

bool may_define_dlvsym(std::string_view path) {
  const std::string_view file = path.substr(path.rfind('/') + 1);
  return file.starts_with("libc.") || file.starts_with("libdl.") || file.starts_with("libc-") ||
         file.starts_with("libdl-");
}

// We cannot look up dlvsym by name, because that name is ours. glibc has it in libc.so.6, before 2.34 in libdl.so.2. We
// cannot call dl_iterate_phdr either: ThreadSanitizer interposes it and asks us for functions first. The list for
// debuggers has libc near its head and grows at its end, so reading it needs no lock.
void* address_of_dlvsym() {
  for (const link_map* object = _r_debug.r_map; object != nullptr; object = object->l_next) {
    if (object->l_name == nullptr || !may_define_dlvsym(object->l_name)) continue;
    if (const ElfW(Sym)* symbol = find_defined(symbol_table(*object), "dlvsym"); symbol != nullptr)
      return reinterpret_cast<void*>(object->l_addr + symbol->st_value);
  }
  return nullptr;
}

// Returns whether the object was linked with a library of this file name.
bool needs(const link_map& object, std::string_view file) {
  const SymbolTable table = symbol_table(object);
  for (const ElfW(Dyn)* entry = object.l_ld; entry->d_tag != DT_NULL && table.strings != nullptr; ++entry)
    if (entry->d_tag == DT_NEEDED && table.strings + entry->d_un.d_val == file) return true;
  return false;
}

bool defines_any(const link_map& object, std::span<const char* const> names) {
  const SymbolTable table = symbol_table(object);
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return find_defined(table, name) != nullptr; });
}

std::string_view file_of(std::string_view path) { return path.substr(path.rfind('/') + 1); }

DynamicLinker find_linker() {
  DynamicLinker linker;
  linker.dlvsym = reinterpret_cast<decltype(linker.dlvsym)>(address_of_dlvsym());
  if (linker.dlvsym == nullptr) return linker;
  // Symbol versions: glibc 2.34, then older glibc on x86-64, AArch64 and i386.
  const auto find = [&](const char* name) {
    void* function = nullptr;
    for (const char* version : {"GLIBC_2.34", "GLIBC_2.2.5", "GLIBC_2.17", "GLIBC_2.1", "GLIBC_2.0"})
      if (function == nullptr) function = linker.dlvsym(RTLD_NEXT, name, version);
    return function;
  };
  linker.dlsym = reinterpret_cast<decltype(linker.dlsym)>(find("dlsym"));
  linker.dlopen = reinterpret_cast<decltype(linker.dlopen)>(find("dlopen"));
  return linker;
}

bool is_gl_library(std::string_view path) {
  const std::string_view file = path.substr(path.rfind('/') + 1);
  constexpr std::array names{"libGL.so", "libOpenGL.so", "libGLESv2.so", "libGLX.so", "libEGL.so", "libOSMesa.so"};
  for (const char* name : names)
    if (file.starts_with(name)) return true;
  return false;
}

struct Collected {
  bool (*wanted)(std::string_view path, std::string_view library);
  std::string_view library;
  std::vector<std::string> paths;
};

int collect_library(dl_phdr_info* object, std::size_t, void* collected) {
  auto& found = *static_cast<Collected*>(collected);
  if (found.wanted(object->dlpi_name, found.library)) found.paths.emplace_back(object->dlpi_name);
  return 0;
}

// Only the names of loaded libraries are returned, so that no lookup fails and disturbs dlerror().
std::vector<std::string> loaded_gl_libraries() {
  Collected found{[](std::string_view path, std::string_view) { return is_gl_library(path); }, {}, {}};
  dl_iterate_phdr(collect_library, &found);
  return found.paths;
}

std::vector<std::string> loaded_libraries(std::string_view library) {
  Collected found{
      [](std::string_view path, std::string_view name) { return file_of(path).starts_with(name); }, library, {}};
  dl_iterate_phdr(collect_library, &found);
  return found.paths;
}

void* symbol_of_libraries(const std::vector<std::string>& paths, const char* name) {
  for (const std::string& path : paths) {
    void* library = real_linker().dlopen(path.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
    if (library == nullptr) continue;
    void* symbol = real_linker().dlsym(library, name);
    dlclose(library);
    if (symbol != nullptr) return symbol;
  }
  return nullptr;
}

}  // namespace

// There is no static initialisation guard, because sanitizers interpose it. Threads that race here find the same
// functions.
const DynamicLinker& real_linker() {
  static constinit DynamicLinker linker;
  static constinit std::atomic<bool> found{false};
  if (!found.load(std::memory_order_acquire)) {
    const DynamicLinker fresh = find_linker();
    std::atomic_ref(linker.dlsym).store(fresh.dlsym, std::memory_order_relaxed);
    std::atomic_ref(linker.dlvsym).store(fresh.dlvsym, std::memory_order_relaxed);
    std::atomic_ref(linker.dlopen).store(fresh.dlopen, std::memory_order_relaxed);
    found.store(true, std::memory_order_release);
  }
  return linker;
}

void* next_symbol(const char* name) {
  void* symbol = real_linker().dlsym(RTLD_NEXT, name);
  asm volatile("" : "+r"(symbol));  // prevents a tail call: RTLD_NEXT depends on the caller
  return symbol;
}

void* symbol_of_loaded_gl(const char* name) { return symbol_of_libraries(loaded_gl_libraries(), name); }

void* symbol_of_loaded(std::string_view library, const char* name) {
  return symbol_of_libraries(loaded_libraries(library), name);
}

void* find_symbol(const char* name) {
  void* symbol = next_symbol(name);
  return symbol != nullptr ? symbol : symbol_of_loaded_gl(name);
}

std::string gl_library_before_us(std::span<const char* const> names) {
  Dl_info info{};
  link_map* own = nullptr;
  if (dladdr1(reinterpret_cast<void*>(&real_linker), &info, reinterpret_cast<void**>(&own), RTLD_DL_LINKMAP) == 0)
    return {};
  bool linked = false;
  std::string before;
  for (const link_map* object = _r_debug.r_map; object != nullptr && object != own; object = object->l_next) {
    linked = linked || needs(*object, file_of(own->l_name));
    if (before.empty() && is_gl_library(object->l_name) && defines_any(*object, names)) before = object->l_name;
  }
  return linked ? before : std::string();
}

bool gl_is_loaded() { return !loaded_gl_libraries().empty(); }

bool in_main_program(const void* address) {
  static void* const main_base = [] {
    void* base = nullptr;
    // The first object is the main program.
    dl_iterate_phdr(
        [](dl_phdr_info* object, std::size_t, void* result) {
          Dl_info info{};
          for (int i = 0; i < object->dlpi_phnum; ++i)
            if (object->dlpi_phdr[i].p_type == PT_LOAD) {
              dladdr(reinterpret_cast<void*>(object->dlpi_addr + object->dlpi_phdr[i].p_vaddr), &info);
              break;
            }
          *static_cast<void**>(result) = info.dli_fbase;
          return 1;
        },
        &base);
    return base;
  }();
  Dl_info info{};
  return dladdr(address, &info) != 0 && info.dli_fbase == main_base;
}

void keep_loaded(const void* address) {
  Dl_info info{};
  if (dladdr(address, &info) == 0 || info.dli_fname == nullptr || in_main_program(address)) return;
  if (void* library = real_linker().dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE)) dlclose(library);
}

}  // namespace glark::shim
