#include <sunder/base/names.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/predicate/point/plane_side.h>
#include <sunder/predicate/point/plane_sides.h>
#include <sunder/solid/represent/half_edges.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/extreme_vertex.h>
#include <sunder/solid/search/support.h>
#include <sunder/solid/section/polyhedron_plane_answer.h>
#include <sunder/solid/section/polyhedron_plane_section.h>
#include <sunder/solid/section/section_start.h>
#include <sunder/solid/section/section_walk.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunder::solid {

namespace {

// Everything that the sections by parallel planes have in common.
class Sections {
 public:
  Sections(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane)
      : body_(body),
        placed_(body, pose),
        normal_(plane.normal),
        direction_(direction_of(plane.normal)),
        sides_(plane.normal, plane.point, placed_.pose, placed_.tame, placed_.graph.sizes.greatest),
        pulled_(pulled_normal<double>(placed_, plane)),
        is_reflected_(determinant_sign(placed_.pose) == Sign::negative) {
    high_.vertex = support(body, pulled_, made_ready_);
    low_.vertex = support(body, {-pulled_.x, -pulled_.y, -pulled_.z}, made_ready_);
  }

  void section_at(double offset, PlaneSection& section) {
    sides_.set_offset(offset);
    section.corners.clear();
    section.side = Sign::zero;
    section.nearest = 0;
    section.cost = Cost{.probes = std::exchange(made_ready_, 0), .proposals = 1};
    section_ = &section;
    tally_ = {};
    find();
    section.kind = section.side != Sign::zero ? SectionKind::nothing : kind_of(section.corners.size());
    conclude(section, tally_.exact);
  }

 private:
  // A vertex as far as can be along the normal, or against it.
  struct Furthest {
    std::uint32_t vertex = 0;
    bool is_sure = false;  // that none is further
  };

  static SectionKind kind_of(std::size_t corners) {
    return corners == 1 ? SectionKind::point : corners == 2 ? SectionKind::segment : SectionKind::polygon;
  }

  Sign side(std::uint32_t v) {
    ++section_->cost.probes;
    return sides_(placed_.graph.vertices[v], &tally_);
  }

  // Its side; where it is not beyond the plane, it becomes one that is furthest.
  Sign side_of_furthest(Furthest& furthest, End end) {
    const Sign beyond = static_cast<Sign>(end);
    const Sign first = side(furthest.vertex);
    if (first == beyond || furthest.is_sure) return first;
    Along along(direction_, placed_.pose, placed_.tame);
    furthest = {extreme_vertex_from(placed_, along, end, furthest.vertex, section_->cost, tally_), true};
    return side(furthest.vertex);
  }

  void find() {
    const Sign of_high = side_of_furthest(high_, End::greatest);
    if (of_high == Sign::negative) return miss(Sign::negative, high_.vertex);
    const Sign of_low = side_of_furthest(low_, End::least);
    if (of_low == Sign::positive) return miss(Sign::positive, low_.vertex);
    if (of_high == Sign::zero) {
      touch(high_.vertex, End::greatest);
    } else if (of_low == Sign::zero) {
      touch(low_.vertex, End::least);
    } else if (body_.dimension() == 1) {
      section_->corners.push_back({high_.vertex, low_.vertex});
    } else {
      cross();
    }
    make_least_first();
  }

  void miss(Sign side, std::uint32_t nearest) {
    section_->side = side;
    section_->nearest = nearest;
  }

  // S3.
  void make_least_first() {
    std::vector<SectionCorner>& corners = section_->corners;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }

  // No vertex is beyond the plane, and this one is on it.
  void touch(std::uint32_t v, End end) {
    if (body_.dimension() < 2) {
      for (std::uint32_t w = 0; w < body_.vertices().size(); ++w) {
        if (side(w) == Sign::zero) add_vertex(w);
      }
      return;
    }
    const HalfEdges& edges = represent::of<HalfEdges>(body_);
    const std::vector<std::uint32_t> in_plane = edges_in_plane(v, end);
    if (in_plane.empty()) {
      add_vertex(v);
    } else if (in_plane.size() == 1) {
      add_vertex(v);
      add_vertex(edges.tip(in_plane[0]));
    } else {
      const std::uint32_t e = edges.turned(in_plane[0], 1) == in_plane[1] ? in_plane[0] : in_plane[1];
      add_facet(body_.dimension() == 2 ? 0 : edges.facet[e]);
    }
  }

