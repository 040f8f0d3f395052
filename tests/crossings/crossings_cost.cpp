// SPDX-License-Identifier: Apache-2.0
// The dearest calls of vesica_crossings_f64, by a search that climbs: pairs are changed number by number, and a change
// that costs more is kept.
//   crossings_cost [climbs] [steps] [seed] [kind] [kind]
#include <vesica.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

struct Shape {
  int kind;
  std::vector<double> numbers;
};
struct Shapes {
  Shape a, b;
};

std::mt19937_64 engine;
int below(int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); }

constexpr int sizes[] = {2, 4, 4, 6, 3, 6};
const char* const names[] = {"point", "segment", "aabb", "rect", "circle", "ellipse"};

double mantissa() { return below(3) == 0 ? 1 + below(4) * 0.25 : 1 + static_cast<double>(engine() >> 12) * 0x1p-52; }
double any_number(int spread) {
  const double x = std::ldexp(mantissa(), below(2 * spread + 1) - spread);
  return below(2) == 0 ? -x : x;
}

void mend(Shape& s) {
  auto& n = s.numbers;
  const auto size = [&n](std::size_t i) { n[i] = std::fabs(n[i]); };
  if (s.kind == VESICA_CIRCLE) size(2);
  if (s.kind == VESICA_RECT || s.kind == VESICA_ELLIPSE) size(4), size(5);
  if (s.kind != VESICA_AABB) return;
  if (n[0] > n[2]) std::swap(n[0], n[2]);
  if (n[1] > n[3]) std::swap(n[1], n[3]);
}

Shape shape(int kind, int spread) {
  Shape s{kind, {}};
  for (int i = 0; i < sizes[kind]; ++i) s.numbers.push_back(any_number(spread));
  mend(s);
  return s;
}

void change(Shapes& p) {
  Shape& s = below(2) == 0 ? p.a : p.b;
  const Shape& other = below(2) == 0 ? p.a : p.b;
  double& x = s.numbers[static_cast<std::size_t>(below(static_cast<int>(s.numbers.size())))];
  switch (below(7)) {
    case 0:
      x = any_number(1020);
      break;
    case 1:
      x = std::ldexp(x, below(129) - 64);
      break;
    case 2:
      x = std::nextafter(x, below(2) == 0 ? HUGE_VAL : -HUGE_VAL);
      break;
    case 3:
      x = other.numbers[static_cast<std::size_t>(below(static_cast<int>(other.numbers.size())))];
      break;
    case 4:
      x = std::copysign(std::ldexp(mantissa(), x == 0 ? 0 : std::ilogb(x)), x);
      break;
    case 5:
      x = std::ldexp(x, below(801) - 400);
      break;
    default:
      x = below(2) == 0 ? 0 : -x;
      break;
  }
  mend(s);
}

/// In microseconds, the least of some calls; 0 for shapes that are no shapes, and those that do not meet.
double cost(const Shapes& p, int calls) {
  vesica_crossing_points_f64 out;
  double least = 1e9;
  for (int i = 0; i < calls; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const int count = vesica_crossings_f64(p.a.kind, p.a.numbers.data(), p.b.kind, p.b.numbers.data(), &out);
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
    if (count < 0 && count != VESICA_E_RANGE) return 0;
    least = std::min(least, spent.count());
  }
  return least;
}

void print(const Shape& s) {
  std::printf("%s", names[s.kind]);
  for (const double x : s.numbers) std::printf(" %a", x);
}

}  // namespace

int main(int argc, char** argv) {
  const int climbs = argc > 1 ? std::atoi(argv[1]) : 20, steps = argc > 2 ? std::atoi(argv[2]) : 2000;
  engine.seed(argc > 3 ? std::strtoull(argv[3], nullptr, 0) : 1);
  const int only_a = argc > 4 ? std::atoi(argv[4]) : -1, only_b = argc > 5 ? std::atoi(argv[5]) : -1;
  for (int a = 0; a < 6; ++a) {
    for (int b = a; b < 6; ++b) {
      if ((only_a >= 0 && a != only_a) || (only_b >= 0 && b != only_b)) continue;
      Shapes dearest{};
      double most = 0;
      for (int climb = 0; climb < climbs; ++climb) {
        const int spread = climb % 3 == 0 ? 3 : climb % 3 == 1 ? 300 : 1020;
        Shapes at{shape(a, spread), shape(b, spread)};
        double top = cost(at, 3);
        for (int i = 0; i < steps; ++i) {
          Shapes next = at;
          for (int k = below(3); k >= 0; --k) change(next);
          double spent = cost(next, 3);
          if (spent > top) spent = cost(next, 9);
          if (spent <= top) continue;
          top = spent;
          at = next;
        }
        top = cost(at, 200);
        if (top <= most) continue;
        most = top;
        dearest = at;
      }
      std::printf("%7.2f us  ", most);
      print(dearest.a);
      std::printf(" | ");
      print(dearest.b);
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}
