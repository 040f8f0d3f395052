// SPDX-License-Identifier: Apache-2.0
#include "oracle/polynomial.hpp"

#include <cstddef>
#include <utility>

namespace oracle {
namespace {

/// Divides by what divides all coefficients. Otherwise they would double in length from member to member of a sequence.
void strip_content(Polynomial& f) {
  strip_power_of_two(f);
  mpz_class content = 0;
  for (const mpz_class& c : f) content = gcd(content, c);
  if (content > 1) {
    for (mpz_class& c : f) c /= content;
  }
}

/// A positive multiple of minus the remainder of f by g: the next member of a Sturm sequence. Empty when it is 0.
Polynomial negated_remainder(Polynomial f, const Polynomial& g) {
  while (f.size() >= g.size()) {
    const mpz_class scale = abs(g.back());
    const mpz_class factor = sgn(g.back()) * f.back();
    const std::size_t shift = f.size() - g.size();
    for (mpz_class& c : f) c *= scale;
    for (std::size_t i = 0; i < g.size(); ++i) f[i + shift] -= factor * g[i];
    while (!f.empty() && f.back() == 0) f.pop_back();
  }
  for (mpz_class& c : f) c = -c;
  strip_content(f);
  return f;
}

int sign_changes(const std::vector<int>& signs) {
  int changes = 0, previous = 0;
  for (const int s : signs) {
    if (s * previous < 0) ++changes;
    if (s != 0) previous = s;
  }
  return changes;
}

/// f, its derivative, and negated remainders down to their greatest common divisor.
std::vector<Polynomial> sturm_sequence(const Polynomial& f) {
  std::vector<Polynomial> sequence;
  Polynomial p = f;
  strip_content(p);
  Polynomial q = derivative(p);
  while (!p.empty()) {
    Polynomial next = q.empty() ? Polynomial{} : negated_remainder(p, q);
    sequence.push_back(std::move(p));
    p = std::move(q);
    q = std::move(next);
  }
  return sequence;
}

int sign_at_infinity(const Polynomial& f) { return sgn(f.back()); }
int sign_at_minus_infinity(const Polynomial& f) { return f.size() % 2 == 0 ? -sgn(f.back()) : sgn(f.back()); }
int sign_at_zero(const Polynomial& f) { return sgn(f.front()); }
int sign_at_one(const Polynomial& f) {
  mpz_class sum = 0;
  for (const mpz_class& c : f) sum += c;
  return sgn(sum);
}

int sign_changes(const std::vector<Polynomial>& sequence, int (*sign)(const Polynomial&)) {
  std::vector<int> signs;
  for (const Polynomial& f : sequence) signs.push_back(sign(f));
  return sign_changes(signs);
}

}  // namespace

Polynomial derivative(const Polynomial& f) {
  Polynomial result;
  for (std::size_t i = 1; i < f.size(); ++i) result.push_back(f[i] * static_cast<unsigned long>(i));
  return result;
}

Polynomial operator+(const Polynomial& f, const Polynomial& g) {
  Polynomial sum(std::max(f.size(), g.size()));
  for (std::size_t i = 0; i < f.size(); ++i) sum[i] += f[i];
  for (std::size_t i = 0; i < g.size(); ++i) sum[i] += g[i];
  while (!sum.empty() && sum.back() == 0) sum.pop_back();
  return sum;
}

Polynomial operator*(const Polynomial& f, const Polynomial& g) {
  if (f.empty() || g.empty()) return {};
  Polynomial product(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) product[i + j] += f[i] * g[j];
  }
  return product;
}

int distinct_positive_roots(const Polynomial& f) {
  const std::vector<Polynomial> sequence = sturm_sequence(f);
  return sign_changes(sequence, sign_at_zero) - sign_changes(sequence, sign_at_infinity);
}

int distinct_real_roots(const Polynomial& f) {
  const std::vector<Polynomial> sequence = sturm_sequence(f);
  return sign_changes(sequence, sign_at_minus_infinity) - sign_changes(sequence, sign_at_infinity);
}

int distinct_roots_below_1(const Polynomial& f) {
  const std::vector<Polynomial> sequence = sturm_sequence(f);
  return sign_changes(sequence, sign_at_zero) - sign_changes(sequence, sign_at_one);
}

Polynomial repeated_part(const Polynomial& f) { return sturm_sequence(f).back(); }

}  // namespace oracle
