#include <sunder/certificate/direction.h>
#include <sunder/predicate/point/common_point.h>
#include <sunder/solid/exact/exact_simplex.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <algorithm>
#include <cmath>

namespace sunder::solid {

namespace {

using Claim = Proposal::Claim;

// Does the proposal name vertices of the bodies that there are: as many, and to begin at?
bool names_vertices(const Placed& a, const Placed& b, const Proposal& p) {
  const std::size_t size_a = a.graph.vertices.size(), size_b = b.graph.vertices.size();
  const std::size_t count_a = p.count_a, count = count_a + p.count_b;
  if (count > p.vertices.size()) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (p.vertices[i] >= (i < count_a ? size_a : size_b)) return false;
  }
  return true;
}
bool begins_at_vertices(const Placed& a, const Placed& b, const Proposal& p) {
  return p.near_a < a.graph.vertices.size() && p.near_b < b.graph.vertices.size();
}

PlacedVertices vertices_of(const Placed& body) { return {body.graph.vertices, body.pose, body.tame}; }

class Disposal {
 public:
  Disposal(const Placed& a, const Placed& b, PairCertificate& certificate, Cost& cost, StageTally& tally)
      : a_(a), b_(b), certificate_(certificate), cost_(cost), tally_(tally) {}

  bool holds(const Proposal& p) {
    using enum Direction::Kind;
    if (p.claim == Claim::meet) {
      return p.count_a >= 1 && p.count_b >= 1 && p.count_a + p.count_b <= 5 && names_vertices(a_, b_, p) && meet(p);
    }
    if (!begins_at_vertices(a_, b_, p)) return false;
    const auto names = [&](std::size_t of_a, std::size_t of_b) {
      return p.count_a == of_a && p.count_b == of_b && names_vertices(a_, b_, p);
    };
    switch (p.claim) {
      case Claim::apart_along: return apart_along(p.direction, p.near_a, p.near_b);
      case Claim::apart_along_sum: return apart_along_sum(p);
      case Claim::apart_along_normal_of_a: return names(3, 0) && apart_along_features(normal_of_a, p);
      case Claim::apart_along_normal_of_b: return names(0, 3) && apart_along_features(normal_of_b, p);
      case Claim::apart_along_edge_x_edge: return names(2, 2) && apart_along_features(edge_cross_edge, p);
      case Claim::apart_along_difference: return names(1, 1) && apart_along_features(difference, p);
      case Claim::apart_along_perpendicular:
        return p.count_a >= 1 && names(p.count_a, p.count_a) && apart_along_perpendicular(p);
      case Claim::apart_at_vertices: return apart_at_vertices(p.near_a, p.near_b);
      case Claim::meet: break;
    }
    return false;
  }

 private:
  // What all claims that the bodies are apart come to: the extreme vertices, and that they are strictly apart. `found`
  // has the direction.
  bool parts(const WorldDirection& direction, std::uint32_t near_a, std::uint32_t near_b, Separation found) {
    // The strict comparison first: it costs least and fails most.
    if (compare_along(direction, a_[near_a], b_[near_b], &tally_) != Sign::positive) return false;
    Along along_a(direction, a_.pose, a_.tame), along_b(direction, b_.pose, b_.tame);
    const std::uint32_t last_a = extreme_vertex_from(a_, along_a, End::greatest, near_a, cost_, tally_);
    const std::uint32_t last_b = extreme_vertex_from(b_, along_b, End::least, near_b, cost_, tally_);
    if (last_a != near_a || last_b != near_b) {
      if (compare_along(direction, a_[last_a], b_[last_b], &tally_) != Sign::positive) return false;
    }
    found.extreme_a = last_a;
    found.extreme_b = last_b;
    certificate_ = std::move(found);
    return true;
  }

  bool apart_along(const Point3& direction, std::uint32_t near_a, std::uint32_t near_b) {
    if (!is_finite(direction)) return false;
    return parts(WorldDirection(direction), near_a, near_b, {{.given = direction}});
  }

  bool apart_along_sum(const Proposal& p) {
    if (!is_finite(p.direction) || !is_finite(p.rest)) return false;
    const auto sum = [](double x, double y) { return Dyadic(x) + Dyadic(y); };
    return parts_exactly({sum(p.direction.x, p.rest.x), sum(p.direction.y, p.rest.y), sum(p.direction.z, p.rest.z)}, p);
  }

  bool parts_exactly(const Vector3<Dyadic>& d, const Proposal& p) {
    ++tally_.exact;
    return parts(WorldDirection(d), p.near_a, p.near_b, {exact_direction({d.x, d.y, d.z})});
  }

  static bool is_finite(const Point3& d) { return std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z); }

  bool apart_along_features(Direction::Kind kind, const Proposal& p) {
    Separation found{{.kind = kind}};
    Direction& d = found.direction;
    std::copy_n(p.vertices.begin(), d.index.size(), d.index.begin());
    ++tally_.exact;
    const Vector3<Interval> n = world_direction(d, vertices_of(a_), vertices_of(b_)).enclosure();
    d.reversed = dot({n.x.low, n.y.low, n.z.low}, p.direction) < 0;
    return parts(world_direction(d, vertices_of(a_), vertices_of(b_)), p.near_a, p.near_b, found);
  }

