// SPDX-License-Identifier: Apache-2.0
// Matching of detections to truths, and average precision.
#include "detection/precision.hpp"

#include "index_arguments.hpp"
#include "vesica_detection.h"

namespace {

using namespace vesica::capi;
namespace detection = vesica::detection;
using detection::MatchRule;
using detection::Outcome;
using detection::PrecisionRule;
using detection::Truth;

static_assert(VESICA_MATCH_VOC == static_cast<int>(MatchRule::voc) &&
              VESICA_MATCH_COCO == static_cast<int>(MatchRule::coco));
static_assert(VESICA_OUTCOME_MISS == static_cast<int>(Outcome::miss) &&
              VESICA_OUTCOME_HIT == static_cast<int>(Outcome::hit) &&
              VESICA_OUTCOME_IGNORED == static_cast<int>(Outcome::ignored));
static_assert(VESICA_TRUTH_COUNTS == static_cast<int>(Truth::counts) &&
              VESICA_TRUTH_CROWD == static_cast<int>(Truth::crowd) &&
              VESICA_TRUTH_IGNORED == static_cast<int>(Truth::ignored));
static_assert(VESICA_PRECISION_VOC_2007 == static_cast<int>(PrecisionRule::voc_2007) &&
              VESICA_PRECISION_VOC_2010 == static_cast<int>(PrecisionRule::voc_2010) &&
              VESICA_PRECISION_COCO == static_cast<int>(PrecisionRule::coco));

template <class T>
bool has_nan(const T* numbers, int64_t count) noexcept {
  for (int64_t i = 0; i < count; ++i) {
    if (numbers[i] != numbers[i]) return true;
  }
  return false;
}

/// True if no code exceeds 2.
bool are_codes(const uint8_t* codes, int64_t count) noexcept {
  for (int64_t i = 0; i < count; ++i) {
    if (codes[i] > 2) return false;
  }
  return true;
}

template <class T>
struct MatchArguments {
  int32_t rule;
  detection::Entries<T> pairs;
  const T* scores;
  const uint8_t* truths;
  const T* thresholds;
  int64_t threshold_count;
  void* scratch;
  int64_t scratch_size;
  uint8_t* outcomes;
  int64_t* taken;

  bool has_null() const noexcept {
    if (pairs.count != 0 && (pairs.row == nullptr || pairs.column == nullptr || pairs.value == nullptr)) return true;
    if (threshold_count != 0 && thresholds == nullptr) return true;
    return pairs.rows != 0 && (scores == nullptr || scratch == nullptr || outcomes == nullptr);
  }
  bool is_sound() const noexcept {
    if (rule != VESICA_MATCH_VOC && rule != VESICA_MATCH_COCO) return false;
    const int64_t needed = vesica_match_truths_scratch(pairs.count, pairs.rows, pairs.columns);
    if (needed < 0 || threshold_count < 0 || !are_inside(pairs)) return false;
    if (has_nan(scores, pairs.rows) || has_nan(thresholds, threshold_count)) return false;
    if (truths != nullptr && !are_codes(truths, pairs.columns)) return false;
    return pairs.rows == 0 || (scratch_size >= needed && aligned(scratch, 8));
  }
};

template <class T>
int32_t match_truths(const MatchArguments<T>& a) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(match_truths<T>, a);
  if (a.has_null()) return VESICA_E_NULL;
  if (!a.is_sound()) return VESICA_E_ARGUMENT;
  if (a.pairs.rows == 0) return 0;
  const detection::Matching<T> matching{static_cast<MatchRule>(a.rule), a.pairs, a.scores,
                                        reinterpret_cast<const Truth*>(a.truths), a.scratch};
  detection::match(matching, a.thresholds, a.threshold_count, reinterpret_cast<Outcome*>(a.outcomes), a.taken);
  return 0;
}

template <class T>
int32_t average_precision(int32_t rule, const T* scores, const uint8_t* outcomes, int64_t count, int64_t truths,
                          void* scratch, int64_t scratch_size, T* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(average_precision<T>, rule, scores, outcomes, count, truths, scratch, scratch_size, out);
  if (out == nullptr) return VESICA_E_NULL;
  if (count != 0 && (scores == nullptr || outcomes == nullptr || scratch == nullptr)) return VESICA_E_NULL;
  const int64_t needed = vesica_average_precision_scratch(count);
  if (rule < VESICA_PRECISION_VOC_2007 || rule > VESICA_PRECISION_COCO || needed < 0) return VESICA_E_ARGUMENT;
  if (count != 0 && (scratch_size < needed || !aligned(scratch, 8))) return VESICA_E_ARGUMENT;
  if (has_nan(scores, count) || !are_codes(outcomes, count)) return VESICA_E_ARGUMENT;
  int64_t hits = 0;
  for (int64_t i = 0; i < count; ++i) hits += outcomes[i] == VESICA_OUTCOME_HIT;
  if (truths < hits || truths < 0) return VESICA_E_ARGUMENT;
  *out = static_cast<T>(detection::average_precision(
      static_cast<PrecisionRule>(rule), scores, reinterpret_cast<const Outcome*>(outcomes), count, truths, scratch));
  return 0;
}

}  // namespace

int64_t vesica_match_truths_scratch(int64_t count, int64_t detections, int64_t truths) {
  for (const int64_t n : {count, detections, truths}) {
    if (n < 0 || n > vesica::index::most_items) return VESICA_E_ARGUMENT;
  }
  return detection::matching_bytes(count, detections, truths);
}

int64_t vesica_average_precision_scratch(int64_t count) {
  if (count < 0 || count > vesica::index::most_items) return VESICA_E_ARGUMENT;
  return detection::precision_bytes(count);
}

#define VESICA_PRECISION(scalar, T)                                                                                 \
  int32_t vesica_match_truths_##scalar(int32_t rule, const int64_t* a, const int64_t* b, const T* values,           \
                                       int64_t count, const T* scores, int64_t detections, const uint8_t* flags,    \
                                       int64_t truths, const T* thresholds, int64_t threshold_count, void* scratch, \
                                       int64_t scratch_size, uint8_t* outcomes, int64_t* taken) {                   \
    return match_truths<T>({rule,                                                                                   \
                            {a, b, values, count, detections, truths},                                              \
                            scores,                                                                                 \
                            flags,                                                                                  \
                            thresholds,                                                                             \
                            threshold_count,                                                                        \
                            scratch,                                                                                \
                            scratch_size,                                                                           \
                            outcomes,                                                                               \
                            taken});                                                                                \
  }                                                                                                                 \
  int32_t vesica_average_precision_##scalar(int32_t rule, const T* scores, const uint8_t* outcomes, int64_t count,  \
                                            int64_t truths, void* scratch, int64_t scratch_size, T* out) {          \
    return average_precision(rule, scores, outcomes, count, truths, scratch, scratch_size, out);                    \
  }

VESICA_PRECISION(f64, double)
VESICA_PRECISION(f32, float)
