// SPDX-License-Identifier: Apache-2.0
/// The nineteen samples in groups that share a colour in every figure. Samples are numbered from 1 here.
#pragma once

#include <array>
#include <string_view>

#include "methods/nineteen_ellipses.hpp"
#include "svg.hpp"

namespace figures {

struct SampleGroup {
  std::size_t first, last;  ///< positions, from 0
  std::string_view colour, numbers, note;
};

inline constexpr std::array<SampleGroup, 8> sample_groups{{{0, 5, grey, "1 to 6", ": touching"},
                                                           {6, 7, red, "7, 8", ": crossing"},
                                                           {8, 9, blue, "9, 10", ""},
                                                           {10, 11, green, "11, 12", ""},
                                                           {12, 13, pink, "13, 14", ""},
                                                           {14, 15, orange, "15, 16", ""},
                                                           {16, 17, sky, "17, 18", ""},
                                                           {18, 18, brown, "19", ": inside"}}};

}  // namespace figures
