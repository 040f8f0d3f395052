// SPDX-License-Identifier: Apache-2.0
#include "stress/libraries.hpp"

#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace stress {
namespace {

std::set<std::string> asked;

/// A copy of the library's file that only this process sees, loaded as a library of its own.
void* load_copy(const std::string& file) {
  const int memory = memfd_create("vesica", 0);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (memory < 0 || write(memory, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("cannot copy " + file);
  }
  const std::string path = "/proc/self/fd/" + std::to_string(memory);
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  if (handle == nullptr) throw std::runtime_error(dlerror());
  return handle;  // the file stays open: its path is the copy's name, which no other copy may have
}

std::string library_file() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&vesica_version), &info) == 0) throw std::runtime_error("no library");
  return info.dli_fname;
}

std::string isa_name(void* handle) {
  const auto function = reinterpret_cast<const char* (*)()>(dlsym(handle, "vesica_isa_name"));
  if (function == nullptr) throw std::runtime_error("no vesica_isa_name");
  return function();
}

std::vector<Loaded> load_each() {
  std::vector<Loaded> result;
  const char* before = std::getenv("VESICA_ISA");
  const std::string kept = before != nullptr ? before : "";
  for (const char* isa : {"portable", "sse2", "avx2", "avx512", "neon"}) {
    setenv("VESICA_ISA", isa, 1);
    void* handle = load_copy(library_file());
    if (isa_name(handle) == isa) {
      result.push_back({isa, handle});
    } else {
      dlclose(handle);
    }
  }
  if (before != nullptr) {
    setenv("VESICA_ISA", kept.c_str(), 1);
  } else {
    unsetenv("VESICA_ISA");
  }
  return result;
}

}  // namespace

const std::vector<Loaded>& loaded() {
  static const std::vector<Loaded> all = load_each();
  return all;
}

void* find_symbol(const Loaded& library, const std::string& symbol) {
  asked.insert(symbol);
  void* found = dlsym(library.handle, symbol.c_str());
  if (found == nullptr) throw std::runtime_error("no " + symbol);
  return found;
}

const std::set<std::string>& functions_asked() { return asked; }

}  // namespace stress
