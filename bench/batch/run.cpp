// SPDX-License-Identifier: Apache-2.0
#include "batch/run.hpp"

namespace vesica::bench {
namespace {

template <class T>
Result run_scalar(const Spec& spec) {
  switch (spec.layout) {
    case Layout::memory_one_many:
    case Layout::memory_in_step:
      return run_in_memory<T>(spec);
    case Layout::matrix_1e5:
      return run_matrix_1e5<T>(spec);
    case Layout::large_matrix:
    case Layout::sorted_matrix:
      return run_large_matrix<T>(spec);
    case Layout::near:
      return run_near<T>(spec);
    case Layout::two_threads:
      return run_two_threads(spec);
    default:
      return run_in_cache<T>(spec);
  }
}

}  // namespace

Result run(const Spec& spec) { return spec.single ? run_scalar<float>(spec) : run_scalar<double>(spec); }

Result summary(const Times& ours, double tests_a_pass) {
  Result result;
  result.nanoseconds = median(ours) / tests_a_pass;
  result.tests_a_second = 1e9 / result.nanoseconds;
  return result;
}

Comparison compare(const Times& ours, const Times& reference, double our_tests, double reference_tests) {
  Times all = ratios(reference, ours);
  for (double& ratio : all) ratio *= our_tests / reference_tests;
  return {.nanoseconds = median(reference) / reference_tests,
          .ratio = median(all),
          .quartile = quantile(all, 0.25),
          .quartile3 = quantile(all, 0.75)};
}

}  // namespace vesica::bench
