// SPDX-License-Identifier: Apache-2.0
// Batches over a device's memory give the library's answers: every workload, near ties, the corpus and the hosts'
// vectors in step; matrices, counts and one against many for one pair of kinds. nvcc makes of this the test that wants
// a device (programs.sh); through host/cuda_runtime.h it is one that wants none.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cuda/any_pair.hpp"
#include "cuda/cases.hpp"
#include "cuda/device_memory.hpp"

namespace {

using properties::Pair;
using properties::Scalar;
using namespace vesica::bench;

template <class T>
DeviceColumns<T> upload(int kind, const std::vector<Pair>& pairs, const properties::Numbers Pair::*shape) {
  std::vector<T> numbers;
  for (std::size_t k = 0; k < static_cast<std::size_t>(properties::field_count(kind)); ++k) {
    for (const Pair& pair : pairs) numbers.push_back(static_cast<T>((pair.*shape)[k]));
  }
  return {kind, static_cast<std::int64_t>(pairs.size()), numbers};
}

template <class T>
std::int32_t expected(int kind_a, const properties::Numbers& a, int kind_b, const properties::Numbers& b) {
  properties::NumbersOf<T> x{}, y{};
  std::transform(a.begin(), a.end(), x.begin(), [](double number) { return static_cast<T>(number); });
  std::transform(b.begin(), b.end(), y.begin(), [](double number) { return static_cast<T>(number); });
  return cases::answer(kind_a, x.data(), kind_b, y.data());
}

template <class T>
void ask_in_step(const std::vector<Pair>& pairs) {
  const int kind_a = pairs[0].kind_a, kind_b = pairs[0].kind_b;
  const auto count = static_cast<std::int64_t>(pairs.size());
  const DeviceColumns<T> a = upload<T>(kind_a, pairs, &Pair::a), b = upload<T>(kind_b, pairs, &Pair::b);
  const DeviceMemory<std::uint8_t> out(std::vector<std::uint8_t>(pairs.size(), 9));
  const DeviceWork work(count);
  must_succeed(overlap_any(a.shapes(), b.shapes(), out.get(), work.work()));
  const std::vector<std::uint8_t> answers = out.read(pairs.size());
  std::uint32_t invalid = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::int32_t code = expected<T>(kind_a, pairs[i].a, kind_b, pairs[i].b);
    invalid += code < 0;
    EXPECT_EQ(answers[i], code == 1) << properties::describe(pairs[i]);
  }
  EXPECT_EQ(work.invalid(), invalid);
}

void ask(Scalar scalar, const std::vector<Pair>& pairs) {
  scalar == Scalar::f32 ? ask_in_step<float>(pairs) : ask_in_step<double>(pairs);
}

TEST(CudaDevice, EveryWorkloadAndInvalidShapes) { cases::ask_workloads(ask); }
TEST(CudaDevice, NearTies) {
  const int count = 2000 * properties::repeat();
  EXPECT_EQ(cases::ask_near_ties(count, ask), 72 * std::int64_t{count});
}
TEST(CudaDevice, Corpus) { EXPECT_GE(cases::ask_corpus(ask), 119U); }
TEST(CudaDevice, Vectors) { EXPECT_GE(cases::ask_vectors(VESICA_VECTORS, ask), 150); }

TEST(CudaDevice, OtherForms) {
  std::vector<Pair> pairs;
  properties::Stream stream(properties::Workload::near_contact, VESICA_RECT, VESICA_ELLIPSE, Scalar::f32,
                            properties::seed(), cases::overlaps);
  while (pairs.size() < 300) pairs.push_back(stream.next());
  constexpr std::int64_t rows = 300, columns = 300, size = columns + 5;
  const auto rects = upload<float>(VESICA_RECT, pairs, &Pair::a),
             ellipses = upload<float>(VESICA_ELLIPSE, pairs, &Pair::b);
  const DeviceMemory<std::uint8_t> matrix(std::vector<std::uint8_t>(rows * size, 9)), one(columns);
  const DeviceMemory<std::uint32_t> counts(std::vector<std::uint32_t>(columns, 7));
  const DeviceWork work(rows * columns);
  must_succeed(overlap_tile(rects.shapes(), ellipses.shapes(), matrix.get(), size, work.work()));
  must_succeed(count_tile(rects.shapes(), ellipses.shapes(), counts.get(), work.work()));
  vesica::Rect<float> first{};
  float* const numbers[] = {&first.cx, &first.cy, &first.ux, &first.uy, &first.hx, &first.hy};
  for (std::size_t k = 0; k < 6; ++k) *numbers[k] = static_cast<float>(pairs[0].a[k]);
  must_succeed(overlap_first(first, ellipses.shapes(), one.get(), work.work()));
  const auto cells = matrix.read(rows * size);
  const auto sums = counts.read(columns);
  const auto row = one.read(columns);
  for (std::size_t j = 0; j < columns; ++j) {
    std::uint32_t sum = 7;
    for (std::size_t i = 0; i < rows; ++i) {
      const bool overlap = expected<float>(VESICA_RECT, pairs[i].a, VESICA_ELLIPSE, pairs[j].b) == 1;
      EXPECT_EQ(cells[i * size + j], overlap) << i << " with " << j;
      sum += overlap;
    }
    EXPECT_EQ(sums[j], sum);
    EXPECT_EQ(row[j], cells[j]);
  }
  for (std::size_t i = 0; i < rows; ++i) EXPECT_EQ(cells[i * size + columns], 9);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) {
    std::fprintf(stderr, "device_test: no CUDA device; nothing was tested\n");
    return 3;
  }
  return RUN_ALL_TESTS();
}