  // Two vertices next to each other: if a plane parts the bodies there, one along a facet at either vertex does,
  // because these normals span the cone of all directions along which the vertex is extreme. Tries the facet whose
  // normal goes furthest along the exact difference of the vertices.
  bool apart_at_vertices(std::uint32_t of_a, std::uint32_t of_b) {
    ++tally_.exact;
    const Vector3<Interval> exact = difference_direction(a_[of_a], b_[of_b]).enclosure();
    const Point3 difference{exact.x.low, exact.y.low, exact.z.low};
    double best = 0;
    Proposal along{Claim::apart_along_normal_of_a, 3, 0, {}, of_a, of_b, {}};
    for (const bool is_a : {true, false}) {
      const Placed& body = is_a ? a_ : b_;
      const std::uint32_t v = is_a ? of_a : of_b;
      const VertexBlock block = body.graph.block(body.graph.place[v]);
      const Point3 p = block.at();
      const auto edge = [&](const Point3& to) { return body.turned(Point3{to.x - p.x, to.y - p.y, to.z - p.z}, 1); };
      const Point3 inward = edge(body.graph.middle);
      const std::uint32_t count = block.count();
      if (count < 3 || count > most_around) continue;
      cost_.probes += count;
      for (std::uint32_t j = 0; j < count; ++j) {
        const std::uint32_t next = j + 1 < count ? j + 1 : 0;
        Point3 n = cross(edge({block.x()[j], block.y()[j], block.z()[j]}),
                         edge({block.x()[next], block.y()[next], block.z()[next]}));
        if ((dot(n, inward) < 0) != is_a) n = {-n.x, -n.y, -n.z};  // out of A, into B
        const double reach = dot(n, difference) / std::sqrt(dot(n, n));
        if (!(reach > best)) continue;
        best = reach;
        along.direction = n;
        along.claim = is_a ? Claim::apart_along_normal_of_a : Claim::apart_along_normal_of_b;
        const auto number = [&](std::uint32_t k) { return body.graph.block(block.place(k)).vertex(); };
        along.vertices = {v, number(j), number(next)};
      }
    }
    const bool of_first = along.claim == Claim::apart_along_normal_of_a;
    return best > 0 &&
           apart_along_features(of_first ? Direction::Kind::normal_of_a : Direction::Kind::normal_of_b, along);
  }

  bool apart_along_perpendicular(const Proposal& p) {
    using Vector = Vector3<Dyadic>;
    const auto corner = [&](std::size_t i) {
      return coordinates<Dyadic>(a_[p.vertices[i]]) - coordinates<Dyadic>(b_[p.vertices[p.count_a + i]]);
    };
    const Vector w0 = corner(0);
    Vector from_origin = w0;  // perpendicular to the simplex, on its side of the origin
    if (p.count_a == 2) {
      const Vector e = corner(1) - w0;
      from_origin = cross(cross(e, w0), e);
    } else if (p.count_a == 3) {
      const Vector n = cross(corner(1) - w0, corner(2) - w0);
      from_origin = dot(n, w0).sign() == Sign::negative ? Vector{-n.x, -n.y, -n.z} : n;
    }
    return parts_exactly({-from_origin.x, -from_origin.y, -from_origin.z}, p);
  }

  bool meet(const Proposal& p) {
    std::array<Posed3, 5> points;
    const std::size_t count_a = p.count_a, count = count_a + p.count_b;
    for (std::size_t i = 0; i < count; ++i) points[i] = i < count_a ? a_[p.vertices[i]] : b_[p.vertices[i]];
    if (!have_common_point({points.data(), count_a}, {points.data() + count_a, count - count_a}, &tally_)) return false;
    CommonVertices& found = certificate_.emplace<CommonVertices>(CommonVertices{p.count_a, p.count_b});
    std::copy_n(p.vertices.begin(), found.vertices.size(), found.vertices.begin());
    return true;
  }

  const Placed& a_;
  const Placed& b_;
  PairCertificate& certificate_;
  Cost& cost_;
  StageTally& tally_;
};

}  // namespace

bool dispose(const Placed& a, const Placed& b, const Proposal& proposal, PairCertificate& certificate, Cost& cost,
             StageTally& tally) {
  return Disposal(a, b, certificate, cost, tally).holds(proposal);
}

void finish(const Placed& a, const Placed& b, std::uint32_t near_a, std::uint32_t near_b, PairCertificate& certificate,
            Cost& cost, StageTally& tally) {
  DifferenceSimplex hint;
  if (near_a < a.graph.vertices.size() && near_b < b.graph.vertices.size()) {
    hint.vertex[0].a = near_a, hint.vertex[0].b = near_b;
    hint.count = 1;
  }
  certificate = decide_by_exact_simplex(a, b, hint, cost, tally);
}

PairAnswer answer_by(const Placed& a, const Placed& b, FunctionRef<bool(const Holds&, Cost&)> propose) {
  PairAnswer answer;
  StageTally tally;
  std::uint32_t near_a = 0, near_b = 0;
  const auto holds = [&](const Proposal& proposal) {
    ++answer.cost.proposals;
    if (dispose(a, b, proposal, answer.evidence, answer.cost, tally)) return true;
    near_a = proposal.near_a, near_b = proposal.near_b;
    return false;
  };
  const bool held = propose(holds, answer.cost);
  if (!held) finish(a, b, near_a, near_b, answer.evidence, answer.cost, tally);
  conclude(answer, tally.exact, !held);
  return answer;
}

}  // namespace sunder::solid