  void add_vertex(std::uint32_t v) { section_->corners.push_back({v, v}); }

  void add_facet(std::uint32_t f) {
    const auto facet = body_.facet(f);
    const Sign turn = turn_seen_from(normal_, placed_[facet[0]], placed_[facet[1]], placed_[facet[2]], &tally_);
    for (const std::uint32_t v : facet) add_vertex(v);
    if (turn == Sign::negative) std::reverse(section_->corners.begin(), section_->corners.end());
  }

  // The half-edges in the plane that start at v, at most two. At a vertex of many, the normal is within a cone of
  // normals of facets, N_k between half-edges k and k + 1: fans from N_0 tell in which one, by halving, and only the
  // half-edges at its sides can be in the plane.
  std::vector<std::uint32_t> edges_in_plane(std::uint32_t v, End end) {
    const HalfEdges& edges = represent::of<HalfEdges>(body_);
    const std::uint32_t n = edges.degree(v), first = edges.out[edges.begin[v]];
    std::vector<std::uint32_t> candidates;
    if (n <= most_around) {
      for (std::uint32_t k = 0; k < n; ++k) candidates.push_back(k);
    } else {
      Along along(direction_, placed_.pose, placed_.tame);
      const auto tip = [&](std::uint32_t k) -> const Point3& {
        return placed_.graph.vertices[edges.tip(edges.turned(first, k % n))];
      };
      std::uint32_t low = 1, high = n;
      while (high - low > 1) {
        const std::uint32_t k = low + (high - low) / 2;
        ++section_->cost.probes;
        const Sign turn =
            along.turn_about_normal(tip(0), tip(1), placed_.graph.vertices[v], tip(k), tip(k + 1), &tally_);
        ((end == End::greatest ? turn : -turn) == Sign::negative ? high : low) = k;
      }
      candidates = {0, 1, 2, low - 1, low, (low + 1) % n};
      std::sort(candidates.begin(), candidates.end());
      candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    }
    std::vector<std::uint32_t> found;
    for (const std::uint32_t k : candidates) {
      const std::uint32_t e = edges.turned(first, k);
      if (side(edges.tip(e)) == Sign::zero) found.push_back(e);
    }
    return found;
  }

  // Vertices are strictly on both sides.
  void cross() {
    SectionWalk walk(placed_.graph.vertices, represent::of<HalfEdges>(body_), sides_, is_reflected_, section_->cost,
                     tally_);
    Along along(direction_, placed_.pose, placed_.tame);
    SectionStart start(body_, pulled_, along, placed_.turns_tame(), is_reflected_, walk);
    const std::uint32_t above = is_reflected_ ? low_.vertex : high_.vertex;
    const std::uint32_t below = is_reflected_ ? high_.vertex : low_.vertex;
    const SectionStart::Found found = start.find(above, below);
    if (found.up == SectionStart::none) {
      walk.go_from_edge(found.down, section_->corners);
    } else {
      walk.go_from_vertex(found.down, found.up, section_->corners);
    }
  }

  const ConvexPolyhedron& body_;
  Placed placed_;
  Point3 normal_;
  WorldDirection direction_;
  PlaneSides sides_;
  Point3 pulled_;
  bool is_reflected_;
  Furthest high_, low_;

  std::uint64_t made_ready_ = 0;  // probes that no section has been charged for
  PlaneSection* section_ = nullptr;
  StageTally tally_;
};

}  // namespace

std::string_view name_of(SectionKind kind) {
  return name_in<SectionKind::polygon>({"nothing", "point", "segment", "polygon"}, kind);
}

PlaneSection polyhedron_plane_section(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  PlaneSection section;
  Sections(body, pose, plane).section_at(plane.offset, section);
  return section;
}

void polyhedron_plane_sections(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane,
                               std::span<const double> offsets, const SectionVisitor& visit) {
  Sections sections(body, pose, plane);
  PlaneSection section;
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    if (!std::isfinite(offsets[k])) {
      throw Error(ErrorCode::bad_value, "it is not finite; give a finite number", "offset " + std::to_string(k));
    }
    sections.section_at(offsets[k], section);
    visit(k, section);
  }
}

}  // namespace sunder::solid
