// GEOS through its C interface: its context, and geometries that end with their owner.
#pragma once

#include <geos_c.h>

#include <memory>

namespace bench {

struct Context {
  GEOSContextHandle_t handle = GEOS_init_r();
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { GEOS_finish_r(handle); }
};

inline GEOSContextHandle_t context() {
  static const Context one;
  return one.handle;
}

struct Destroy {
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context(), geometry); }
  void operator()(const GEOSPreparedGeometry* geometry) const { GEOSPreparedGeom_destroy_r(context(), geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;
using Prepared = std::unique_ptr<const GEOSPreparedGeometry, Destroy>;

}  // namespace bench
