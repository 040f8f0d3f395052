// SPDX-License-Identifier: Apache-2.0
#include "stress/query.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "properties/refused.hpp"

namespace stress {
namespace {

std::optional<int> find_kind(const std::string& word) {
  for (int kind = 0; kind < properties::kinds; ++kind) {
    if (word == properties::kind_name(kind)) return kind;
  }
  return std::nullopt;
}

std::string number_text(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), " %a", x);
  return text.data();
}

std::string shape_text(int kind, const Numbers& numbers) {
  std::string text = properties::kind_name(kind);
  for (int i = 0; i < properties::field_count(kind); ++i) {
    text += number_text(numbers[static_cast<std::size_t>(i)]);
  }
  return text;
}

bool read_number(std::istream& in, double& x) {
  std::string word;
  if (!(in >> word)) return false;
  char* end = nullptr;
  x = std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0';
}

bool read_word(std::istream& in, const char* expected) {
  std::string word;
  return in >> word && word == expected;
}

bool read_motion(std::istream& in, Motion& m) {
  return read_word(in, "|") && read_word(in, "v") && read_number(in, m.vx) && read_number(in, m.vy) &&
         read_word(in, "end") && read_number(in, m.end);
}

bool read_distance(std::istream& in, double& distance) {
  return read_word(in, "|") && read_word(in, "distance") && read_number(in, distance);
}

/// Reads a kind and its numbers.
bool read_shape(std::istream& in, int& kind, Numbers& numbers) {
  std::string word;
  if (!(in >> word)) return false;
  const auto found = find_kind(word);
  if (!found) return false;
  kind = *found;
  for (int i = 0; i < properties::field_count(kind); ++i) {
    if (!read_number(in, numbers[static_cast<std::size_t>(i)])) return false;
  }
  return true;
}

}  // namespace

const char* name(Query query) {
  constexpr std::array<const char*, all_queries.size()> names{
      "overlap",         "relation", "contains",     "nearest",      "boundary_distance",
      "depth",           "area",     "iou",          "crossings",    "shape_area",
      "bounds",          "ratio",    "cast",         "sweep_bounds", "within",
      "signed_distance", "de9im",    "intersection", "invalid",      "batch"};
  return names.at(static_cast<std::size_t>(query));
}

bool is_refused(Query query, int kind_a, int kind_b) {
  using properties::Question;
  constexpr struct {
    Query query;
    Question question;
  } questions[] = {{Query::crossings, Question::crossings},
                   {Query::boundary_distance, Question::boundary_distance},
                   {Query::de9im, Question::de9im},
                   {Query::intersection, Question::intersection}};
  for (const auto& q : questions) {
    if (q.query == query) return properties::refuses(q.question, kind_a, kind_b);
  }
  return false;
}

std::optional<Query> find_query(const std::string& text) {
  for (const Query query : all_queries) {
    if (text == name(query)) return query;
  }
  return std::nullopt;
}

std::string notation(const Case& c) {
  std::string text = std::string(name(c.query)) + '_' + properties::name(c.scalar) + ' ';
  text += shape_text(c.pair.kind_a, c.pair.a);
  if (!of_one_shape(c.query)) text += " | " + shape_text(c.pair.kind_b, c.pair.b);
  if (of_motion(c.query))
    text += " | v" + number_text(c.motion.vx) + number_text(c.motion.vy) + " end" + number_text(c.motion.end);
  if (c.query == Query::within) text += " | distance" + number_text(c.distance);
  return text;
}

std::optional<Case> parse(const std::string& text) {
  std::istringstream in(text);
  std::string word;
  if (!(in >> word)) return std::nullopt;
  Case c{Query::overlap, Scalar::f64, {0, 0, {}, {}}};
  if (word.ends_with("_f32")) c.scalar = Scalar::f32;
  if (word.ends_with("_f32") || word.ends_with("_f64")) word.resize(word.size() - 4);
  const auto query = find_query(word);
  if (!query || !read_shape(in, c.pair.kind_a, c.pair.a)) return std::nullopt;
  c.query = *query;
  if (!of_one_shape(c.query) && (!read_word(in, "|") || !read_shape(in, c.pair.kind_b, c.pair.b))) return std::nullopt;
  if (of_motion(c.query) && !read_motion(in, c.motion)) return std::nullopt;
  if (c.query == Query::within && !read_distance(in, c.distance)) return std::nullopt;
  return in >> word ? std::nullopt : std::optional(c);
}

std::vector<Case> read_cases(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  std::vector<Case> cases;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto c = parse(line);
    if (!c) throw std::runtime_error("not a case: " + line);
    cases.push_back(*c);
  }
  return cases;
}

}  // namespace stress
