// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <utility>

#include "cast/swept/contact.hpp"

// In the frame where the ellipse is a disc about the origin, a polygon is met first at a corner, when that comes within
// the radius, or on a side, when the foot of the perpendicular is on it. Both are among the times at which a part of
// the polygon is met, so the earliest is the first contact. The last is that of the reversed motion.

namespace swept {
namespace {

/// The time at which |x + t w| comes down to r, an integer.
class CornerEntry {
 public:
  CornerEntry(const Vector& x, const Vector& w, const Integer& r)
      : square_(dot(w, w)), half_(dot(x, w)), rest_(dot(x, x) - r * r), is_met_(half_ * half_ >= square_ * rest_) {}

  /// The lower root of a parabola is at most t if its value there is not positive, or its slope not negative.
  bool begun(const Time& t, bool strictly) const {
    if (!is_met_) return false;
    const Integer slope = square_ * t.n + half_ * t.d;
    const Integer value = (slope + half_ * t.d) * t.n + rest_ * t.d * t.d;
    return strictly ? sgn(value) < 0 || sgn(slope) > 0 : sgn(value) <= 0 || sgn(slope) >= 0;
  }

 private:
  Integer square_, half_, rest_;
  bool is_met_;
};

/// Sign of x + y sqrt(z), z >= 0.
int sign_with_root(const Integer& x, const Integer& y, const Integer& z) {
  const int first = sgn(x), second = z == 0 ? 0 : sgn(y);
  if (first == second || second == 0) return first;
  if (first == 0) return second;
  return first * cmp(x * x, y * y * z);
}

/// The time at which a side x y comes as near as r to the origin, somewhere between its ends.
class SideEntry {
 public:
  SideEntry(const Vector& x, const Vector& y, const Vector& w, const Integer& r) : r_(r) {
    Vector along = y - x, from = x;
    speed_ = cross(w, along);
    if (speed_ == 0) return;
    if (speed_ > 0) {
      speed_ = -speed_;
      along = -along;
      from = y;
    }
    // The height x along comes down to r |along| at t = (height - r |along|) / -speed.
    height_ = cross(from, along);
    length_ = dot(along, along);
    // The foot is at -(from + t w).along of the length, times -speed here: share + slope r |along|.
    const Integer slope = dot(w, along), share = dot(from, along) * speed_ - slope * height_;
    is_met_ = sign_with_root(share, slope * r, length_) >= 0 &&
              sign_with_root(share + length_ * speed_, slope * r, length_) <= 0;
  }

  bool begun(const Time& t, bool strictly) const {
    if (!is_met_) return false;
    const int sign = sign_with_root(height_ * t.d + speed_ * t.n, -r_ * t.d, length_);
    return strictly ? sign < 0 : sign <= 0;
  }

 private:
  Integer speed_, height_, length_, r_;
  bool is_met_ = false;
};

class Entry {
 public:
  Entry(const std::vector<Vector>& corners, const Vector& w, const Integer& r) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners_.emplace_back(corners[i], w, r);
      if (corners.size() > 1) sides_.emplace_back(corners[i], corners[(i + 1) % corners.size()], w, r);
    }
  }

  bool begun(const Time& t, bool strictly) const {
    for (const CornerEntry& c : corners_) {
      if (c.begun(t, strictly)) return true;
    }
    for (const SideEntry& s : sides_) {
      if (s.begun(t, strictly)) return true;
    }
    return false;
  }

 private:
  std::vector<CornerEntry> corners_;
  std::vector<SideEntry> sides_;
};

class DiscAndPolygon : public Contact {
 public:
  /// The disc of radius r about the origin, and corners that move by w.
  DiscAndPolygon(const std::vector<Vector>& corners, const Vector& w, const Integer& r)
      : entry_(corners, w, r), ends_in_time_(Entry(corners, -w, r).begun({0, 1}, false)) {}

  bool by(const Time& t) const override { return ends_in_time_ && entry_.begun(t, false); }
  bool begins_between(const Time& t, const Time& next) const override {
    return entry_.begun(next, true) && !entry_.begun(t, true);
  }

 private:
  Entry entry_;
  bool ends_in_time_;
};

/// In the frame where the ellipse is a disc.
Vector to_disc(const Figure& e, const Vector& x) { return e.is_disc ? x : Vector{cross(x, e.q), cross(e.p, x)}; }
Integer radius(const Figure& e) { return e.is_disc ? e.p.x : cross(e.p, e.q); }

}  // namespace

std::unique_ptr<Contact> polygon_and_ellipse(const Scene& scene) {
  const bool a_is_round = scene.a.corners.empty();
  const Figure &e = a_is_round ? scene.a : scene.b, &polygon = a_is_round ? scene.b : scene.a;
  std::vector<Vector> corners;
  for (const Vector& x : polygon.corners) corners.push_back(to_disc(e, x - e.centre));
  return std::make_unique<DiscAndPolygon>(corners, to_disc(e, a_is_round ? scene.velocity : -scene.velocity),
                                          radius(e));
}

std::unique_ptr<Contact> discs(const Scene& scene) {
  const std::vector<Vector> centre{scene.b.centre - scene.a.centre};
  return std::make_unique<DiscAndPolygon>(centre, scene.velocity, radius(scene.a) + radius(scene.b));
}

}  // namespace swept
