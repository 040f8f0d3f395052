// SPDX-License-Identifier: Apache-2.0
/// Tables of the queries that are answered with a distance: one function a table.
#pragma once

#include <cstdio>

namespace vesica::bench {

/// vesica_nearest beside other libraries and the named method, aspect ratios up to 20, 10^3 and 10^6.
void report_nearest(std::FILE* out);

/// vesica_boundary_distance on nested, disjoint and crossing pairs, at aspect ratios up to 20, 10^3 and 10^6.
void report_boundary_distance(std::FILE* out);

/// vesica_depth on overlapping pairs, at the same aspect ratios.
void report_depth(std::FILE* out);

}  // namespace vesica::bench
