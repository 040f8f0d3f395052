// SPDX-License-Identifier: Apache-2.0
#include "contacts.hpp"

#include <cmath>

namespace vesica::bench {
namespace {

// Every number below is an integer, and each bound is chosen so that no sum or product formed here exceeds 2^53.

struct Vector {
  double x, y;
};

constexpr Vector operator+(Vector p, Vector q) { return {p.x + q.x, p.y + q.y}; }
constexpr Vector operator-(Vector p, Vector q) { return {p.x - q.x, p.y - q.y}; }
constexpr Vector operator*(double s, Vector p) { return {s * p.x, s * p.y}; }
constexpr Vector perp(Vector p) { return {-p.y, p.x}; }
constexpr double dot(Vector p, Vector q) { return p.x * q.x + p.y * q.y; }
constexpr double cross(Vector p, Vector q) { return p.x * q.y - p.y * q.x; }
constexpr double sign(double x) { return x < 0 ? -1 : 1; }

Vector random_axis(Random& random, double largest) {
  const auto component = [&] { return random.integer(1, largest) * (random.chance(0.5) ? 1 : -1); };
  return {component(), component()};
}

/// cosine = leg0 / hypotenuse, sine = leg1 / hypotenuse.
struct PythagoreanAngle {
  double leg0, leg1, hypotenuse;
};

PythagoreanAngle random_angle(Random& random, double largest) {
  const double m = random.integer(2, largest), n = random.integer(1, m - 1);
  return {m * m - n * n, 2 * m * n, m * m + n * n};
}

Numbers shape(Vector centre, Vector axis, double size0, double size1) {
  return {centre.x, centre.y, axis.x, axis.y, size0, size1};
}

Vector random_centre(Random& random) { return {random.integer(-0x1p40, 0x1p40), random.integer(-0x1p40, 0x1p40)}; }

/// The rectangle of this axis and these half extents that touches with a corner, and otherwise lies on the side of
/// `contact` that `outward` points to.
Numbers rect_on_corner(Vector contact, Vector outward, Vector axis, double hx, double hy) {
  const Vector towards_centre =
      (sign(dot(outward, axis)) * hx) * axis + (sign(dot(outward, perp(axis))) * hy) * perp(axis);
  return shape(contact + towards_centre, axis, hx, hy);
}

std::pair<Numbers, Numbers> corner_on_ellipse(Random& random) {
  const PythagoreanAngle angle = random_angle(random, 64);
  const Vector axis = random_axis(random, 0x1p10);
  const double scale0 = random.integer(1, 0x1p10), scale1 = random.integer(1, 0x1p10);
  const double a = scale0 * angle.hypotenuse, b = scale1 * angle.hypotenuse;
  const Vector centre = random_centre(random);
  const Vector contact = centre + (scale0 * angle.leg0) * axis + (scale1 * angle.leg1) * perp(axis);
  // The normal at (s, t) is (s / a^2, t / b^2): here (leg0 / scale0, leg1 / scale1) up to a factor.
  const Vector outward = (angle.leg0 * scale1) * axis + (angle.leg1 * scale0) * perp(axis);
  const Numbers rect = rect_on_corner(contact, outward, random_axis(random, 0x1p16), random.integer(1, 0x1p20),
                                      random.integer(1, 0x1p20));
  return {rect, shape(centre, axis, a, b)};
}

std::pair<Numbers, Numbers> face_on_ellipse(Random& random) {
  const PythagoreanAngle angle = random_angle(random, 16);
  const Vector axis = random_axis(random, 0x1p8);
  const double scale0 = random.integer(1, 0x1p8), scale1 = random.integer(1, 0x1p8);
  const double a = scale0 * angle.hypotenuse, b = scale1 * angle.hypotenuse;
  const Vector centre = random_centre(random);
  const Vector contact = centre + (scale0 * angle.leg0) * axis + (scale1 * angle.leg1) * perp(axis);
  const Vector outward = (angle.leg0 * scale1) * axis + (angle.leg1 * scale0) * perp(axis);
  const double hx = random.integer(1, 0x1p20), hy = random.integer(1, 0x1p20);
  const Vector rect_centre = contact + hx * outward + random.integer(-hy, hy) * perp(outward);
  return {shape(rect_centre, outward, hx, hy), shape(centre, axis, a, b)};
}

/// An ellipse and its point of outward normal `normal`, relative to the centre.
struct EllipseAndPoint {
  Vector axis, point;
  double a, b;
};

// Choose a and b so that a p and b q, p and q the normal's components along the axes, are the legs of a Pythagorean
// triple. The support function sqrt((a p)^2 + (b q)^2) is then an integer and the point (a^2 p, b^2 q) / support too.
EllipseAndPoint ellipse_with_normal(Random& random, Vector normal) {
  const PythagoreanAngle angle = random_angle(random, 8);
  Vector axis;
  double p, q;
  do {
    axis = random_axis(random, 0x1p8);
    p = dot(axis, normal);
    q = cross(axis, normal);
  } while (p == 0 || q == 0);
  const double p_size = std::fabs(p), q_size = std::fabs(q);
  const double along = sign(p) * q_size * angle.leg0 * angle.leg0;
  const double across = sign(q) * p_size * angle.leg1 * angle.leg1;
  return {axis, along * axis + across * perp(axis), q_size * angle.leg0 * angle.hypotenuse,
          p_size * angle.leg1 * angle.hypotenuse};
}

Numbers segment(Vector from, Vector to) { return {from.x, from.y, to.x, to.y}; }

/// A shape on the line through `contact` across `outward`, or on the other side of it. `length` is outward's.
Numbers short_shape(Random& random, std::int32_t kind, Vector contact, Vector outward, double length) {
  const Vector along = perp(outward);
  const auto small = [&] { return random.integer(1, 31); };
  switch (kind) {
    case VESICA_POINT:
      return {contact.x, contact.y};
    case VESICA_SEGMENT:
      if (random.chance(0.5)) return segment(contact + small() * along, contact - small() * along);
      return segment(contact, contact - small() * outward + random.integer(-31, 31) * along);
    case VESICA_CIRCLE: {
      const double times = small();
      const Vector centre = contact - times * outward;
      return {centre.x, centre.y, times * length};
    }
    case VESICA_AABB: {
      const double x = contact.x - sign(outward.x) * small(), y = contact.y - sign(outward.y) * small();
      return {std::fmin(x, contact.x), std::fmin(y, contact.y), std::fmax(x, contact.x), std::fmax(y, contact.y)};
    }
    default:
      if (random.chance(0.5)) {
        return rect_on_corner(contact, -1.0 * outward, random_axis(random, 31), small(), small());
      }
      const double hx = small(), hy = small();
      return shape(contact - hx * outward + random.integer(-hy, hy) * along, outward, hx, hy);
  }
}

}  // namespace

std::pair<Numbers, Numbers> rect_rect_contact(Random& random) {
  const Vector axis = random_axis(random, 0x1p20);
  const double hx = random.integer(1, 0x1p20), hy = random.integer(1, 0x1p20);
  const Vector centre = random_centre(random);
  const Vector contact = centre + hx * axis + random.integer(-hy, hy) * perp(axis);
  const Numbers other =
      rect_on_corner(contact, axis, random_axis(random, 0x1p20), random.integer(1, 0x1p20), random.integer(1, 0x1p20));
  return {shape(centre, axis, hx, hy), other};
}

std::pair<Numbers, Numbers> rect_ellipse_contact(Random& random) {
  return random.chance(0.5) ? corner_on_ellipse(random) : face_on_ellipse(random);
}

std::pair<Numbers, Numbers> ellipse_ellipse_contact(Random& random) {
  const Vector normal = random_axis(random, 0x1p8);
  const EllipseAndPoint first = ellipse_with_normal(random, normal);
  const EllipseAndPoint second = ellipse_with_normal(random, -1.0 * normal);
  const Vector centre = random_centre(random);
  const Vector other = centre + first.point - second.point;
  return {shape(centre, first.axis, first.a, first.b), shape(other, second.axis, second.a, second.b)};
}

std::pair<Numbers, Numbers> short_contact(Random& random, std::int32_t kind_a, std::int32_t kind_b) {
  const PythagoreanAngle angle = random_angle(random, 7);
  const auto flip = [&] { return random.chance(0.5) ? 1.0 : -1.0; };
  const Vector outward{flip() * angle.leg0, flip() * angle.leg1};
  const Vector contact{random.integer(-1000, 1000), random.integer(-1000, 1000)};
  return {short_shape(random, kind_a, contact, outward, angle.hypotenuse),
          short_shape(random, kind_b, contact, -1.0 * outward, angle.hypotenuse)};
}

}  // namespace vesica::bench
