// SPDX-License-Identifier: Apache-2.0
/// GEOS through its C API: GEOSIntersects, and GEOSPreparedIntersects with the first polygon of each pair prepared.
#include <geos_c.h>

#include <memory>
#include <span>
#include <vector>

#include "peer.hpp"

namespace vesica::bench {
namespace {

struct FinishContext {
  void operator()(GEOSContextHandle_t context) const { GEOS_finish_r(context); }
};
using Context = std::unique_ptr<GEOSContextHandle_HS, FinishContext>;

template <bool prepared>
class GeosPairs final : public NativePairs {
 public:
  GeosPairs() = default;
  GeosPairs(const GeosPairs&) = delete;
  GeosPairs& operator=(const GeosPairs&) = delete;

  ~GeosPairs() override {
    for (const Native& pair : pairs_) {
      if (pair.prepared_a) GEOSPreparedGeom_destroy_r(context_.get(), pair.prepared_a);
      GEOSGeom_destroy_r(context_.get(), pair.a);
      GEOSGeom_destroy_r(context_.get(), pair.b);
    }
  }

  void add(const Outline& a, const Outline& b) override {
    Native pair{polygon(a), polygon(b), nullptr};
    if (prepared) pair.prepared_a = GEOSPrepare_r(context_.get(), pair.a);
    pairs_.push_back(pair);
  }

  std::int64_t hits(std::span<const std::size_t> indices) override {
    std::int64_t hits = 0;
    for (const std::size_t i : indices) hits += overlap(pairs_[i]) == 1;
    return hits;
  }

 private:
  struct Native {
    GEOSGeometry* a;
    GEOSGeometry* b;
    const GEOSPreparedGeometry* prepared_a;
  };

  char overlap(const Native& pair) const {
    if constexpr (prepared) return GEOSPreparedIntersects_r(context_.get(), pair.prepared_a, pair.b);
    return GEOSIntersects_r(context_.get(), pair.a, pair.b);
  }

  GEOSGeometry* polygon(const Outline& outline) const {
    const auto count = static_cast<unsigned>(outline.size());
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_.get(), count + 1, 2);
    for (unsigned i = 0; i <= count; ++i) {  // a ring repeats its first vertex
      const Vertex& vertex = outline[i % count];
      GEOSCoordSeq_setXY_r(context_.get(), sequence, i, vertex.x, vertex.y);
    }
    GEOSGeometry* ring = GEOSGeom_createLinearRing_r(context_.get(), sequence);
    return GEOSGeom_createPolygon_r(context_.get(), ring, nullptr, 0);
  }

  Context context_{GEOS_init_r()};
  std::vector<Native> pairs_;
};

template <bool prepared>
std::unique_ptr<NativePairs> make() {
  return std::make_unique<GeosPairs<prepared>>();
}

const bool added = add_peer("geos", 64, make<false>) && add_peer("geos_prepared", 64, make<true>);

}  // namespace
}  // namespace vesica::bench
