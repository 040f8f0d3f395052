// SPDX-License-Identifier: Apache-2.0
// Writes calls.txt, which every package is run on; its head, below, says how to read it. Overlap, relation and
// containment are the exact oracle's, and the library must agree. Other results are the library's: their tests are
// elsewhere, and here it is seen that a host hands on every argument and every result.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

#include "calls.hpp"
#include "lines.hpp"
#include "measures.hpp"
#include "motion.hpp"
#include "oracle/oracle.hpp"
#include "topology.hpp"

namespace {

constexpr const char* head =
    "# SPDX-License-Identifier: Apache-2.0\n"
    "# Calls of every function, which all packages must answer alike. Written by bindings_calls; a test keeps it so.\n"
    "#\n"
    "#   function scalar | argument | argument ... = result values ...\n"
    "#\n"
    "# An argument is a shape or an array of shapes (its kind, and all numbers, shape after shape), or numbers. "
    "Numbers\n"
    "# are C's hexadecimal floats, or whole. A result is what the C function returns, or the name of an error; values\n"
    "# are what it wrote: columns one after the other, a matrix row by row.\n"
    "# What takes an index has its sets of shapes in place of it; / parts those of two, and an index whose sets are\n"
    "# left out is the same as the other. suppress has its labels last, if there are any. In a\n"
    "# nine-intersection matrix F is -1.\n";

// ---- One shape, or two ----

template <class T>
int expected_relation(const Array<T>& a, const Array<T>& b) {
  const std::vector<double> exact_a(a.numbers.begin(), a.numbers.end()), exact_b(b.numbers.begin(), b.numbers.end());
  return oracle::relation(a.kind, exact_a.data(), b.kind, exact_b.data());
}

template <class T, class Call>
void code_of_two(const char* name, Call call, const Array<T>& a, const Array<T>& b) {
  begin<T>(name), argument(a), argument(b);
  result(call(T{}, a.kind, a.data(), b.kind, b.data()));
  end();
}

/// Out is a struct of numbers of type T alone.
template <class Out, class T, class Call>
void measure_of_two(const char* name, Call call, const Array<T>& a, const Array<T>& b) {
  Out out{};
  begin<T>(name), argument(a), argument(b);
  const int code = call(T{}, a.kind, a.data(), b.kind, b.data(), &out);
  result(code);
  const T* const first = reinterpret_cast<const T*>(&out);
  if (code >= 0) values(std::vector<T>(first, first + sizeof out / sizeof(T)));
  end();
}

template <class T>
void crossings(const Array<T>& a, const Array<T>& b) {
  typename Structs<T>::Point out[8];
  std::int32_t shared = 0;
  begin<T>("crossings"), argument(a), argument(b);
  const auto code = static_cast<int>(call::crossings(T{}, a.kind, a.data(), b.kind, b.data(), out, 8, &shared));
  result(code);
  if (code >= 0) {
    print_number(shared);
    for (int i = 0; i < code; ++i) values(std::vector<T>{out[i].x, out[i].y});
  }
  end();
}

template <class T>
void all_of_two(const Array<T>& a, const Array<T>& b) {
  using Closest = typename Structs<T>::ClosestPoints;
  code_of_two("overlap", call::overlap, a, b);
  code_of_two("interiors_overlap", call::interiors_overlap, a, b);
  code_of_two("relation", call::relation, a, b);
  code_of_two("contains", call::contains, a, b);
  crossings(a, b);
  measure_of_two<Closest>("nearest", call::nearest, a, b);
  measure_of_two<Closest>("boundary_distance", call::boundary_distance, a, b);
  measure_of_two<typename Structs<T>::Penetration>("depth", call::depth, a, b);
  measure_of_two<T>("area", call::area, a, b);
  measure_of_two<T>("iou", call::iou, a, b);
}

/// Every pair of kinds in double, every third in float: near, far, inside and touching in turn.
template <class T>
void pairs(int step) {
  constexpr double moves[] = {0, 2.5, 0.25, 40, 1};
  for (int i = 0; i < 36; i += step) {
    const Array<T> a = sample<T>(i / 6, 0, 0), b = sample<T>(i % 6, moves[i % 5], 0.125 * (i % 3));
    const int relation = expected_relation(a, b);
    must(call::relation(T{}, a.kind, a.data(), b.kind, b.data()) == relation, "relation");
    must(call::overlap(T{}, a.kind, a.data(), b.kind, b.data()) == (relation != VESICA_DISJOINT), "overlap");
    must(call::contains(T{}, a.kind, a.data(), b.kind, b.data()) == (relation >= VESICA_CONTAINS), "contains");
    all_of_two(a, b);
  }
  all_of_two(invalid<T>(VESICA_CIRCLE), sample<T>(VESICA_RECT, 0, 0));
}

template <class T>
void of_one(const Array<T>& shape) {
  begin<T>("check"), argument(shape);
  result(call::check(T{}, shape.kind, shape.data()));
  end();
  T area{};
  begin<T>("shape_area"), argument(shape);
  const int area_code = call::shape_area(T{}, shape.kind, shape.data(), &area);
  result(area_code);
  if (area_code >= 0) values(std::vector<T>{area});
  end();
  typename Structs<T>::Aabb box{};
  begin<T>("bounds"), argument(shape);
  const int box_code = call::bounds(T{}, shape.kind, shape.data(), &box);
  result(box_code);
  if (box_code >= 0) values(std::vector<T>{box.min_x, box.min_y, box.max_x, box.max_y});
  end();
}

// ---- Constructors ----

template <class T, class Shape, class Call>
void constructed(const char* name, Call call, const std::vector<T>& numbers) {
  Shape out{};
  begin<T>(name), numbers_argument(numbers);
  const int code = call(numbers, &out);
  result(code);
  const T* const first = reinterpret_cast<const T*>(&out);
  if (code >= 0) values(std::vector<T>(first, first + sizeof out / sizeof(T)));
  end();
}

template <class T>
void misfit(const std::vector<T>& corners, const Array<T>& rect) {
  const std::vector<T>& n = rect.numbers;
  const typename Structs<T>::Rect r{n[0], n[1], n[2], n[3], n[4], n[5]};
  T out{};
  begin<T>("rect_corners_misfit"), numbers_argument(corners), argument(rect);
  const int code = call::rect_corners_misfit(T{}, corners.data(), &r, &out);
  result(code);
  if (code >= 0) values(std::vector<T>{out});
  end();
}

template <class T>
void constructors() {
  using Rect = typename Structs<T>::Rect;
  using Ellipse = typename Structs<T>::Ellipse;
  using Capsule = typename Structs<T>::Capsule;
  using RoundRect = typename Structs<T>::RoundRect;
  using Box = typename Structs<T>::Aabb;
  using Numbers = std::vector<T>;
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  const auto box = [](const Numbers& n, Box* out) { return call::aabb_from_corners(T{}, n[0], n[1], n[2], n[3], out); };
  const auto rect = [](const Numbers& n, Rect* out) {
    return call::rect_from_angle(T{}, n[0], n[1], n[2], n[3], n[4], out);
  };
  const auto corners = [](const Numbers& n, Rect* out) { return call::rect_from_corners(T{}, n.data(), out); };
  const auto round_rect = [](const Numbers& n, RoundRect* out) {
    return call::round_rect_from_angle(T{}, n[0], n[1], n[2], n[3], n[4], n[5], out);
  };
  const auto capsule = [](const Numbers& n, Capsule* out) {
    return call::capsule_from_angle(T{}, n[0], n[1], n[2], n[3], n[4], out);
  };
  const auto width = [](const Numbers& n, Capsule* out) {
    return call::capsule_from_width(T{}, n[0], n[1], n[2], n[3], n[4], out);
  };
  const auto ellipse = [](const Numbers& n, Ellipse* out) {
    return call::ellipse_from_angle(T{}, n[0], n[1], n[2], n[3], n[4], out);
  };
  const auto vector = [](const Numbers& n, Ellipse* out) {
    return call::ellipse_from_radius_vector(T{}, n[0], n[1], n[2], n[3], n[4], out);
  };
  const auto covariance = [](const Numbers& n, Ellipse* out) {
    return call::ellipse_from_covariance(T{}, n[0], n[1], n[2], n[3], n[4], n[5], out);
  };
  const auto matrix = [](const Numbers& n, Ellipse* out) {
    return call::ellipse_from_matrix(T{}, n[0], n[1], n[2], n[3], n[4], out);
  };
  constructed<T, Box>("aabb_from_corners", box, {3, -1, 0.5, 2});
  constructed<T, Box>("aabb_from_corners", box, {nan, -1, 0.5, 2});
  constructed<T, Rect>("rect_from_angle", rect, {1, 2, T(0.3), 4, 3});
  constructed<T, Rect>("rect_from_angle", rect, {1, 2, T(0.3), -4, 3});
  constructed<T, Rect>("rect_from_corners", corners, {0, 0, 4, 3, 2.5, 5, -1.5, 2});
  constructed<T, Rect>("rect_from_corners", corners, {0, 0, 4, nan, 2.5, 5, -1.5, 2});
  constructed<T, Rect>("rect_from_corners", corners, {0, 0, 4, 0, 0, 2, 4, 2});
  misfit<T>({0, 0, 4, 0, 5, 1, 1, 1}, {VESICA_RECT, {2.5, 0.5, 1, 0, 2, 0.5}});
  misfit<T>({0, 0, 4, 0, 5, 1, 1, 1}, {VESICA_RECT, {2.5, 0.5, 1, 0, 2, -0.5}});
  constructed<T, RoundRect>("round_rect_from_angle", round_rect, {1, 2, T(0.3), 4, 3, 0.5});
  constructed<T, RoundRect>("round_rect_from_angle", round_rect, {1, 2, T(0.3), 4, 3, 1.75});
  constructed<T, Capsule>("capsule_from_angle", capsule, {1, 2, T(0.3), 4, 3});
  constructed<T, Capsule>("capsule_from_angle", capsule, {1, 2, T(0.3), -4, 3});
  constructed<T, Capsule>("capsule_from_width", width, {1, 2, 4, 6, 3});
  constructed<T, Capsule>("capsule_from_width", width, {1, 2, 4, 6, -3});
  constructed<T, Ellipse>("ellipse_from_angle", ellipse, {1, 2, T(-0.75), 4, 3});
  constructed<T, Ellipse>("ellipse_from_angle", ellipse, {1, nan, T(-0.75), 4, 3});
  constructed<T, Ellipse>("ellipse_from_radius_vector", vector, {1, 2, 3, 4, 0.5});
  constructed<T, Ellipse>("ellipse_from_radius_vector", vector, {1, 2, 3, 4, -0.5});
  constructed<T, Ellipse>("ellipse_from_covariance", covariance, {1, 2, 9, 1.5, 4, 2});
  constructed<T, Ellipse>("ellipse_from_covariance", covariance, {1, 2, 1, 5, 1, 2});
  constructed<T, Ellipse>("ellipse_from_matrix", matrix, {1, 2, 9, 1.5, 4});
  constructed<T, Ellipse>("ellipse_from_matrix", matrix, {1, 2, 0, 0, 4});
}

// ---- Arrays ----

template <class R, class T, class Call>
void many(const char* name, Call call, const Array<T>& a, const Array<T>& b, std::size_t columns) {
  const std::size_t count = std::max(a.count(), b.count());
  std::vector<R> out(columns * count);
  begin<T>(name), argument(a), argument(b);
  result(call(a.view(), b.view(), out.data(), count));
  values(out);
  end();
}

template <class T>
void all_many(const Array<T>& a, const Array<T>& b) {
  using View = typename Structs<T>::Shapes;
  const auto of_bytes = [](auto call) {
    return [call](const View& x, const View& y, std::uint8_t* out, std::size_t) { return call(T{}, &x, &y, out); };
  };
  const auto of_numbers = [](auto call) {
    return [call](const View& x, const View& y, T* out, std::size_t) { return call(T{}, &x, &y, out); };
  };
  const auto of_points = [](auto call) {
    return [call](const View& x, const View& y, T* out, std::size_t n) {
      return call(T{}, &x, &y, out, out + n, out + 2 * n, out + 3 * n, out + 4 * n);
    };
  };
  const auto of_depths = [](const View& x, const View& y, T* out, std::size_t n) {
    return call::depth_many(T{}, &x, &y, out, out + n, out + 2 * n);
  };
  many<std::uint8_t>("overlap_many", of_bytes(call::overlap_many), a, b, 1);
  many<std::uint8_t>("interiors_overlap_many", of_bytes(call::interiors_overlap_many), a, b, 1);
  many<std::uint8_t>("relation_many", of_bytes(call::relation_many), a, b, 1);
  many<std::uint8_t>("contains_many", of_bytes(call::contains_many), a, b, 1);
  many<T>("nearest_many", of_points(call::nearest_many), a, b, 5);
  many<T>("boundary_distance_many", of_points(call::boundary_distance_many), a, b, 5);
  many<T>("depth_many", of_depths, a, b, 3);
  many<T>("area_many", of_numbers(call::area_many), a, b, 1);
  many<T>("iou_many", of_numbers(call::iou_many), a, b, 1);
}

template <class R, class T, class Call>
void matrix(const char* name, Call call, const Array<T>& a, const Array<T>& b) {
  std::vector<R> out(a.count() * b.count());
  const auto view_a = a.view(), view_b = b.view();
  begin<T>(name), argument(a), argument(b);
  result(call(T{}, &view_a, &view_b, out.data(), static_cast<std::ptrdiff_t>(b.count())));
  values(out);
  end();
}

template <class T>
void all_matrices(const Array<T>& a, const Array<T>& b) {
  matrix<std::uint8_t>("overlap_matrix", call::overlap_matrix, a, b);
  matrix<std::uint8_t>("interiors_overlap_matrix", call::interiors_overlap_matrix, a, b);
  matrix<std::uint8_t>("relation_matrix", call::relation_matrix, a, b);
  matrix<std::uint8_t>("contains_matrix", call::contains_matrix, a, b);
  matrix<T>("area_matrix", call::area_matrix, a, b);
  matrix<T>("iou_matrix", call::iou_matrix, a, b);
}

template <class T, class Call>
void select(const char* name, Call call, const Array<T>& one, const Array<T>& many) {
  std::vector<std::int64_t> out(many.count() + 1, -1);
  const auto view_one = one.view(), view_many = many.view();
  begin<T>(name), argument(one), argument(many);
  result(call(T{}, &view_one, &view_many, out.data(), static_cast<std::int64_t>(out.size())));
  out.resize(static_cast<std::size_t>(std::find(out.begin(), out.end(), -1) - out.begin()));
  values(out);
  end();
}

template <class T>
void nms(const Array<T>& boxes, const std::vector<T>& scores, T threshold) {
  std::vector<std::int64_t> keep(boxes.count());
  std::vector<unsigned char> scratch(static_cast<std::size_t>(vesica_nms_scratch(std::int64_t(boxes.count()))));
  const auto view = boxes.view();
  std::int64_t kept = 0;
  begin<T>("nms"), argument(boxes), numbers_argument(scores), numbers_argument(std::vector<T>{threshold});
  result(call::nms(T{}, &view, scores.data(), threshold, scratch.data(), std::int64_t(scratch.size()), keep.data(),
                   &kept));
  keep.resize(static_cast<std::size_t>(kept));
  values(keep);
  end();
}

template <class T>
void arrays() {
  const auto rects = series<T>(VESICA_RECT, 7), ellipses = series<T>(VESICA_ELLIPSE, 7);
  const auto points = series<T>(VESICA_POINT, 3), boxes = series<T>(VESICA_AABB, 5);
  all_many(rects, ellipses);
  all_many(with_invalid(rects), sample<T>(VESICA_CIRCLE, 0.5, 0));
  all_many(points, series<T>(VESICA_SEGMENT, 3));
  all_matrices(boxes, points);
  all_matrices(with_invalid(boxes), ellipses);
  select("overlap_select", call::overlap_select, sample<T>(VESICA_CIRCLE, 1, 0), rects);
  select("overlap_select", call::overlap_select, sample<T>(VESICA_ELLIPSE, 1, 0), with_invalid(boxes));
  select("interiors_overlap_select", call::interiors_overlap_select, sample<T>(VESICA_CIRCLE, 1, 0), rects);
  select("interiors_overlap_select", call::interiors_overlap_select, sample<T>(VESICA_AABB, 1, 0), with_invalid(boxes));
  nms(rects, std::vector<T>{0.5, 0.25, 0.75, 0.875, 0.125, 0.375, 0.625}, T(0.25));
  nms(with_invalid(boxes), std::vector<T>{1, 2, 3, 4, 5}, T(0.125));
  nms(boxes, std::vector<T>{1, 2, 3, 4, 5}, T(1.5));
  nms(points, std::vector<T>{1, 2, 3}, T(0.5));
}

// ---- Index and join ----

template <class T>
void sets_argument(const std::vector<Array<T>>& sets) {
  for (const auto& set : sets) argument(set);
}

template <class T>
void join(int query, const Built<T>& a, const Built<T>& b) {
  std::vector<std::int64_t> first(1000), second(1000), pairs, state(4);
  Lines scratch(vesica_join_scratch());
  begin<T>("join"), numbers_argument(std::vector<int>{query}), sets_argument(a.sets), std::printf(" | /");
  if (&a != &b) sets_argument(b.sets);
  const auto found = call::join(T{}, query, a.index.data(), a.views.data(), a.set_count(), b.index.data(),
                                b.views.data(), b.set_count(), std::int64_t{0}, std::int64_t{1}, scratch.data(),
                                scratch.size(), first.data(), second.data(), std::int64_t{1000}, state.data());
  must(state[0] == -1, "join");
  for (std::size_t i = 0; i < static_cast<std::size_t>(found); ++i) pairs.insert(pairs.end(), {first[i], second[i]});
  result(found), values(pairs), end();
}

template <class T>
void index_questions(const Built<T>& built) {
  std::vector<std::int64_t> items(built.count), state(4);
  vesica_aabb_f64 box{};
  begin<T>("index_bounds"), sets_argument(built.sets);
  result(vesica_index_bounds(built.index.data(), &box));
  values(std::vector<double>{box.min_x, box.min_y, box.max_x, box.max_y}), end();

  begin<T>("index_order"), sets_argument(built.sets);
  const auto valid = vesica_index_order(built.index.data(), items.data(), std::int64_t(items.size()));
  items.resize(static_cast<std::size_t>(valid));
  result(valid), values(items), end();

  for (const auto& one : {sample<T>(VESICA_CIRCLE, 1, 0), sample<T>(VESICA_POINT, 90, 0), invalid<T>(VESICA_AABB)}) {
    items.assign(built.count, -1);
    const auto view = one.view();
    begin<T>("index_select"), argument(one), sets_argument(built.sets);
    std::fill(state.begin(), state.end(), 0);
    const auto found = call::index_select(T{}, built.index.data(), built.views.data(), built.set_count(), &view,
                                          items.data(), std::int64_t(items.size()), state.data());
    items.resize(found < 0 ? 0 : static_cast<std::size_t>(found));
    result(found), values(items), end();
  }
}

template <class T>
void nearest(const Built<T>& built, const Array<T>& one, std::int64_t k, T within) {
  std::vector<std::int64_t> items(static_cast<std::size_t>(k));
  std::vector<T> distances(items.size());
  const auto view = one.view();
  begin<T>("index_nearest"), argument(one), numbers_argument(std::vector<double>{double(k), double(within)});
  sets_argument(built.sets);
  const auto found = call::index_nearest(T{}, built.index.data(), built.views.data(), built.set_count(), &view, k,
                                         within, items.data(), distances.data());
  items.resize(static_cast<std::size_t>(found)), distances.resize(items.size());
  result(found), values(items), values(distances), end();
}

template <class T>
void nearest_of_each(const Built<T>& asked, const Built<T>& built, std::int64_t k, T within) {
  std::vector<std::int64_t> items(asked.count * static_cast<std::size_t>(k));
  std::vector<T> distances(items.size());
  begin<T>("join_nearest"), numbers_argument(std::vector<double>{double(k), double(within)});
  sets_argument(asked.sets), std::printf(" | /"), sets_argument(built.sets);
  result(call::join_nearest(T{}, asked.views.data(), asked.set_count(), built.index.data(), built.views.data(),
                            built.set_count(), k, within, std::int64_t{0}, std::int64_t{1}, items.data(),
                            distances.data()));
  values(items), values(distances), end();
}

template <class T>
void indexes() {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const Built<T> a({series<T>(VESICA_RECT, 5), series<T>(VESICA_POINT, 3)});
  const Built<T> b({with_invalid(series<T>(VESICA_AABB, 4)), series<T>(VESICA_ELLIPSE, 3)});
  index_questions(a);
  index_questions(b);
  for (int query = VESICA_JOIN_OVERLAP; query <= VESICA_JOIN_INTERIORS; ++query) join(query, a, b);
  join(VESICA_JOIN_OVERLAP, a, a);
  nearest(a, sample<T>(VESICA_SEGMENT, 9, 0), 3, infinity);
  nearest(b, sample<T>(VESICA_SEGMENT, 9, 0), 7, T(4));
  nearest_of_each(a, b, 2, infinity);
  nearest_of_each(b, a, 2, T(1.5));
}

template <class T>
void all(int step) {
  pairs<T>(step);
  for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; kind += step) of_one(sample<T>(kind, 0.3, 0.7));
  for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) of_one(invalid<T>(kind));
  constructors<T>();
  arrays<T>();
  indexes<T>();
  measures<T>();
  motion<T>();
  topology<T>();
}

}  // namespace

int main() {
  std::printf("%s", head);
  all<double>(2);
  all<float>(5);
  matches();
  return 0;
}
