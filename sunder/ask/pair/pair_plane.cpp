#include <sunder/ask/pair/pair_mixed.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/predicate/coordinates.h>
#include <sunder/solid/section/polyhedron_plane.h>
#include <sunder/solid/section/polyhedron_plane_claims.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <variant>

namespace sunder::ask {

namespace {

using solid::ConvexPolyhedron;
using solid::Plane;
using solid::PolyhedronPlane;
using solid::Pose;

using PlaneMethod = PolyhedronPlane(const ConvexPolyhedron&, const Pose&, const Plane&);
constexpr std::array<Named<PlaneMethod>, 3> plane_methods{{SUNDER_METHOD("automatic", solid::polyhedron_plane),
                                                           SUNDER_METHOD("drums", solid::polyhedron_plane_by_drums),
                                                           SUNDER_METHOD("scan", solid::polyhedron_plane_by_scan)}};

class PlanePair : public MixedPair {
 public:
  PlanePair(const PairCall& asked, const PlacedBody& body, const PlacedFlat& plane, bool body_is_a,
            const PairFiles& files)
      : MixedPair(asked, object_of(body), plane.object_of(asked), body_is_a, files),
        method_(method_by(asked.method, plane_methods, " (with a plane)")),
        body_(body),
        plane_(std::get<Plane>(plane.flat)),
        in_file_(plane.body) {}

  void ask() {
    const ConvexPolyhedron& body = body_.mesh.hull;
    function_ = method_.function;
    answer_ = method_(body, body_.pose, plane_);
    take(answer_, decided_text(answer_.decided_by));
    if (call.classify && meet_) contact_ = solid::polyhedron_plane_contact(body, body_.pose, plane_);
    tell_said_of(body_.is_hull());
    facts_.push_back(fact_of("evidence", told()));
    state([this](auto& pairs, auto first, auto second) {
      add_claims(pairs, first, second, body_.mesh.hull, body_.pose, plane_, *in_file_, answer_, contact_);
    });
  }

 private:
  // Of the nearest vertex, rounded.
  double distance(std::uint32_t nearest) const {
    const Posed3 vertex{body_.mesh.hull.vertices()[nearest], &body_.pose.affine(), false};
    const auto [x, y, z] = coordinates<Dyadic>(vertex);
    const Dyadic height = solid::height(plane_, {x, y, z, 1.0});
    const solid::Exact3 n = coordinates<Dyadic>(plane_.normal);
    return std::sqrt(nearest_ratio(height * height, dot(n, n)));
  }

  Told told() const {
    if (const auto* beside = std::get_if<solid::BesidePlane>(&answer_.evidence)) {
      const char* side = beside->side == Sign::positive ? "above" : "below";
      const double gap = distance(beside->nearest);
      return {{{"side", side}, {"nearest", beside->nearest}, {"gap_about", gap}},
              fmt::format("all of {0} is {1} {2}; vertex {3} of {0} is nearest to it, about {4} away", letter(), side,
                          other_letter(), beside->nearest, about(gap))};
    }
    const auto& [below, above] = std::get<solid::AcrossPlane>(answer_.evidence);
    const Point3 point = nearest(common_point(body_.mesh.hull, body_.pose, plane_, answer_));
    return {{{"point", to_json(point)}, {"below", below}, {"above", above}},
            fmt::format("a common point at about {}, ", about(point)) +
                (below == above ? fmt::format("vertex {} of {}", below, letter())
                                : fmt::format("between vertex {} of {}, not above {},\nand vertex {}, not below it",
                                              below, letter(), other_letter(), above))};
  }

  Named<PlaneMethod> method_;
  const PlacedBody& body_;
  const Plane& plane_;
  const std::optional<solid::FlatBody>& in_file_;
  PolyhedronPlane answer_;
};

}  // namespace

Report run_plane_pair(const PairCall& call, const PlacedBody& body, const PlacedFlat& plane, bool body_is_a,
                      const PairFiles& files) {
  return answer(PlanePair(call, body, plane, body_is_a, files), files.talk);
}

std::string plane_method_names() { return method_names(plane_methods); }

}  // namespace sunder::ask
