// SPDX-License-Identifier: Apache-2.0
#include "properties/refused.hpp"

#include <vesica.h>
#include <vesica_topology.h>

#include <cstddef>

#include "properties/pair.hpp"

namespace properties {
namespace {

/// Valid numbers of every kind, by kind.
constexpr Numbers samples[kinds] = {{0, 0},          {0, 0, 1, 1},         {0, 0, 1},
                                    {0, 0, 1, 1},    {0, 0, 1, 0, 2, 1},   {0, 0, 1, 0, 2, 1},
                                    {0, 0, 1, 1, 1}, {0, 0, 1, 0, 2, 1, 1}};

std::int64_t ask(Question question, int kind_a, const double* a, int kind_b, const double* b) {
  switch (question) {
    case Question::boundary_distance: {
      vesica_closest_points_f64 points;
      return vesica_boundary_distance_f64(kind_a, a, kind_b, b, &points);
    }
    case Question::crossings: {
      std::int32_t shared = 0;
      vesica_point_f64 places[16];
      return vesica_crossings_f64(kind_a, a, kind_b, b, places, 16, &shared);
    }
    case Question::de9im: {
      char matrix[VESICA_DE9IM_SIZE];
      return vesica_de9im_f64(kind_a, a, kind_b, b, matrix);
    }
    default: {
      vesica_point_f64 vertices[16];
      return vesica_intersection_f64(kind_a, a, kind_b, b, vertices, 16);
    }
  }
}

}  // namespace

const char* name(Question question) {
  constexpr std::array<const char*, all_questions.size()> names{"boundary_distance", "crossings", "de9im",
                                                                "intersection"};
  return names.at(static_cast<std::size_t>(question));
}

bool refuses(Question question, int kind_a, int kind_b) {
  return ask(question, kind_a, samples[kind_a].data(), kind_b, samples[kind_b].data()) == VESICA_E_KIND;
}

}  // namespace properties
