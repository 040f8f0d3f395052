// SPDX-License-Identifier: Apache-2.0
#include "batch/report.hpp"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <string>

namespace vesica::bench {
namespace {

std::string format(const char* pattern, auto... values) {
  std::array<char, 64> text{};
  const int length = std::snprintf(text.data(), text.size(), pattern, values...);
  return {text.data(), static_cast<std::size_t>(length)};
}

double reached(const BatchTarget& target, const Result& result) {
  switch (target.of) {
    case BatchTarget::Of::ratio:
      return result.reference ? result.reference->ratio : 0;
    case BatchTarget::Of::bandwidth:
      return result.bandwidth_share;
    case BatchTarget::Of::tests_a_second:
      return result.tests_a_second;
    case BatchTarget::Of::nothing:
      break;
  }
  return 0;
}

std::string text_of(const BatchTarget& target) {
  switch (target.of) {
    case BatchTarget::Of::ratio:
      return format("%.2f", target.at_least);
    case BatchTarget::Of::bandwidth:
      return format("%.0f%% bw", 100 * target.at_least);
    case BatchTarget::Of::tests_a_second:
      return format("%.1f G/s", target.at_least / 1e9);
    case BatchTarget::Of::nothing:
      break;
  }
  return "";
}

}  // namespace

bool reaches_target(const Spec& spec, const Result& result) {
  const BatchTarget target = spec.target();
  return target.of == BatchTarget::Of::nothing || reached(target, result) >= target.at_least;
}

void print_heading() {
  std::printf(
      "Batches, through the path of the public calls; seed %" PRIu64
      ". Medians over rounds; in each, both sides answer the same\n"
      "fresh batch, copied into the same buffers just before. hits: share of pairs that overlap. ns: a test. G/s: "
      "10^9\n"
      "tests a second. ref: nanoseconds of the unfiltered kernel on columns (unit axes, no error bound, no validity);\n"
      "of matrix_1e5 the same matrix call in cache, of near mixed pairs in step. ratio: ref / ns, the median of "
      "rounds.\n"
      "unlike: answers of the unfiltered kernel that differ, in %% of pairs. bw: GB/s read by a sum over the same "
      "memory,\n"
      "and our share of it. scalar: nanoseconds of the typed scalar call through the shared library.\n\n",
      seed_of_run());
  std::printf("%-52s %5s %7s %6s %7s %6s %-11s %8s %7s %-9s %13s %7s\n", "pair/scalar/isa/layout/workload", "hits",
              "ns", "G/s", "ref", "ratio", "quartiles", "unlike", "target", "", "bw", "scalar");
}

void print_row(const Spec& spec, const Result& result, double scalar_nanoseconds) {
  std::string reference, ratio, quartiles, unlike, bandwidth, verdict;
  if (result.reference) {
    const Comparison& with = *result.reference;
    reference = format("%.3f", with.nanoseconds);
    ratio = format("%.2f", with.ratio);
    quartiles = format("%.2f-%.2f", with.quartile, with.quartile3);
    if (with.asked > 0)
      unlike = format("%.4f", 100 * static_cast<double>(with.unlike) / static_cast<double>(with.asked));
  }
  if (result.bandwidth > 0) bandwidth = format("%.1f %3.0f%%", result.bandwidth / 1e9, 100 * result.bandwidth_share);
  if (spec.target().of != BatchTarget::Of::nothing) verdict = reaches_target(spec, result) ? "met" : "MISSED";
  std::printf("%-52s %5.2f %7.3f %6.2f %7s %6s %-11s %8s %7s %-9s %13s %7.2f\n", spec.name().c_str(), result.hits,
              result.nanoseconds, result.tests_a_second / 1e9, reference.c_str(), ratio.c_str(), quartiles.c_str(),
              unlike.c_str(), text_of(spec.target()).c_str(), verdict.c_str(), bandwidth.c_str(), scalar_nanoseconds);
  std::fflush(stdout);
}

}  // namespace vesica::bench
