// SPDX-License-Identifier: Apache-2.0
#include "cast/swept/roots.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace swept {
namespace {

template <class Sign>
int sign_changes(std::size_t count, Sign sign) {
  int changes = 0, last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int s = sign(i);
    if (s * last < 0) ++changes;
    if (s != 0) last = s;
  }
  return changes;
}

/// As many positive roots as f has roots between 0 and t: (1 + y)^n f(t / (1 + y)), without a root 0.
Polynomial between(const Polynomial& f, const Time& t) {
  if (t.d == 0) return f;
  const std::size_t degree = f.size() - 1;
  Polynomial g(f.rbegin(), f.rend());
  Integer power = 1;
  for (std::size_t i = 0; i <= degree; ++i, power *= t.d) g[i] *= power;
  power = 1;
  for (std::size_t i = 0; i <= degree; ++i, power *= t.n) g[degree - i] *= power;
  for (std::size_t i = 0; i < degree; ++i) {
    for (std::size_t j = degree; j-- > i;) g[j] += g[j + 1];
  }
  g.erase(g.begin(), std::find_if(g.begin(), g.end(), [](const Integer& c) { return c != 0; }));
  return g;
}

void divide_by_content(Polynomial& f) {
  Integer common = 0;
  for (const Integer& c : f) common = gcd(common, c);
  if (common <= 1) return;
  for (Integer& c : f) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), common.get_mpz_t());
}

/// Minus the remainder of f by g, times a positive number.
Polynomial negated_remainder(Polynomial f, const Polynomial& g) {
  while (f.size() >= g.size()) {
    const Integer factor = g.back() > 0 ? f.back() : -f.back(), scale = abs(g.back());
    const std::size_t shift = f.size() - g.size();
    for (std::size_t i = 0; i + 1 < f.size(); ++i) {
      f[i] *= scale;
      if (i >= shift) f[i] -= factor * g[i - shift];
    }
    f.pop_back();
    while (!f.empty() && f.back() == 0) f.pop_back();
  }
  divide_by_content(f);
  for (Integer& c : f) c = -c;
  return f;
}

/// C. Sturm's theorem, f(0) != 0.
int distinct_positive_roots(const Polynomial& f) {
  Polynomial slope;
  for (std::size_t i = 1; i < f.size(); ++i) slope.push_back(f[i] * static_cast<unsigned long>(i));
  std::vector<Polynomial> chain{f, slope};
  while (!chain.back().empty()) chain.push_back(negated_remainder(chain[chain.size() - 2], chain.back()));
  chain.pop_back();
  const auto at_zero = [&](std::size_t i) { return sgn(chain[i].front()); };
  const auto at_infinity = [&](std::size_t i) { return sgn(chain[i].back()); };
  return sign_changes(chain.size(), at_zero) - sign_changes(chain.size(), at_infinity);
}

}  // namespace

bool has_root_before(const Polynomial& f, const Time& t) {
  Polynomial g = between(f, t);
  // Descartes' rule of signs: the roots are as many, or fewer by an even number.
  const int most = sign_changes(g.size(), [&](std::size_t i) { return sgn(g[i]); });
  if (most == 0) return false;
  if (most % 2 == 1) return true;
  divide_by_content(g);
  return distinct_positive_roots(g) > 0;
}

}  // namespace swept
