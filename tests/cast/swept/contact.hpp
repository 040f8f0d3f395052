// SPDX-License-Identifier: Apache-2.0
/// When do two shapes touch, one of which moves? An oracle of casts that is quick on numbers of few digits. It shares
/// nothing with the library, nor with tests/oracle.
#pragma once

#include <memory>

#include "cast/swept/plane.hpp"

namespace swept {

class Contact {
 public:
  virtual ~Contact() = default;
  /// Is there any at a time from 0 to t, t included?
  virtual bool by(const Time& t) const = 0;
  /// For shapes apart at 0: is there contact from t on that comes before `next`, and none before t?
  virtual bool begins_between(const Time& t, const Time& next) const = 0;
};

/// Without a velocity, contact at 0 is found all the same, and that at other times is meaningless.
std::unique_ptr<Contact> contact(const Scene& scene);

std::unique_ptr<Contact> polygons(const Scene& scene);
std::unique_ptr<Contact> polygon_and_ellipse(const Scene& scene);
std::unique_ptr<Contact> discs(const Scene& scene);
std::unique_ptr<Contact> ellipses(const Scene& scene);

}  // namespace swept
