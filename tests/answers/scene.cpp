// SPDX-License-Identifier: Apache-2.0
#include "answers/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "properties/pair.hpp"
#include "properties/random.hpp"

namespace answers {
namespace {

using properties::Random;

/// A shape's middle, and how large it is.
struct Place {
  double x, y, size;
};
// Each number is drawn in a statement of its own: the order in which a compiler evaluates operands is its own choice.

Place uniform(Random& r, double side) {
  const double x = side * r.unit();
  const double y = side * r.unit();
  return {x, y, 0.25 + r.unit()};
}
Place lattice(Random& r, double side) {
  const int most = static_cast<int>(side);
  const double x = r.below(most);
  const double y = r.below(most);
  return {x / 3, y / 3, r.integer(1, 2) * 0.5 / 3};
}
Place decades(Random& r, double side) {
  const Place p = uniform(r, side);
  return {p.x, p.y, std::ldexp(p.size, -std::abs(r.integer(-10, 9)))};
}
Place tight(Random& r, double side) {
  if (r.below(300) == 0) return {side / 2, side / 3, side};
  const double cluster = r.below(4);
  const Place p = uniform(r, side / 8);
  return {p.x + cluster * side / 4, p.y + (cluster == 2 ? side / 2 : 0), p.size / 4};
}
Place whole_range(Random& r, double) {
  const int exponent = r.integer(-120, 119);
  const double x = std::ldexp(r.unit() - 0.5, exponent);
  const int lower = r.below(3);
  const double y = std::ldexp(r.unit() - 0.5, exponent - lower);
  return {x, y, std::ldexp(1, exponent - r.below(4))};
}

struct Named {
  const char* name;
  Place (*draw)(Random&, double side);
};
constexpr Named all[] = {
    {"uniform", uniform}, {"lattice", lattice}, {"decades", decades}, {"tight", tight}, {"whole_range", whole_range}};

/// Numbers of a shape of a kind. Axes are integers, of any length.
std::vector<double> shape(int kind, const Place& p, bool along_axes, Random& r) {
  const double h = p.size * r.integer(1, 4) / 4;
  const double k = p.size * r.integer(0, 4) / 4;
  double ux = r.integer(1, 5);
  double uy = r.integer(-4, 4);
  if (along_axes) ux = 1, uy = 0;
  switch (kind) {
    case VESICA_POINT:
      return {p.x, p.y};
    case VESICA_SEGMENT:
      return {p.x - h, p.y + k, p.x + h, p.y - k};
    case VESICA_CIRCLE:
      return {p.x, p.y, h};
    case VESICA_AABB:
      return {p.x - h, p.y - k, p.x + h, p.y + k};
    default:
      return {p.x, p.y, ux, uy, h / (along_axes ? 1 : 4), k / (along_axes ? 1 : 4)};
  }
}

}  // namespace

const std::vector<std::string>& scenes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Named& named : all) result.emplace_back(named.name);
    return result;
  }();
  return names;
}

template <class T>
index_tests::Laid<T> scene(const std::string& name, int of_each_kind, std::uint64_t seed) {
  const Named& named = *std::find_if(std::begin(all), std::end(all), [&](const Named& n) { return name == n.name; });
  Random random(seed);
  const double side = std::sqrt(6.0 * of_each_kind) * (name == "lattice" ? 1 : 1.25);
  index_tests::Laid<T> laid;
  for (std::int32_t kind = 0; kind < properties::kinds_with_form; ++kind) {
    index_tests::Records<T> records{kind, {}};
    for (int i = 0; i < of_each_kind; ++i) {
      const Place place = named.draw(random, side);
      for (const double x : shape(kind, place, name == "lattice" && i % 4 != 0, random)) {
        records.numbers.push_back(static_cast<T>(x));
      }
      if (i % 97 == 45) records.numbers.back() = std::numeric_limits<T>::quiet_NaN();
    }
    laid.push_back(std::move(records));
  }
  return laid;
}

template index_tests::Laid<float> scene(const std::string&, int, std::uint64_t);
template index_tests::Laid<double> scene(const std::string&, int, std::uint64_t);

}  // namespace answers
