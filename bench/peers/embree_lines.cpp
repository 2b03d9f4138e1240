// Embree 3 or 4.
#include <bench/peers/line_peer.h>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <array>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bench {
namespace {

constexpr double kOutside = 4;  // from the foot of a line on

class Scene {
 public:
  Scene(const SphereBody& body, RTCSceneFlags flags)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, flags);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    const RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto vertices = body.hull.vertices();
    auto* points = static_cast<std::array<float, 3>*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(std::array<float, 3>), vertices.size()));
    auto* triangles = static_cast<std::array<std::uint32_t, 3>*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(std::array<std::uint32_t, 3>), body.triangles.size()));
    if (points == nullptr || triangles == nullptr) throw std::runtime_error("Embree failed");
    for (std::size_t i = 0; i < vertices.size(); ++i) points[i] = single(vertices[i]);
    std::copy(body.triangles.begin(), body.triangles.end(), triangles);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  static std::array<float, 3> single(const sunder::Point3& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }

  // How far from the origin of the ray on; infinite: nothing.
  double shoot(const RTCRay& ray) const {
    RTCRayHit hit{};
    hit.ray = ray;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR < 4
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &hit);
#else
    rtcIntersect1(scene_, &hit);
#endif
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? HUGE_VAL : static_cast<double>(hit.ray.tfar);
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

RTCRay ray_of(const LineQuery& q, double side) {
  const auto at = [&](double foot, double way) { return static_cast<float>(foot - side * kOutside * way); };
  RTCRay ray{};
  ray.org_x = at(q.foot.x, q.way.x);
  ray.org_y = at(q.foot.y, q.way.y);
  ray.org_z = at(q.foot.z, q.way.z);
  ray.dir_x = static_cast<float>(side * q.way.x);
  ray.dir_y = static_cast<float>(side * q.way.y);
  ray.dir_z = static_cast<float>(side * q.way.z);
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = ~0U;
  return ray;
}

template <RTCSceneFlags flags>
Run by_two_rays(const LineScenario& scenario) {
  std::vector<RTCRay> rays;
  for (const LineQuery& q : scenario.queries) {
    rays.push_back(ray_of(q, 1));
    rays.push_back(ray_of(q, -1));
  }
  return each([&queries = scenario.queries, rays = std::move(rays),
               scene = std::make_shared<const Scene>(*scenario.body, flags)](std::size_t k) {
    return queries[k].answer(scene->shoot(rays[2 * k]) - kOutside, kOutside - scene->shoot(rays[2 * k + 1]));
  });
}

}  // namespace

std::vector<LineWay> embree_line_ways() {
  return {{"embree", "two rays", by_two_rays<RTC_SCENE_FLAG_NONE>},
          {"embree", "two rays, robust", by_two_rays<RTC_SCENE_FLAG_ROBUST>}};
}

}  // namespace bench
