// SPDX-License-Identifier: Apache-2.0
// vectors.cpp FILE: the shared vectors (bindings/vectors) by overlap.hpp. Exit status 0 when all answers are right.
#include <algorithm>
#include <array>
#include <bit>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <vector>

#include "overlap.hpp"

namespace {

using Numbers = std::array<double, 6>;

struct Shape {
  int kind;
  Numbers numbers;
};

struct Batch {
  std::vector<int> line, expected;
  std::vector<vesica_rect_f64> rects;
  std::vector<vesica_ellipse_f64> ellipses;
};

bool all_right = true;

void check(int line, int answer, int expected) {
  if (answer == expected) return;
  std::cout << "line " << line << ": " << answer << ", not " << expected << '\n';
  all_right = false;
}

std::istream& operator>>(std::istream& in, Shape& shape) {
  in >> std::dec >> shape.kind >> std::hex;
  for (double& number : shape.numbers) {
    std::uint64_t bits = 0;
    in >> bits;
    number = std::bit_cast<double>(bits);
  }
  return in;
}

template <class T>
std::array<T, 6> to(const Numbers& numbers) {
  std::array<T, 6> out;
  std::ranges::transform(numbers, out.begin(), [](double number) { return static_cast<T>(number); });
  return out;
}

/// The answer, 1 or 0, or the code of the error.
template <class Call>
int answer(const Call& call) {
  try {
    return static_cast<int>(call());
  } catch (const shapes::Error& error) {
    return error.code;
  }
}

template <class T>
int scalar(const Shape& a, const Shape& b) {
  return answer([&] { return shapes::overlap(a.kind, to<T>(a.numbers), b.kind, to<T>(b.numbers)); });
}

void check_batch(const Batch& batch) {
  const std::span<const vesica_rect_f64> rects = batch.rects;
  const std::span<const vesica_ellipse_f64> ellipses = batch.ellipses;
  std::vector<std::uint8_t> out(rects.size());
  const auto invalid = std::ranges::find_if(batch.expected, [](int expected) { return expected < 0; });
  const auto valid = static_cast<std::size_t>(invalid - batch.expected.begin());
  const auto hits = std::count(batch.expected.begin(), invalid, 1);
  all_right &= shapes::overlap_many(rects.first(valid), ellipses.first(valid), out) == hits;
  // With an invalid element, an error: and yet every valid one has its answer.
  all_right &= answer([&] { return shapes::overlap_many(rects, ellipses, out); }) == VESICA_E_SHAPE;
  for (std::size_t i = 0; i < out.size(); ++i) check(batch.line[i], out[i], batch.expected[i] > 0);
}

int run(const char* path) {
  shapes::require_version();
  std::ifstream file(path);
  Batch batch;
  int calls = 0, number = 1;
  for (std::string line; std::getline(file, line); ++number) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string what;
    int expected = 0;
    Shape a, b;
    words >> what >> expected >> a >> b;
    if (!words) throw std::runtime_error("line " + std::to_string(number) + " is not a vector");
    if (what == "many") {
      batch.line.push_back(number);
      batch.expected.push_back(expected);
      batch.rects.push_back(std::bit_cast<vesica_rect_f64>(a.numbers));
      batch.ellipses.push_back(std::bit_cast<vesica_ellipse_f64>(b.numbers));
    } else {
      check(number, what == "f64" ? scalar<double>(a, b) : scalar<float>(a, b), expected);
      ++calls;
    }
  }
  check_batch(batch);
  try {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    shapes::overlap(vesica_point_f64{nan, 0}, vesica_circle_f64{0, 0, 1});
  } catch (const shapes::Error& error) {
    std::cout << "NaN: " << error.what() << '\n';
  }
  const auto [distance, ax, ay, bx, by] = shapes::nearest(vesica_aabb_f64{0, 0, 2, 2}, vesica_circle_f64{6, 1, 1});
  if (distance == 3 && ax == 2 && ay == 1 && bx == 5 && by == 1) std::cout << "nearest: as in C\n";
  std::cout << calls << " calls, " << batch.line.size() << " in a batch\n";
  return all_right ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return argc == 2 ? run(argv[1]) : 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
