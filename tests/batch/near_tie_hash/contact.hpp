// SPDX-License-Identifier: Apache-2.0
/// Pairs of shapes about a contact, the same to the bit on every platform: made from integers by + - * / and sqrt,
/// which IEEE 754 rounds in one way only, and by no function of the mathematics library.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace near_tie {

template <class T>
using Numbers = std::array<T, 6>;

template <class T>
struct Pair {
  int kind_a, kind_b;
  Numbers<T> a, b;
};

/// Some thousand pairs of two kinds, in groups. For a group one number of a random pair is bisected to where the
/// library's answer changes; the pair is taken with that number and with its up to 64 neighbours to either side.
template <class T>
std::vector<Pair<T>> contacts(int kind_a, int kind_b);

std::int32_t overlap(const Pair<float>& pair);
std::int32_t overlap(const Pair<double>& pair);

}  // namespace near_tie
