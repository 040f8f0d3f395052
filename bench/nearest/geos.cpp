// SPDX-License-Identifier: Apache-2.0
/// GEOS through its C API: GEOSDistance of two polygons, circles and ellipses as 64-gons.
#include <geos_c.h>

#include "nearest/contestant.hpp"

namespace vesica::bench {
namespace {

struct Destroy {
  GEOSContextHandle_t context;
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
};
using Polygon = std::unique_ptr<GEOSGeometry, Destroy>;

struct Finish {
  void operator()(GEOSContextHandle_t context) const { GEOS_finish_r(context); }
};

class Polygons final : public DistancePairs {
 public:
  Polygons(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs) : context_(GEOS_init_r()) {
    for (const OutlinePair& p : pairs) {
      a_.push_back(polygon(kind_a, p.a));
      b_.push_back(polygon(kind_b, p.b));
    }
  }
  double distance(std::size_t pair) override {
    double result = 0;
    GEOSDistance_r(context_.get(), a_[pair].get(), b_[pair].get(), &result);
    return result;
  }

 private:
  Polygon polygon(std::int32_t kind, const Numbers& shape) const {
    const auto outline = outline_of(kind, shape);
    const auto count = static_cast<unsigned>(outline.size());
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_.get(), count + 1, 2);
    for (unsigned i = 0; i <= count; ++i) {  // a ring repeats its first vertex
      GEOSCoordSeq_setXY_r(context_.get(), sequence, i, outline[i % count].x, outline[i % count].y);
    }
    GEOSGeometry* ring = GEOSGeom_createLinearRing_r(context_.get(), sequence);
    return {GEOSGeom_createPolygon_r(context_.get(), ring, nullptr, 0), Destroy{context_.get()}};
  }

  std::unique_ptr<GEOSContextHandle_HS, Finish> context_;
  std::vector<Polygon> a_, b_;
};

std::unique_ptr<DistancePairs> make(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs) {
  return std::make_unique<Polygons>(kind_a, kind_b, pairs);
}

const bool added = add_contestant({"GEOS, 64-gons", any_kinds, make, 4});

}  // namespace
}  // namespace vesica::bench
