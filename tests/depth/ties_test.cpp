// SPDX-License-Identifier: Apache-2.0
// Depths in several directions that differ by rounding alone: of nearly equal squares, and shapes that are nearly
// circles, all but concentric. Rounded arithmetic chose one of them, up to 6.5 roundoffs of the scale from the least.
#include <gtest/gtest.h>

#include <cmath>

#include "boundary_distance/reference.hpp"
#include "properties/generators.hpp"
#include "vesica.h"

namespace {

using outline_reference::Real;
using properties::Pair;

vesica_penetration_f64 depth(const Pair& p) {
  vesica_penetration_f64 out{-1, -1, -1};
  EXPECT_EQ(vesica_depth_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out), 0);
  return out;
}

TEST(DepthTies, OfShapesThatAreNearlyEqual) {
  const Pair pairs[] = {
      {VESICA_RECT,
       VESICA_CIRCLE,
       {-0x1.066cd56c5f01cp-2, 0x1.804a20cca0194p-2, 0x1.1218cc2699606p-51, -1, 0x1.1b6c3363c81b2p-1,
        0x1.1b6c3363c81b2p-1},
       {-0x1.066cd56c5f01bp-2, 0x1.804a20cca0194p-2, 0x1.1b5f9f5c34679p-1}},
      {VESICA_RECT,
       VESICA_RECT,
       {-0x1.89f1143c1cef8p-3, -0x1.d1a2e018ef0c8p+14, 0, -1, 0x1.02bb0526f599fp+0, 0x1.02bb0526f599fp+0},
       {-0x1.89f1143c1cef8p-3, -0x1.d1a2e018ef0c8p+14, 0x1.72b1e9a777b2ep-26, -0x1.91df147e43948p-3,
        0x1.49a2063e1456fp+2, 0x1.49a2063e1456dp+2}},
      {VESICA_ELLIPSE,
       VESICA_RECT,
       {0, 0x1.9d1450e93f8fep-1, 0x1.0000000000001p+0, 0, 0x1.53593e11b6d24p+0, 0x1.53593e11b6d23p+0},
       {0, 0x1.9d1450e93f9p-1, 1, 0, 0x1.53593e11b6d24p+0, 0x1.53593e11b6d24p+0}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0, 0x1.456b7795f8d1dp-2, -1, 1, 0x1.c5e535503fc5cp-1, 0x1.c5e535503fc5dp-1},
       {0, 0x1.456b7795f8d0cp-2, 1, 1, 0x1.c5e535503fc5cp-1, 0x1.c5e535503fc5cp-1}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {-0x1.2f03277905bd9p+24, 0x1.34a4f154222cep-1, 0x1.ffff0fd1c3c21p-1, 0x1.0d6fd8a298554p+0, 0x1.26321ca2d3172p-1,
        0x1.26321ca2d3171p-1},
       {-0x1.2f03277905bd9p+24, 0x1.34a4f154222d6p-1, 1, 1, 0x1.2e03a846ec0b3p-1, 0x1.2e03a846ec0b3p-1}},
      {VESICA_RECT,
       VESICA_ELLIPSE,
       {0, 0, -0x1.ee58d3faf888ap+15, -0x1.0a923df132769p+14, 0x1.4ac2c49dbc56bp-17, 0x1.4ac2c49dbc56bp-17},
       {0x1.3bee18c8f47b6p-52, 0, -0x1.ee58d3faf8889p+15, -0x1.0a923d75ffa22p+14, 0x1.4ac2c4a81855fp-17,
        0x1.4ac2c4a81855fp-17}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0, 0, -0x1.fd5e386e2d577p-1, 0x1.9ec83ae4f34a9p-4, 0x1.1c03fa2d1e7ffp-999, 0x1.1c03fa2d1e801p-999},
       {0, 0, -0x1.fd5e386e2d577p-1, 0x1.9ec83ae4f34a9p-4, 0x1.2090c0fbafa9p-999, 0x1.2090c0fbafa9p-999}},
      {VESICA_ELLIPSE,
       VESICA_ELLIPSE,
       {0x1.5e889d8cb920ap-1, 0x1.f51097882762cp-2, 0x1.9c69d5ca92d8ap-4, 0x1.fd65e9e65b0efp-1, 0x1.930f4f55da91cp+0,
        0x1.930f4f55da91cp+0},
       {0x1.5e889d8cb920bp-1, 0x1.f51097882762cp-2, 0x1.9c69d5ca92d8ap-4, 0x1.fd65e9cf59cd9p-1, 0x1.930f4f67df2f6p+0,
        0x1.930f4f67df2f3p+0}},
      {VESICA_RECT,
       VESICA_RECT,
       {-0x1.27c14320ebeeep-1, 0, -0x1p+2, 0x1.8p+1, 0x1.a82659c618d8ep-3, 0x1.a82659c618d8ep-3},
       {-0x1.27c14320ebeeep-1, 0, -0x1.8p+1, -0x1p+2, 0x1.8e0af1f8f39c3p-3, 0x1.8e0af1f8f39c7p-3}}};
  for (const Pair& pair : pairs) {
    const auto a = outline_reference::shape(pair.kind_a, pair.a), b = outline_reference::shape(pair.kind_b, pair.b);
    const Real error = abs(Real(Real(depth(pair).depth, 320) - outline_reference::least(a, b, 1).value));
    EXPECT_LE(error, Real(Real(0x1p-51, 320) * Real(outline_reference::scale(a, b), 320)))
        << properties::describe(pair);
  }
}

// Squares whose axes differ by less than the pair's unit holds, at one place.
TEST(DepthTies, OfExchangedSubnormalSquares) {
  const Pair pairs[] = {
      {VESICA_RECT,
       VESICA_RECT,
       {-0x0.7dde67f58d0e8p-1022, -0x1.14656bed6ca5ap-1014, 0, 1, 0x0.00000017c494ap-1022, 0x0.00000017c494ap-1022},
       {-0x0.7dde67f58d0e8p-1022, -0x1.14656bed6ca5ap-1014, 0x0.0000000000001p-1022, 1, 0x0.00000017c494ap-1022,
        0x0.00000017c494ap-1022}},
      {VESICA_RECT,
       VESICA_RECT,
       {-0x0.000000044560cp-1022, 0x0.00000008f00adp-1022, 0, 1, 0x0.0000001894485p-1022, 0x0.0000001894485p-1022},
       {-0x0.000000044560cp-1022, 0x0.00000008f00adp-1022, -0x0.0000000000001p-1022, 1, 0x0.0000001894485p-1022,
        0x0.0000001894485p-1022}},
      {VESICA_RECT,
       VESICA_RECT,
       {0x1.cf5bf41c62328p-1008, -0x1.7e9a382ae7d1ap-1006, 1, -0x0.0000000000001p-1022, 0x0.0000001602bffp-1022,
        0x0.0000001602bffp-1022},
       {0x1.cf5bf41c62328p-1008, -0x1.7e9a382ae7d1ap-1006, 1, 0, 0x0.0000001602bffp-1022, 0x0.0000001602bffp-1022}}};
  for (const Pair& pair : pairs) {
    const auto there = depth(pair), back = depth(properties::swapped(pair));
    EXPECT_EQ(there.depth, back.depth);
    EXPECT_EQ(there.x, -back.x);
    EXPECT_EQ(there.y, -back.y);
  }
}

}  // namespace
