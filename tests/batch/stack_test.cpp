// SPDX-License-Identifier: Apache-2.0
// vesica.h promises that calls about arrays or an index use at most 176 KiB of stack. Measured on a thread whose stack
// was painted first, with numbers so far apart in magnitude that the exact stage is deepest.
#include <gtest/gtest.h>
#include <pthread.h>
#include <vesica.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "batch/data.hpp"
#include "capi/face.hpp"

namespace stack_test {
namespace {

using namespace batch_tests;
using capi_tests::Face;

constexpr std::size_t promised = 176 * 1024;
constexpr std::size_t page = 4096;
constexpr std::byte paint{0xA5};

/// Bytes of stack that work(argument) used, with all that a thread needs for itself.
std::size_t stack_used(void* (*work)(void*), void* argument) {
  constexpr std::size_t size = 4 * promised;
  std::vector<std::byte> memory(size + page, paint);
  void* start = memory.data();
  std::size_t space = memory.size();
  auto* stack = static_cast<std::byte*>(std::align(page, size, start, space));
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, stack, size);
  pthread_t thread;
  if (pthread_create(&thread, &attributes, work, argument) != 0) throw std::runtime_error("no thread");
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  const auto* deepest = std::find_if(stack, stack + size, [](std::byte b) { return b != paint; });
  return static_cast<std::size_t>(stack + size - deepest);
}

/// Bytes aligned as indexes must be.
struct Aligned {
  explicit Aligned(std::int64_t bytes) : size(bytes), memory(static_cast<std::size_t>(bytes) + 64) {}
  void* get() {
    void* start = memory.data();
    std::size_t space = memory.size();
    return std::align(64, static_cast<std::size_t>(size), start, space);
  }
  std::int64_t size;
  std::vector<std::byte> memory;
};

template <class T>
struct Call {
  typename Face<T>::Shapes a, b, one;
  std::vector<std::uint8_t> out;
  std::vector<std::int64_t> indices, others;
  std::vector<T> distances;
  Aligned index, scratch;
};

template <class T>
void* call_all(void* argument) {
  auto& call = *static_cast<Call<T>*>(argument);
  Face<T>::overlap_many(&call.a, &call.b, call.out.data());
  Face<T>::overlap_matrix(&call.one, &call.b, call.out.data(), 0);
  const auto room = static_cast<std::int64_t>(call.indices.size());
  Face<T>::overlap_select(&call.one, &call.b, call.indices.data(), room);
  auto some = call.b;
  some.count = 60;
  T *const column = call.distances.data(), *const none = nullptr;
  Face<T>::relation_many(&call.a, &call.b, call.out.data());
  Face<T>::nearest_many(&call.a, &call.b, column, none, none, none, none);
  Face<T>::nearest_matrix(&call.one, &call.b, column, 0);
  Face<T>::boundary_distance_many(&call.a, &call.b, column, none, none, none, none);
  Face<T>::signed_distance_many(&call.a, &call.b, column);
  Face<T>::within_many(&call.a, &call.b, T(1), call.out.data());
  Face<T>::depth_many(&call.a, &call.b, column, none, none);
  Face<T>::area_many(&call.a, &call.b, column);
  Face<T>::iou_matrix(&call.one, &call.b, column, 0);
  const T velocity[] = {T(1), T(1)};
  Face<T>::cast_many(&call.a, &call.b, velocity, velocity, 0, T(1), column, none, none, none, none);
  typename Face<T>::Impact impact;
  Face<T>::cast_first(&call.one, &some, T(1), T(1), T(1), &impact);
  void *const index = call.index.get(), *const scratch = call.scratch.get();
  Face<T>::index_build(&some, 1, index, call.index.size, scratch, call.scratch.size);
  std::int64_t state[3][4] = {};
  Face<T>::index_select(index, &some, 1, &call.one, call.indices.data(), room, state[0]);
  Face<T>::index_nearest(index, &some, 1, &call.one, room, std::numeric_limits<T>::infinity(), call.indices.data(),
                         call.distances.data());
  Face<T>::index_cast_first(index, &some, 1, &call.one, 1, 1, 1, &impact);
  Face<T>::join(VESICA_JOIN_OVERLAP, index, &some, 1, index, &some, 1, 0, 1, scratch, call.scratch.size,
                call.indices.data(), call.others.data(), room, state[1]);
  Face<T>::join_within(index, &some, 1, index, &some, 1, 1, 0, 1, call.indices.data(), call.others.data(), room,
                       state[2]);
  std::int64_t kept;
  std::fill(call.distances.begin(), call.distances.end(), T(1));
  Face<T>::nms(&some, call.distances.data(), T(0.5), scratch, call.scratch.size, call.indices.data(), &kept);
  return nullptr;
}

std::size_t deepest_yet = 0;

template <class T>
void expect_kept(int kind_a, int kind_b) {
  const Pairs<T> pairs = pairs_of<T>(properties::Workload::mixed_scale, kind_a, kind_b, 600);
  const auto count = static_cast<std::int64_t>(pairs.size());
  const std::int64_t scratch = std::max(vesica_index_scratch(count), vesica_join_scratch());
  Call<T> call{{},
               {},
               {},
               std::vector<std::uint8_t>(pairs.size()),
               std::vector<std::int64_t>(pairs.size()),
               std::vector<std::int64_t>(pairs.size()),
               std::vector<T>(pairs.size()),
               Aligned(vesica_index_size(count)),
               Aligned(std::max(scratch, vesica_nms_scratch(count)))};
  Face<T>::from_records(kind_a, count, pairs.a.data(), sizeof(Numbers<T>), &call.a);
  Face<T>::from_records(kind_b, count, pairs.b.data(), sizeof(Numbers<T>), &call.b);
  Face<T>::from_records(kind_a, 1, pairs.a.data(), 0, &call.one);
  call_all<T>(&call);  // the dynamic linker's own work comes first
  const std::size_t used = stack_used(call_all<T>, &call);
  const std::size_t idle = stack_used([](void*) -> void* { return nullptr; }, nullptr);
  EXPECT_GT(used, idle);
  EXPECT_LE(used - idle, promised) << used - idle << ' ' << properties::kind_name(kind_a) << ", "
                                   << properties::kind_name(kind_b);
  deepest_yet = std::max(deepest_yet, used - idle);
}

TEST(Stack, HoldsTheDeepestExactStage) {
  for (int a = 0; a < 6; ++a) {
    for (int b = a; b < 6; ++b) {
      expect_kept<float>(a, b);
      expect_kept<double>(a, b);
    }
  }
  std::printf("  at most %zu bytes\n", deepest_yet);
}

}  // namespace
}  // namespace stack_test
