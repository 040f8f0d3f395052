// SPDX-License-Identifier: Apache-2.0
/// Overlap of arrays in a device's memory: pairs a second of every two kinds, in float and double, in step and one
/// shape against many, beside the rate at which the device copies memory. The arrays are greater than its caches.
///
/// usage: vesica_bench_cuda [--pairs N] [PART]...     rows whose names hold every PART, N pairs each (2^24)
///
/// Exit status: 0; 1 where an answer differs from the library's or the device reports an error; 2 for wrong arguments;
/// 3 where there is no device.
#include <vesica.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "cuda/any_pair.hpp"
#include "cuda/device_memory.hpp"
#include "quantile.hpp"
#include "random.hpp"
#include "workloads.hpp"

namespace vesica::bench {
namespace {

constexpr int passes = 9;
constexpr std::size_t checked = 4096;  // pairs of each row, against the library

struct Options {
  std::size_t pairs = std::size_t{1} << 24;
  std::vector<std::string> parts;
};

/// Milliseconds between two events of the device.
class Timer {
 public:
  Timer() {
    must_succeed(cudaEventCreate(&start_));
    must_succeed(cudaEventCreate(&stop_));
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer() {
    static_cast<void>(cudaEventDestroy(start_));
    static_cast<void>(cudaEventDestroy(stop_));
  }

  /// The median time of what `queue` queues, in seconds; once more before, to warm up.
  template <class Queue>
  double median_of(const Queue& queue) {
    std::vector<double> seconds;
    for (int i = 0; i <= passes; ++i) {
      must_succeed(cudaEventRecord(start_));
      must_succeed(queue());
      must_succeed(cudaEventRecord(stop_));
      must_succeed(cudaEventSynchronize(stop_));
      float milliseconds = 0;
      must_succeed(cudaEventElapsedTime(&milliseconds, start_, stop_));
      if (i > 0) seconds.push_back(1e-3 * static_cast<double>(milliseconds));
    }
    return median(seconds);
  }

 private:
  cudaEvent_t start_{}, stop_{};
};

/// Bytes a second, read and written.
double copy_rate(Timer& timer, std::size_t bytes) {
  const DeviceMemory<std::uint8_t> from(bytes), to(bytes);
  const double seconds =
      timer.median_of([&] { return cudaMemcpyAsync(to.get(), from.get(), bytes, cudaMemcpyDeviceToDevice); });
  return 2 * static_cast<double>(bytes) / seconds;
}

std::int32_t library_overlap(int kind_a, const double* a, int kind_b, const double* b) {
  return vesica_overlap_f64(kind_a, a, kind_b, b);
}
std::int32_t library_overlap(int kind_a, const float* a, int kind_b, const float* b) {
  return vesica_overlap_f32(kind_a, a, kind_b, b);
}

struct Kinds {
  std::int32_t a, b;
  const char *name_a, *name_b;
};
constexpr Kinds pairs_of_kinds[] = {
#define VESICA_KINDS(a, A, b, B) {static_cast<std::int32_t>(Kind::a), static_cast<std::int32_t>(Kind::b), #a, #b},
    VESICA_EACH_PAIR_OF_FORMS(VESICA_KINDS)
#undef VESICA_KINDS
};
constexpr int field_counts[] = {
#define VESICA_FIELDS(name, Name) ShapeTraits<Name<float>>::fields,
    VESICA_EACH_SHAPE(VESICA_FIELDS)
#undef VESICA_FIELDS
};

/// Columns of shapes drawn from a pool.
template <class T>
std::vector<T> columns_of(std::int32_t kind, const std::vector<Numbers>& pool,
                          const std::vector<std::uint32_t>& drawn) {
  std::vector<T> numbers;
  numbers.reserve(drawn.size() * static_cast<std::size_t>(field_counts[kind]));
  for (std::size_t k = 0; k < static_cast<std::size_t>(field_counts[kind]); ++k) {
    for (const std::uint32_t i : drawn) numbers.push_back(static_cast<T>(pool[i][k]));
  }
  return numbers;
}
template <class T>
std::array<T, 7> shape_of(std::int32_t kind, const std::vector<T>& columns, std::size_t count, std::size_t i) {
  std::array<T, 7> shape{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(field_counts[kind]); ++k) shape[k] = columns[k * count + i];
  return shape;
}

std::vector<std::uint32_t> draw(std::size_t count, std::size_t pool, Random& random) {
  std::vector<std::uint32_t> drawn(count);
  for (std::uint32_t& i : drawn) i = static_cast<std::uint32_t>(random.index(pool));
  return drawn;
}

/// One row, in one scalar and one form; returns how many of the checked answers are wrong.
template <class T>
std::size_t run_row(const std::string& name, const Kinds& kinds, const Pool& pool, bool one, std::size_t pairs,
                    Timer& timer, double copied) {
  Random random(seed_of_run());
  const std::vector<std::uint32_t> drawn_b = draw(pairs, pool.b.size(), random);
  const std::vector<std::uint32_t> drawn_a =
      pool.matched && !one ? drawn_b : draw(one ? 1 : pairs, pool.a.size(), random);
  const std::vector<T> numbers_a = columns_of<T>(kinds.a, pool.a, drawn_a),
                       numbers_b = columns_of<T>(kinds.b, pool.b, drawn_b);
  const auto count = static_cast<std::int64_t>(pairs);
  const DeviceColumns<T> a(kinds.a, one ? 1 : count, numbers_a), b(kinds.b, count, numbers_b);
  const DeviceMemory<std::uint8_t> out(pairs);
  const DeviceWork work(count);
  const double seconds = timer.median_of([&] { return overlap_any(a.shapes(), b.shapes(), out.get(), work.work()); });

  const std::vector<std::uint8_t> answers = out.read(pairs);
  std::size_t hits = 0, wrong = work.invalid();
  for (const std::uint8_t answer : answers) hits += answer;
  for (std::size_t i = 0; i < pairs && i < checked; ++i) {
    const auto shape_a = shape_of(kinds.a, numbers_a, drawn_a.size(), one ? 0 : i);
    const auto shape_b = shape_of(kinds.b, numbers_b, pairs, i);
    wrong += answers[i] != library_overlap(kinds.a, shape_a.data(), kinds.b, shape_b.data());
  }
  const auto numbers = static_cast<std::size_t>(field_counts[kinds.b] + (one ? 0 : field_counts[kinds.a]));
  const double n = static_cast<double>(pairs), bytes = n * static_cast<double>(numbers * sizeof(T) + 1);
  std::printf("%-40s %4.0f%% %10.2f %9.0f %6.0f%% %6zu\n", name.c_str(), 100 * static_cast<double>(hits) / n,
              1e-9 * n / seconds, 1e-9 * bytes / seconds, 100 * bytes / seconds / copied, wrong);
  return wrong;
}

bool is_asked(const std::string& name, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (name.find(part) == std::string::npos) return false;
  }
  return true;
}

std::size_t run_pair(const Kinds& kinds, Workload workload, const Options& options, Timer& timer, double copied) {
  const std::string start = std::string(kinds.name_a) + "_" + kinds.name_b, end = std::string("/") + name_of(workload);
  std::size_t wrong = 0;
  Pool pool;
  for (const bool one : {false, true}) {
    for (const bool f32 : {true, false}) {
      const std::string name = start + (f32 ? "/f32" : "/f64") + (one ? "/one" : "/step") + end;
      if (!is_asked(name, options.parts) || (one && workload == Workload::near)) continue;
      if (pool.a.empty()) pool = make_pool(kinds.a, kinds.b, workload, seed_of_run());
      wrong += f32 ? run_row<float>(name, kinds, pool, one, options.pairs, timer, copied)
                   : run_row<double>(name, kinds, pool, one, options.pairs, timer, copied);
    }
  }
  return wrong;
}

int run(const Options& options) {
  Timer timer;
  cudaDeviceProp device{};
  must_succeed(cudaGetDeviceProperties(&device, 0));
  const double copied = copy_rate(timer, options.pairs * 32);
  std::printf("%s, %d multiprocessors; copies memory at %.0f GB/s, read and written\n", device.name,
              device.multiProcessorCount, 1e-9 * copied);
  std::printf("%-40s %5s %10s %9s %7s %6s\n", "pair/scalar/form/workload", "hits", "1e9 pair/s", "GB/s", "of copy",
              "wrong");
  std::size_t wrong = 0;
  for (const Kinds& kinds : pairs_of_kinds) {
    for (const Workload workload : {Workload::rare, Workload::mixed, Workload::most, Workload::near}) {
      if (has_workload(kinds.a, kinds.b, workload)) wrong += run_pair(kinds, workload, options, timer, copied);
    }
  }
  return wrong == 0 ? 0 : 1;
}

bool read(int count, char** words, Options& options) {
  for (int i = 1; i < count; ++i) {
    if (std::strcmp(words[i], "--pairs") != 0) {
      options.parts.emplace_back(words[i]);
      continue;
    }
    if (++i == count) return false;
    options.pairs = std::strtoull(words[i], nullptr, 10);
    if (options.pairs < 1 || options.pairs > cuda::most_pairs) return false;
  }
  return true;
}

}  // namespace
}  // namespace vesica::bench

int main(int count, char** words) {
  using namespace vesica::bench;
  Options options;
  if (!read(count, words, options)) {
    std::fprintf(stderr, "usage: %s [--pairs N] [PART]...\n", words[0]);
    return 2;
  }
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) {
    std::fprintf(stderr, "bench cuda: no CUDA device; nothing was measured\n");
    return 3;
  }
  try {
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench cuda: %s\n", error.what());
    return 1;
  }
}
