// SPDX-License-Identifier: Apache-2.0
// Weighted fusion of boxes: each joins the cluster whose mean it overlaps most, or begins one.
//
// R. Solovyev, W. Wang, T. Gabruseva, "Weighted boxes fusion: Ensembling boxes from different object detection models",
// Image and Vision Computing 107, 2021.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"

namespace vesica::detection {

/// The IoU of two valid shapes of one kind, 0 where there is none.
using Iou = double (*)(std::int32_t kind, const double* a, const double* b);

struct Fusion {
  const index::Kernels& kernels;
  const index::Sets& sets;  // one, of boxes along the axes or of rectangles
  Iou iou;
  double threshold;
  bool highest;               // the score of a cluster is its highest one, not the mean
  const std::int32_t* label;  // null: all are alike
  void* scratch;              // of fusion_bytes
};

/// Kinds whose shapes can be fused.
bool can_be_fused(std::int32_t kind) noexcept;

std::int64_t fusion_bytes(std::int64_t items) noexcept;

/// Writes the means as records of T, their scores, and each shape's cluster or -1; returns how many clusters. What
/// cannot be used, an invalid shape or an unfit score or weight, sets `left_out`. weight may be null.
template <class T>
std::int64_t fuse(const Fusion& fusion, const T* score, const T* weight, T* shapes, T* scores, std::int64_t* cluster,
                  bool& left_out) noexcept;

}  // namespace vesica::detection
