// SPDX-License-Identifier: Apache-2.0
#include "join/measure.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <new>

namespace vesica::bench {

Memory::Memory(std::int64_t bytes)
    : size(bytes),
      data(mmap(nullptr, static_cast<std::size_t>(bytes), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
  if (data == MAP_FAILED) throw std::bad_alloc();
}

Memory::~Memory() { munmap(data, static_cast<std::size_t>(size)); }

std::vector<RectRecord> draw(const std::string& workload, std::int64_t n, std::uint64_t seed) {
  const auto records = index_tests::rects<double>(workload, n, seed);
  std::vector<RectRecord> shapes(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double* r = &records.numbers[6 * i];
    shapes[i] = {r[0], r[1], r[2], r[3], r[4], r[5]};
  }
  return shapes;
}

vesica_shapes_f64 view(const std::vector<RectRecord>& shapes) {
  vesica_shapes_f64 out;
  vesica_shapes_from_records_f64(VESICA_RECT, static_cast<std::int64_t>(shapes.size()), shapes.data(),
                                 sizeof(RectRecord), &out);
  return out;
}

namespace {

std::int64_t count(const std::vector<vesica_shapes_f64>& sets) {
  std::int64_t items = 0;
  for (const vesica_shapes_f64& set : sets) items += set.count;
  return items;
}

Times once(const Operand& a, const Operand& b, const Scratch& scratch) {
  Times times;
  build(a, scratch, times);
  if (&a != &b) build(b, scratch, times);
  double begin = seconds();
  times.candidate_count = vesica_join_f64(VESICA_JOIN_BOUNDS, a.index.data, nullptr, 0, b.index.data, nullptr, 0, 0, 1,
                                          scratch.join.data, scratch.join.size, nullptr, nullptr, 0, nullptr);
  times.candidates = seconds() - begin;
  begin = seconds();
  times.pairs = join(a, b, 0, 1, scratch.join);
  times.join = seconds() - begin;
  return times;
}

}  // namespace

Operand::Operand(std::vector<vesica_shapes_f64> shapes)
    : sets(std::move(shapes)), items(count(sets)), index(vesica_index_size(items)) {}

double Times::decide_each() const {
  return (join - candidates) * 1e9 / static_cast<double>(std::max<std::int64_t>(1, candidate_count));
}

void build(const Operand& operand, const Scratch& scratch, Times& times) {
  for (std::int32_t step = 0; step < 5; ++step) {
    const double begin = seconds();
    times.bytes = vesica_index_step_f64(step, 0, 1, operand.sets.data(), operand.set_count(), operand.index.data,
                                        operand.index.size, scratch.build.data, scratch.build.size);
    times.step[step] += seconds() - begin;
  }
}

std::int64_t join(const Operand& a, const Operand& b, std::int64_t part, std::int64_t parts, const Memory& scratch) {
  constexpr std::int64_t capacity = 1 << 16;
  std::vector<std::int64_t> out(2 * capacity);
  std::int64_t state[4] = {0, 0, 0, 0}, pairs = 0;
  while (state[0] != -1) {
    pairs += vesica_join_f64(VESICA_JOIN_OVERLAP, a.index.data, a.sets.data(), a.set_count(), b.index.data,
                             b.sets.data(), b.set_count(), part, parts, scratch.data, scratch.size, out.data(),
                             out.data() + capacity, capacity, state);
  }
  return pairs;
}

Times least(const Operand& a, const Operand& b, const Scratch& scratch, int repeats) {
  Times best = once(a, b, scratch);
  for (int i = 1; i < repeats; ++i) {
    const Times t = once(a, b, scratch);
    if (t.total() < best.total()) best = t;
  }
  return best;
}

}  // namespace vesica::bench
