// Any bytes, read as an object of space of JSON or WKT Z, as it is and with polygons projected; then as a body, or
// against a plane. Seeds: cases/space, cases/broken-space.
#include <fuzz/require.h>

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh_body.h>
#include <sunder/io/mesh/space_objects.h>
#include <sunder/solid/line/flat_flat.h>
#include <sunder/solid/object/flatness.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/section/polyhedron_plane.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

using sunder::fuzz::require;
namespace {

using sunder::io::SpaceObject;
using Kind = SpaceObject::Kind;
namespace solid = sunder::solid;

void check_line(const std::string& text) {
  require(!text.empty());
  for (const char c : text) require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
}

const solid::Plane& floor_plane() {
  static const solid::Plane plane = solid::Plane::at({0, 0, 1}, 0.5);
  return plane;
}

void check_bounded(const SpaceObject& object) {
  const auto body = sunder::io::body_of_mesh(sunder::io::mesh_of(object), "a.json", false);
  const int most = object.kind == Kind::box       ? 3
                   : object.kind == Kind::polygon ? 2
                   : object.kind == Kind::segment ? 1
                                                  : 0;
  require(body.hull.dimension() <= most);
  const solid::Pose pose = object.frame ? object.frame->pose() : solid::Pose();
  const auto answer = solid::polyhedron_plane(body.hull, pose, floor_plane());
  require(side_of(answer) == side_of(solid::polyhedron_plane_by_scan(body.hull, pose, floor_plane())));
}

void check(std::string_view text, const solid::Frame* project) {
  SpaceObject object;
  try {
    object = sunder::io::parse_space_object(text, "a.json", project);
  } catch (const sunder::Error& error) {
    require(error.code() == sunder::ErrorCode::bad_file && std::string_view(error.what()).starts_with("a.json"));
    check_line(error.what());
    return;
  }
  require(object.format == "JSON" || object.format == "WKT");
  for (const sunder::Point3& p : object.points) {
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  require(object.round.has_value() == (object.kind > Kind::plane));
  if (object.round) {
    static const solid::RoundBody ball = solid::RoundBody::ball({0.5, 0.25, 0}, 1);
    const auto answer = solid::round_round(*object.round, solid::Pose(), ball, solid::Pose());
    const auto swapped = solid::round_round(ball, solid::Pose(), *object.round, solid::Pose());
    require(answer.undecided() || swapped.undecided() || answer.meet() == swapped.meet());
    return;
  }
  if (!object.unbounded()) return check_bounded(object);
  if (object.kind == Kind::plane) {
    require(object.points.empty());
    (void)solid::flat_flat(object.plane, floor_plane());
    const auto body = solid::body_of(object.plane);
    if (body) require(solid::height(object.plane, sunder::exactly(body->points[0])).sign() == sunder::Sign::zero);
    return;
  }
  require(object.points.size() == 2);
  (void)solid::flat_flat(solid::Line::through(object.points[0], object.points[1]), floor_plane());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  (void)sunder::io::is_space_text(text);
  static const solid::Frame frame = solid::Frame::of({0, 0, 1}, {2, 0, 0}, {1, 1, 0});
  check(text, nullptr);
  check(text, &frame);
  return 0;
}
