// SPDX-License-Identifier: Apache-2.0
/// Scenes: sets of shapes of all six kinds, the same on every machine, as no C library is asked for a sine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "index/workloads.hpp"

namespace answers {

/// uniform; lattice, where boxes touch; decades, sizes from 1/1000 to 1000; tight, in a few clusters, one giant among
/// them; whole_range, places and sizes of any magnitude.
const std::vector<std::string>& scenes();

/// So many shapes of each kind, one in 97 of them invalid; about as many touch another as not.
template <class T>
index_tests::Laid<T> scene(const std::string& name, int of_each_kind, std::uint64_t seed);

}  // namespace answers
