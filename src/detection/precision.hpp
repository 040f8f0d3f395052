// SPDX-License-Identifier: Apache-2.0
// Detections that hit a truth, and their average precision, by the rules of two challenges.
//
// M. Everingham et al., "The PASCAL Visual Object Classes challenge: a retrospective", IJCV 111, 2015.
// T.-Y. Lin et al., "Microsoft COCO: common objects in context", ECCV 2014, with its program for evaluation.
#pragma once

#include <cstdint>

#include "detection/assign.hpp"

namespace vesica::detection {

// The codes of the C interface.
enum class MatchRule : std::int32_t { voc = 0, coco = 1 };
enum class Outcome : std::uint8_t { miss = 0, hit = 1, ignored = 2 };
/// A crowd takes any number of detections, an ignored truth one.
enum class Truth : std::uint8_t { counts = 0, crowd = 1, ignored = 2 };
enum class PrecisionRule : std::int32_t { voc_2007 = 0, voc_2010 = 1, coco = 2 };

template <class T>
struct Matching {
  MatchRule rule;
  Entries<T> pairs;    // rows are detections, columns truths; all inside
  const T* score;      // none is NaN
  const Truth* truth;  // null: all count
  void* scratch;       // of matching_bytes, aligned to 8
};

std::int64_t matching_bytes(std::int64_t pairs, std::int64_t detections, std::int64_t truths) noexcept;

/// Writes the outcome of each detection at n thresholds, a row each; if `taken` is not null, also the truth that it
/// takes, or -1.
template <class T>
void match(const Matching<T>& matching, const T* threshold, std::int64_t n, Outcome* outcome,
           std::int64_t* taken) noexcept;

std::int64_t precision_bytes(std::int64_t detections) noexcept;

/// Average precision of detections, none of whose scores is NaN: from 0 to 1; NaN without truths. The scratch is of
/// precision_bytes, aligned to 8.
template <class T>
double average_precision(PrecisionRule rule, const T* score, const Outcome* outcome, std::int64_t detections,
                         std::int64_t truths, void* scratch) noexcept;

}  // namespace vesica::detection
