// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "cast/swept/contact.hpp"

// b + t v touches a iff t v lies in the hull of the differences of a's corners and b's. A line cuts a hull of points
// between its first and its last cut with the segments that join any two of them. So each such cut is made, and no hull
// is built.

namespace swept {
namespace {

/// A corner's place across the line, and along it.
struct Corner {
  Integer across, along;
};

/// n / d, d > 0.
struct Ratio {
  Integer n, d;
};
bool operator<(const Ratio& x, const Ratio& y) { return x.n * y.d < y.n * x.d; }

class Polygons : public Contact {
 public:
  explicit Polygons(const Scene& scene) {
    const Vector& v = scene.velocity;
    const Integer square = dot(v, v);
    std::vector<Corner> left, right;
    for (const Vector& x : scene.a.corners) {
      for (const Vector& y : scene.b.corners) {
        const Vector difference = x - y;
        const Integer across = cross(v, difference), along = dot(v, difference);
        if (across == 0) cut({along, square});
        if (across > 0) left.push_back({across, along});
        if (across < 0) right.push_back({-across, along});
      }
    }
    for (const Corner& l : left) {
      for (const Corner& r : right) {
        cut({l.along * r.across + r.along * l.across, (l.across + r.across) * square});
      }
    }
  }

  bool by(const Time& t) const override { return last_ && last_->n >= 0 && first_->n * t.d <= t.n * first_->d; }
  bool begins_between(const Time& t, const Time& next) const override {
    return first_ && first_->n * t.d >= t.n * first_->d && first_->n * next.d < next.n * first_->d;
  }

 private:
  void cut(const Ratio& time) {
    if (!first_ || time < *first_) first_ = time;
    if (!last_ || *last_ < time) last_ = time;
  }

  std::optional<Ratio> first_, last_;
};

}  // namespace

std::unique_ptr<Contact> polygons(const Scene& scene) { return std::make_unique<Polygons>(scene); }

}  // namespace swept
