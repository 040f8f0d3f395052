// SPDX-License-Identifier: Apache-2.0
#include "batch/data.hpp"

#include <map>
#include <utility>

#include "properties/random.hpp"

namespace batch_tests {
namespace {

using properties::Workload;

/// The exact oracle would only make the search for contacts slower: these tests compare batches with this function.
bool decide(int kind_a, const double* a, int kind_b, const double* b) {
  return vesica_overlap_f64(kind_a, a, kind_b, b) == 1;
}

/// The generators know each two kinds in the order of shapes.
template <class T>
class Source {
 public:
  Source(Workload workload, int kind_a, int kind_b)
      : swapped_(kind_a > kind_b),
        stream_(workload, swapped_ ? kind_b : kind_a, swapped_ ? kind_a : kind_b, scalar_of<T>, properties::seed(),
                decide) {}

  properties::Pair next() { return stream_.next(); }

  void add_to(Pairs<T>& pairs, const properties::Pair& pair) const {
    const Numbers<T> first = to_scalar<T>(pair.a), second = to_scalar<T>(pair.b);
    if (swapped_) {
      pairs.add(second, first);
    } else {
      pairs.add(first, second);
    }
  }

 private:
  bool swapped_;
  properties::Stream stream_;
};

template <class T>
void shuffle(Pairs<T>& pairs, properties::Random& random) {
  for (std::size_t i = pairs.size(); i > 1; --i) {
    const auto j = static_cast<std::size_t>(random.below(static_cast<int>(i)));
    std::swap(pairs.a[i - 1], pairs.a[j]);
    std::swap(pairs.b[i - 1], pairs.b[j]);
    std::swap(pairs.answers[i - 1], pairs.answers[j]);
  }
}

/// Magnitudes far apart keep the exact stage busy for long, so few of those.
int share(Workload workload) {
  switch (workload) {
    case Workload::random:
      return 600;
    case Workload::near_contact:
      return 120;
    case Workload::mixed_scale:
      return 20;
    default:
      return 40;
  }
}

template <class T>
Pairs<T> mixed(int kind_a, int kind_b) {
  Pairs<T> pairs{kind_a, kind_b, {}, {}, {}};
  for (const Workload workload : properties::all_workloads) {
    Source<T> source(workload, kind_a, kind_b);
    for (int i = 0; i < share(workload) * properties::repeat(); ++i) source.add_to(pairs, source.next());
  }
  properties::Random random(properties::seed());
  shuffle(pairs, random);
  return pairs;
}

}  // namespace

template <class T>
Pairs<T> pairs_of(Workload workload, int kind_a, int kind_b, int count) {
  Pairs<T> pairs{kind_a, kind_b, {}, {}, {}};
  Source<T> source(workload, kind_a, kind_b);
  for (int i = 0; i < count; ++i) source.add_to(pairs, source.next());
  return pairs;
}

template <class T>
Pairs<T> pairs_about_contact(int kind_a, int kind_b, int count) {
  Pairs<T> pairs{kind_a, kind_b, {}, {}, {}};
  Source<T> source(Workload::near_contact, kind_a, kind_b);
  properties::Random random(properties::seed());
  while (static_cast<int>(pairs.size()) < count) {
    properties::Pair pair = source.next();
    const bool in_b = random.chance(0.5);
    const int kind = in_b ? pair.kind_b : pair.kind_a;
    properties::Numbers& numbers = in_b ? pair.b : pair.a;
    double& x = numbers[static_cast<std::size_t>(random.below(properties::field_count(kind)))];
    const int places = 1 << random.integer(0, 11);
    x = properties::at_ordinal(scalar_of<T>, properties::ordinal(scalar_of<T>, x) + random.integer(-places, places));
    numbers = properties::nearest_shape(scalar_of<T>, kind, numbers);
    source.add_to(pairs, pair);
  }
  return pairs;
}

template <class T>
const Pairs<T>& mixed_pairs(int kind_a, int kind_b) {
  static std::map<std::pair<int, int>, Pairs<T>> drawn;
  const std::pair key(kind_a, kind_b);
  auto found = drawn.find(key);
  if (found == drawn.end()) found = drawn.emplace(key, mixed<T>(kind_a, kind_b)).first;
  return found->second;
}

template Pairs<float> pairs_of(Workload, int, int, int);
template Pairs<double> pairs_of(Workload, int, int, int);
template Pairs<float> pairs_about_contact(int, int, int);
template Pairs<double> pairs_about_contact(int, int, int);
template const Pairs<float>& mixed_pairs(int, int);
template const Pairs<double>& mixed_pairs(int, int);

}  // namespace batch_tests
