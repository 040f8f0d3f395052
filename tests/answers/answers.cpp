// SPDX-License-Identifier: Apache-2.0
#include "answers/answers.hpp"

#include <cstring>
#include <fstream>
#include <stdexcept>

#include "capi/face.hpp"
#include "environment/method_calls.hpp"
#include "stress/call.hpp"

namespace answers {
namespace {

using properties::Scalar;
using stress::Query;

constexpr Scalar scalars[] = {Scalar::f64, Scalar::f32};

Functions which_asks(const std::string& name) {
  const bool c_library = name == "impact_time" || name.ends_with("_from_angle") || name == "boxes";
  return c_library ? Functions::by_the_c_library : Functions::own;
}

std::string row(const char* name, Scalar scalar) { return std::string(name) + ' ' + properties::name(scalar); }

template <class T>
void append(Bytes& bytes, const T& value) {
  const auto* from = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof value);
}

/// Within exactly the distance that signed_distance returns, and within its neighbours.
Bytes ask_within(const Case& c, Scalar scalar) {
  const stress::Answer signed_distance = stress::ask(Query::signed_distance, scalar, c.pair);
  Bytes bytes;
  if (signed_distance.code < 0) return bytes;
  const std::int64_t place = properties::ordinal(scalar, signed_distance.numbers[0]);
  for (const std::int64_t p : {place - 1, place, place + 1}) {
    const double distance = properties::at_ordinal(scalar, p);
    append(bytes, stress::ask({Query::within, scalar, c.pair, {}, distance}).code);
  }
  return bytes;
}

/// Both shapes move, neither turns.
template <class T>
Bytes ask_impact_time(const Case& c) {
  using F = capi_tests::Face<T>;
  properties::NumbersOf<T> a, b;
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = static_cast<T>(c.pair.a[i]), b[i] = static_cast<T>(c.pair.b[i]);
  const T vx = static_cast<T>(c.motion.vx), vy = static_cast<T>(c.motion.vy);
  const typename F::Turn of_a{vy, vx / 2, T{0}}, of_b{vx, vy, T{0}};
  typename F::Impact out{};
  T gap = 0;
  Bytes bytes;
  append(bytes, F::impact_time(c.pair.kind_a, a.data(), &of_a, c.pair.kind_b, b.data(), &of_b, T{1} / 512, &out, &gap));
  append(bytes, out);
  append(bytes, gap);
  return bytes;
}

void ask_methods(const properties::Pair& pair, const environment::Input& input, const Take& take) {
  for (const auto& method : environment::method_calls()) {
    if (method.kind_a != pair.kind_a || method.kind_b != pair.kind_b) continue;
    take("method " + row(method.name, method.scalar), method.ask(input));
  }
}

}  // namespace

Bytes bytes_of(const stress::Answer& answer) {
  Bytes bytes;
  append(bytes, answer.code);
  append(bytes, answer.numbers);
  return bytes;
}

std::vector<Case> read_cases(const std::string& path, int kind_a, int kind_b) {
  std::ifstream in(path);
  std::vector<Case> cases;
  std::string line;
  const std::string begin = std::string(properties::kind_name(kind_a)) + ' ';
  const std::string middle = std::string(" | ") + properties::kind_name(kind_b) + ' ';
  while (std::getline(in, line)) {
    if (!line.starts_with(begin) || line.find(middle) == std::string::npos) continue;
    const auto read = stress::parse("cast " + line);
    if (!read) throw std::runtime_error("not a case: " + line);
    cases.push_back({read->pair, read->motion});
  }
  return cases;
}

void ask(Functions which, const Case& c, const Take& take) {
  const environment::Input input(c.pair);
  for (const Scalar scalar : scalars) {
    for (const auto& call : environment::scalar_calls(scalar)) {
      if (which_asks(call.name) == which) take(row(call.name, scalar), call.ask(input));
    }
    if (which == Functions::by_the_c_library) continue;
    for (const Query query : {Query::cast, Query::sweep_bounds}) {
      const std::string name = std::string(stress::name(query)) + " of a case";
      take(row(name.c_str(), scalar), bytes_of(stress::ask({query, scalar, c.pair, c.motion})));
    }
    take(row("within about the distance", scalar), ask_within(c, scalar));
  }
  if (which == Functions::by_the_c_library) return ask_methods(c.pair, input, take);
  take(row("impact_time without turning", Scalar::f64), ask_impact_time<double>(c));
  take(row("impact_time without turning", Scalar::f32), ask_impact_time<float>(c));
}

void ask_arrays(Functions which, const std::vector<Case>& cases, const Take& take) {
  environment::Inputs inputs;
  for (const Case& c : cases) inputs.pairs.emplace_back(c.pair);
  for (const Scalar scalar : scalars) {
    for (const auto& call : environment::batch_calls(scalar)) {
      if (which_asks(call.name) == which) take(row(call.name, scalar), call.ask(inputs));
    }
  }
}

}  // namespace answers
