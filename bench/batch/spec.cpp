// SPDX-License-Identifier: Apache-2.0
#include "batch/spec.hpp"

#include <array>

namespace vesica::bench {
namespace {

struct Pair {
  std::int32_t a, b;
};

/// The rows with a yardstick.
constexpr std::array<Pair, 4> main_pairs{{{VESICA_RECT, VESICA_RECT},
                                          {VESICA_RECT, VESICA_ELLIPSE},
                                          {VESICA_CIRCLE, VESICA_ELLIPSE},
                                          {VESICA_ELLIPSE, VESICA_ELLIPSE}}};

bool is_main(Pair pair) {
  for (const Pair& main : main_pairs) {
    if (main.a == pair.a && main.b == pair.b) return true;
  }
  return false;
}

class Specs {
 public:
  void in_cache(Pair pair) {
    for (const Workload workload : {Workload::mixed, Workload::sparse}) {
      everywhere(pair, Layout::one_many, workload);
      everywhere(pair, Layout::in_step, workload);
      everywhere(pair, Layout::matrix, workload);
    }
    if (pair.a != pair.b) return;
    everywhere(pair, Layout::one_records, Workload::mixed);
    everywhere(pair, Layout::records, Workload::mixed);
  }

  void near_contact(Pair pair) {
    for (const Isa& isa : instruction_sets()) add(pair, true, isa, Layout::near, Workload::last_ulp);
  }

  /// Neighbours of a lattice, which touch.
  void touching(Pair pair) {
    for (const Workload workload : {Workload::pixels, Workload::hundredths})
      everywhere(pair, Layout::in_step, workload);
  }

  void large_matrices(Pair pair) {
    for (const Workload workload : {Workload::mixed, Workload::clusters}) {
      everywhere(pair, Layout::large_matrix, workload);
    }
    everywhere(pair, Layout::sorted_matrix, Workload::clusters);
  }

  void everywhere(Pair pair, Layout layout, Workload workload) {
    for (const bool single : {true, false}) {
      for (const Isa& isa : instruction_sets()) add(pair, single, isa, layout, workload);
    }
  }

  void best(Pair pair, bool single, Layout layout) {
    if (!instruction_sets().empty()) add(pair, single, instruction_sets().back(), layout, Workload::mixed);
  }

  std::vector<Spec> take() { return std::move(specs_); }

 private:
  void add(Pair pair, bool single, const Isa& isa, Layout layout, Workload workload) {
    specs_.push_back({pair.a, pair.b, single, &isa, layout, workload});
  }

  std::vector<Spec> specs_;
};

constexpr BatchTarget ratio(double value) { return {BatchTarget::Of::ratio, value}; }

BatchTarget in_cache_target(const Spec& spec) {
  if (spec.isa->name == "avx2") return ratio(0.62);
  if (spec.isa->name != "avx512") return {};
  const bool rect_rect = spec.kind_b == VESICA_RECT;
  if (spec.layout == Layout::in_step) return ratio(rect_rect ? 0.80 : 0.66);
  if (rect_rect) return ratio(spec.single ? 0.70 : 0.75);
  if (spec.kind_a == VESICA_RECT) return ratio(0.70);
  return ratio(spec.kind_a == VESICA_CIRCLE ? 0.65 : 0.73);
}

/// Pairs whose blocks are checked once, see src/kernels/checked.hpp.
BatchTarget matrix_target(const Spec& spec) {
  const bool wide = spec.isa->name == "avx2" || spec.isa->name == "avx512";
  return wide && spec.kind_a != VESICA_CIRCLE ? ratio(0.90) : BatchTarget{};
}

}  // namespace

const char* name_of(Layout layout) {
  switch (layout) {
    case Layout::one_many:
      return "one_many";
    case Layout::in_step:
      return "in_step";
    case Layout::matrix:
      return "matrix";
    case Layout::one_records:
      return "one_records";
    case Layout::records:
      return "records";
    case Layout::memory_one_many:
      return "memory_one_many";
    case Layout::memory_in_step:
      return "memory_in_step";
    case Layout::matrix_1e5:
      return "matrix_1e5";
    case Layout::large_matrix:
      return "large_matrix";
    case Layout::sorted_matrix:
      return "sorted_matrix";
    case Layout::two_threads:
      return "two_threads";
    case Layout::near:
      return "near";
  }
  return "";
}

std::string Spec::pair() const { return std::string(vesica_kind_name(kind_a)) + "_" + vesica_kind_name(kind_b); }

std::string Spec::name() const {
  return pair() + (single ? "/f32/" : "/f64/") + std::string(isa->name) + "/" + name_of(layout) + "/" +
         bench::name_of(workload);
}

BatchTarget Spec::target() const {
  switch (layout) {
    case Layout::one_many:
    case Layout::in_step:
      if (workload == Workload::pixels || workload == Workload::hundredths) {
        if (isa->name != "avx512") return {};
        return {BatchTarget::Of::tests_a_second, 1e8};
      }
      if (workload != Workload::mixed || !is_main({kind_a, kind_b})) return {};
      return in_cache_target(*this);
    case Layout::matrix:
      return matrix_target(*this);
    case Layout::memory_one_many:
      // Narrower registers are bound by arithmetic before memory is.
      if (isa->name != "avx512") return {};
      return {BatchTarget::Of::bandwidth, 0.85};
    case Layout::matrix_1e5:
      return ratio(0.85);
    case Layout::two_threads:
      return {BatchTarget::Of::tests_a_second, 4e9};
    case Layout::near:
      return ratio(0.20);  // at most five times the time of mixed pairs
    default:
      return {};
  }
}

std::vector<Spec> all_specs() {
  Specs specs;
  for (const Pair& pair : main_pairs) specs.in_cache(pair);
  for (const Pair& pair : main_pairs) {
    specs.everywhere(pair, Layout::memory_one_many, Workload::mixed);
    specs.everywhere(pair, Layout::memory_in_step, Workload::mixed);
  }
  for (const Pair& pair : main_pairs) {
    for (const bool single : {true, false}) specs.best(pair, single, Layout::matrix_1e5);
  }
  for (const Pair& pair : main_pairs) specs.large_matrices(pair);
  specs.best(main_pairs[0], true, Layout::two_threads);
  for (const Pair& pair : main_pairs) specs.near_contact(pair);
  specs.touching(main_pairs[0]);
  for (std::int32_t a = VESICA_POINT; a <= VESICA_ROUND_RECT; ++a) {
    for (std::int32_t b = a; b <= VESICA_ROUND_RECT; ++b) {
      if (is_main({a, b})) continue;
      specs.everywhere({a, b}, Layout::one_many, Workload::mixed);
      specs.everywhere({a, b}, Layout::in_step, Workload::mixed);
      if (a != b) continue;
      specs.everywhere({a, b}, Layout::one_records, Workload::mixed);
      specs.everywhere({a, b}, Layout::records, Workload::mixed);
    }
  }
  return specs.take();
}

}  // namespace vesica::bench
