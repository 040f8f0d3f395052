// SPDX-License-Identifier: Apache-2.0
/// The cost of the start: loading the library, the memory that this makes the process's own, and the first calls. Each
/// round is a process of its own. A page that the process only reads belongs to all who use the library.
#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace {

using Clock = std::chrono::steady_clock;
using Overlap = std::int32_t (*)(std::int32_t, const void*, std::int32_t, const void*);
constexpr int rounds = 7;

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

/// kB that the process has written in the mappings of a file.
long own_memory(const char* path) {
  std::FILE* maps = std::fopen("/proc/self/smaps", "r");
  if (maps == nullptr) return -1;
  char line[1024];
  bool inside = false;
  long sum = 0, kilobytes = 0;
  unsigned long low, high;
  while (std::fgets(line, sizeof line, maps) != nullptr) {
    if (std::sscanf(line, "%lx-%lx ", &low, &high) == 2) inside = std::strstr(line, path) != nullptr;
    if (inside && std::sscanf(line, "Anonymous: %ld", &kilobytes) == 1) sum += kilobytes;
  }
  std::fclose(maps);
  return sum;
}

double time_of_call(Overlap overlap, std::int32_t kind_a, std::int32_t kind_b) {
  constexpr double a[] = {0, 0, 1, 0, 1, 1}, b[] = {1.5, 1.25, 0.6, 0.8, 1, 1};
  const Clock::time_point start = Clock::now();
  const volatile std::int32_t answer = overlap(kind_a, a, kind_b, b);
  static_cast<void>(answer);
  return microseconds_since(start);
}

int one_round(const char* path) {
  const Clock::time_point start = Clock::now();
  void* library = dlopen(path, RTLD_NOW);
  if (library == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 1;
  }
  const double loading = microseconds_since(start);
  const long loaded = own_memory(path);
  Overlap overlap;
  void* symbol = dlsym(library, "vesica_overlap_f64");
  std::memcpy(&overlap, &symbol, sizeof overlap);
  constexpr std::int32_t rect = 4, ellipse = 5;
  const double first = time_of_call(overlap, rect, rect), second = time_of_call(overlap, ellipse, ellipse);
  std::printf("%10.0f %14ld %14.1f %18.1f %14ld\n", loading, loaded, first, second, own_memory(path));
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: vesica_bench_start LIBRARY\n");
    return 2;
  }
  std::printf("us, and kB of the process's own memory; targets: 20 us for the first call, 100 kB.\n");
  std::printf("%10s %14s %14s %18s %14s\n", "loading", "kB loaded", "first call", "first of ellipses", "kB called");
  std::fflush(stdout);
  for (int round = 0; round < rounds; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      const int failed = one_round(arguments[1]);
      std::fflush(stdout);
      _exit(failed);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0) return 1;
  }
}
