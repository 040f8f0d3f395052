// SPDX-License-Identifier: Apache-2.0
/// Pairs to fill batches with: mostly easy ones, and among them whatever sends a lane to a later stage.
#pragma once

#include "batch/shapes.hpp"
#include "properties/generators.hpp"

namespace batch_tests {

/// `count` pairs of one workload; kinds in either order.
template <class T>
Pairs<T> pairs_of(properties::Workload workload, int kind_a, int kind_b, int count);

/// Near contacts with one number then moved by up to 2^11 places: where a lane's error bound must hold.
template <class T>
Pairs<T> pairs_about_contact(int kind_a, int kind_b, int count);

/// Some thousand pairs of all workloads, shuffled, half of them random. Drawn once for each two kinds.
template <class T>
const Pairs<T>& mixed_pairs(int kind_a, int kind_b);

}  // namespace batch_tests
