// SPDX-License-Identifier: Apache-2.0
#include "cast/swept/contact.hpp"

namespace swept {

std::unique_ptr<Contact> contact(const Scene& scene) {
  if (scene.velocity.x == 0 && scene.velocity.y == 0) {
    Scene moving = scene;
    moving.velocity.x = 1;
    return contact(moving);
  }
  const Figure &a = scene.a, &b = scene.b;
  if (!a.corners.empty() && !b.corners.empty()) return polygons(scene);
  if (!a.corners.empty() || !b.corners.empty()) return polygon_and_ellipse(scene);
  return a.is_disc && b.is_disc ? discs(scene) : ellipses(scene);
}

}  // namespace swept
