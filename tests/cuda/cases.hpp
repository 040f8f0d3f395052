// SPDX-License-Identifier: Apache-2.0
/// The questions to kernels, on a device and through its stand-in: every workload with invalid shapes among it, near
/// ties, the corpus and the hosts' vectors; and what the library answers.
#pragma once

#include <vesica.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "corpus/corpus.hpp"
#include "properties/generators.hpp"
#include "properties/spoilt.hpp"

namespace cases {

using properties::Pair;
using properties::Scalar;

inline bool overlaps(int kind_a, const double* a, int kind_b, const double* b) {
  return vesica_overlap_f64(kind_a, a, kind_b, b) == 1;
}
inline std::int32_t answer(int kind_a, const double* a, int kind_b, const double* b) {
  return vesica_overlap_f64(kind_a, a, kind_b, b);
}
inline std::int32_t answer(int kind_a, const float* a, int kind_b, const float* b) {
  return vesica_overlap_f32(kind_a, a, kind_b, b);
}

template <class Action>
void with_each_pair_of_kinds(const Action& action) {
  for (int a = 0; a < properties::kinds; ++a) {
    for (int b = a; b < properties::kinds; ++b) {
      for (const Scalar scalar : {Scalar::f32, Scalar::f64}) action(a, b, scalar);
    }
  }
}

// Each function below calls ask(scalar, pairs) with pairs of two kinds in order.

template <class Ask>
void ask_workloads(const Ask& ask) {
  with_each_pair_of_kinds([&](int a, int b, Scalar scalar) {
    std::vector<Pair> pairs;
    for (const properties::Workload workload : properties::all_workloads) {
      properties::Stream stream(workload, a, b, scalar, properties::seed(), overlaps);
      for (int i = 0; i < 20; ++i) {
        pairs.push_back(stream.next());
        if (i < 4) spoil(pairs.back(), i);
      }
    }
    ask(scalar, pairs);
  });
}

/// `count` of each two kinds in each scalar; returns how many in all.
template <class Ask>
std::int64_t ask_near_ties(int count, const Ask& ask) {
  std::int64_t asked = 0;
  with_each_pair_of_kinds([&](int a, int b, Scalar scalar) {
    properties::Stream stream(properties::Workload::near_contact, a, b, scalar, properties::seed(), overlaps);
    for (int rest = count; rest > 0; rest -= 10'000) {
      std::vector<Pair> pairs;
      for (int i = 0; i < rest && i < 10'000; ++i) pairs.push_back(stream.next());
      ask(scalar, pairs);
      asked += static_cast<std::int64_t>(pairs.size());
    }
  });
  std::printf("%lld near ties\n", static_cast<long long>(asked));
  return asked;
}

inline Pair in_order(const Pair& pair) {
  return pair.kind_a > pair.kind_b ? Pair{pair.kind_b, pair.kind_a, pair.b, pair.a} : pair;
}

/// Returns how many. Throws where the library differs from the corpus: then there is nothing to compare with.
template <class Ask>
std::size_t ask_corpus(const Ask& ask) {
  const std::vector<corpus::Row> rows = corpus::rows("overlap");
  for (const corpus::Row& row : rows) {
    const Pair pair = in_order(row.pair);
    if (answer(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data()) != row.expected) {
      throw std::runtime_error("the library's answer to " + row.id);
    }
    ask(Scalar::f64, {pair});
  }
  return rows.size();
}

/// Returns how many of the file's lines are about two kinds that exist.
template <class Ask>
int ask_vectors(const char* path, const Ask& ask) {
  std::ifstream file(path);
  int asked = 0;
  for (std::string line, what; std::getline(file, line);) {
    std::istringstream words(line);
    Pair pair{};
    int expected = 0;
    const auto read = [&](int& kind, properties::Numbers& numbers) {
      words >> kind;
      for (std::size_t k = 0; k < 6; ++k) {
        std::uint64_t bits = 0;
        words >> std::hex >> bits >> std::dec;
        numbers[k] = std::bit_cast<double>(bits);
      }
    };
    if (!(words >> what) || (what != "f64" && what != "f32")) continue;
    words >> expected;
    read(pair.kind_a, pair.a);
    read(pair.kind_b, pair.b);
    if (!words) throw std::runtime_error("not a vector: " + line);
    if (std::min(pair.kind_a, pair.kind_b) < 0 || std::max(pair.kind_a, pair.kind_b) >= properties::kinds) continue;
    ask(what == "f64" ? Scalar::f64 : Scalar::f32, {in_order(pair)});
    ++asked;
  }
  return asked;
}

}  // namespace cases
