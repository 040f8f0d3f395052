// SPDX-License-Identifier: Apache-2.0
/// The tables of this folder: one for each query.
#pragma once

#include <cstdio>

namespace vesica::bench {

/// vesica_relation and vesica_contains beside vesica_overlap, all pairs of kinds, on the same fresh pairs.
void report_relation(std::FILE* out);

/// vesica_area beside the usual rotated-IoU algorithm and Boost.Geometry, errors with the times.
void report_area(std::FILE* out);

/// vesica_iou_matrix beside the same two, on the instruction set in use: one line for each set of data.
void print_iou_matrix_heading(std::FILE* out);
void report_iou_matrix(std::FILE* out);

/// The same of AABBs, beside a loop by hand.
void print_iou_of_aabbs_heading(std::FILE* out);
void report_iou_of_aabbs(std::FILE* out);

/// vesica_nms beside the usual algorithm.
void report_suppression(std::FILE* out);

}  // namespace vesica::bench
