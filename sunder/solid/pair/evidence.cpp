#include <sunder/certificate/direction.h>
#include <sunder/predicate/common_point.h>
#include <sunder/solid/pair/caratheodory.h>
#include <sunder/solid/pair/evidence.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace sunder::solid {

namespace {

PlacedVertices vertices_of(const Placed& body) { return {body.graph.vertices, body.pose, body.tame}; }

// The exact part of both apart checks: the extreme vertices, then strictness.
bool parts(const Placed& a, const Placed& b, const WorldDirection& direction, std::uint32_t near_a,
           std::uint32_t near_b, PairCertificate& certificate, StageTally& tally) {
  // The strict comparison first: it costs least and fails most.
  if (compare_along(direction, a[near_a], b[near_b], &tally) != Sign::positive) return false;
  Along along_a(direction, a.pose, a.tame), along_b(direction, b.pose, b.tame);
  const std::uint32_t last_a = extreme_vertex_from(a, along_a, End::greatest, near_a, tally);
  const std::uint32_t last_b = extreme_vertex_from(b, along_b, End::least, near_b, tally);
  if (last_a != near_a || last_b != near_b) {
    if (compare_along(direction, a[last_a], b[last_b], &tally) != Sign::positive) return false;
  }
  certificate.verdict = Verdict::apart;
  certificate.extreme_a = last_a;
  certificate.extreme_b = last_b;
  return true;
}

}  // namespace

bool check_apart(const Placed& a, const Placed& b, const Point3& direction, std::uint32_t near_a, std::uint32_t near_b,
                 PairCertificate& certificate, StageTally& tally) {
  if (!parts(a, b, WorldDirection(direction), near_a, near_b, certificate, tally)) return false;
  certificate.direction.kind = Direction::Kind::given;
  certificate.direction.given = direction;
  return true;
}

namespace {

// Does the direction named by these features part the bodies? `towards` tells the sense.
bool parts_along_features(const Placed& a, const Placed& b, Direction::Kind kind,
                          const std::array<std::uint32_t, 4>& index, const Point3& towards, std::uint32_t near_a,
                          std::uint32_t near_b, PairCertificate& certificate, StageTally& tally) {
  Direction& d = certificate.direction;
  d.kind = kind;
  d.index = index;
  d.reversed = false;
  const Vector3<Interval> n = world_direction(d, vertices_of(a), vertices_of(b)).enclosure();
  d.reversed = dot({n.x.low, n.y.low, n.z.low}, towards) < 0;
  return parts(a, b, world_direction(d, vertices_of(a), vertices_of(b)), near_a, near_b, certificate, tally);
}

// Two vertices next to each other: if a plane parts the bodies there, one along a facet at either vertex does, because
// these normals span the cone of all directions along which the vertex is extreme. Tries the facet whose normal goes
// furthest along the exact difference of the vertices.
bool parts_along_facet_at(const Placed& a, const Placed& b, const DifferenceVertex& w, PairCertificate& certificate,
                          StageTally& tally) {
  const Vector3<Interval> exact = difference_direction(a[w.a], b[w.b]).enclosure();
  const Point3 difference{exact.x.low, exact.y.low, exact.z.low};
  double best = 0;
  Point3 towards;
  Direction::Kind kind = Direction::Kind::given;
  std::array<std::uint32_t, 4> index{};
  for (const bool of_a : {true, false}) {
    const Placed& body = of_a ? a : b;
    const std::uint32_t v = of_a ? w.a : w.b;
    const VertexBlock block = body.graph.block(body.graph.place[v]);
    const Point3 p = block.at();
    const auto& m = body.pose.linear;
    const auto edge = [&](const Point3& to) {
      const Point3 e{to.x - p.x, to.y - p.y, to.z - p.z};
      return Point3{m[0] * e.x + m[1] * e.y + m[2] * e.z, m[3] * e.x + m[4] * e.y + m[5] * e.z,
                    m[6] * e.x + m[7] * e.y + m[8] * e.z};
    };
    const Point3 inward = edge(body.graph.middle);
    const std::uint32_t count = block.count();
    if (count < 3) continue;
    for (std::uint32_t j = 0; j < count; ++j) {
      const std::uint32_t next = j + 1 < count ? j + 1 : 0;
      Point3 n = cross(edge({block.x()[j], block.y()[j], block.z()[j]}),
                       edge({block.x()[next], block.y()[next], block.z()[next]}));
      if ((dot(n, inward) < 0) != of_a) n = {-n.x, -n.y, -n.z};  // out of A, into B
      const double along = dot(n, difference) / std::sqrt(dot(n, n));
      if (!(along > best)) continue;
      best = along;
      towards = n;
      kind = of_a ? Direction::Kind::normal_of_a : Direction::Kind::normal_of_b;
      const auto number = [&](std::uint32_t k) { return body.graph.block(block.place(k)).vertex(); };
      index = {v, number(j), number(next), 0};
    }
  }
  return best > 0 && parts_along_features(a, b, kind, index, towards, w.a, w.b, certificate, tally);
}

}  // namespace

bool check_apart_by_features(const Placed& a, const Placed& b, const DifferenceSimplex& given, const Point3& towards,
                             PairCertificate& certificate, StageTally& tally) {
  // A tetrahedron with the origin next to a face counts as that face.
  DifferenceSimplex simplex = given;
  if (given.count == 4) {
    const std::array<double, 4> weights = weights_of_origin(given);
    const double least = *std::max_element(weights.begin(), weights.end()) * negligible<double>;
    simplex.count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (weights[i] > least) simplex.vertex[static_cast<std::size_t>(simplex.count++)] = given.vertex[i];
    }
    if (simplex.count == 4) return false;
  }
  Support of_a, of_b;
  const DifferenceVertex* nearest = nullptr;
  double largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
    const DifferenceVertex& w = simplex.vertex[i];
    of_a.add(w.a);
    of_b.add(w.b);
    largest = std::max(largest, dot(w.at, w.at));
    if (nearest == nullptr || dot(w.at, w.at) < dot(nearest->at, nearest->at)) nearest = &w;
  }
  if (nearest == nullptr) return false;
  if (simplex.count == 1 || dot(nearest->at, nearest->at) < largest * (negligible<double> * negligible<double>)) {
    if (parts_along_facet_at(a, b, *nearest, certificate, tally)) return true;
  }
  const auto attempt = [&](Direction::Kind kind, const std::array<std::uint32_t, 4>& index) {
    return parts_along_features(a, b, kind, index, towards, of_a.vertex[0], of_b.vertex[0], certificate, tally);
  };
  const auto& p = of_a.vertex;
  const auto& q = of_b.vertex;
  if (of_a.count == 3 && attempt(Direction::Kind::normal_of_a, {p[0], p[1], p[2]})) return true;
  if (of_b.count == 3 && attempt(Direction::Kind::normal_of_b, {q[0], q[1], q[2]})) return true;
  if (of_a.count == 2 && of_b.count == 2 && attempt(Direction::Kind::edge_cross_edge, {p[0], p[1], q[0], q[1]}))
    return true;
  return of_a.count == 1 && of_b.count == 1 && attempt(Direction::Kind::difference, {p[0], q[0]});
}

namespace {

// Do the vertices that a certificate names have a common point?
bool named_vertices_meet(const Placed& a, const Placed& b, const PairCertificate& certificate, StageTally& tally) {
  std::array<Posed, 5> points;
  const std::size_t k = std::size_t{certificate.count_a} + certificate.count_b;
  for (std::size_t i = 0; i < k; ++i) {
    points[i] = i < certificate.count_a ? a[certificate.vertices[i]] : b[certificate.vertices[i]];
  }
  return have_common_point({points.data(), certificate.count_a},
                           {points.data() + certificate.count_a, k - certificate.count_a}, &tally);
}

}  // namespace

template <class Real>
bool check_meet(const Placed& a, const Placed& b, const DifferenceSimplexOf<Real>& simplex,
                PairCertificate& certificate, StageTally& tally) {
  if (simplex.count == 0) return false;
  const std::array<Real, 4> weights = weights_of_nearest(simplex);
  if constexpr (std::is_same_v<Real, double>) {
    if (simplex.count == 4 && *std::min_element(weights.begin(), weights.end()) > 0 &&
        name_five_of_tetrahedron(a, simplex, weights, certificate) && named_vertices_meet(a, b, certificate, tally)) {
      return true;
    }
  }
  // A tetrahedron mostly holds the origin properly; in a smaller simplex something vanishes.
  for (const bool drop_negligible : {simplex.count < 4, simplex.count == 4}) {
    if (name_at_most_five(a, b, simplex, weights, drop_negligible, certificate) &&
        named_vertices_meet(a, b, certificate, tally)) {
      return true;
    }
  }
  return false;
}

template bool check_meet(const Placed&, const Placed&, const DifferenceSimplexOf<double>&, PairCertificate&,
                         StageTally&);
template bool check_meet(const Placed&, const Placed&, const DifferenceSimplexOf<DoubleDouble>&, PairCertificate&,
                         StageTally&);

bool check_apart_perpendicular(const Placed& a, const Placed& b, const DifferenceSimplexOf<DoubleDouble>& simplex,
                               std::uint32_t near_a, std::uint32_t near_b, PairCertificate& certificate,
                               StageTally& tally) {
  using Vector = Vector3<Dyadic>;
  const auto corner = [&](std::size_t i) {
    const DifferenceVertexOf<DoubleDouble>& w = simplex.vertex[i];
    return lift<ExactStage>(a[w.a]) - lift<ExactStage>(b[w.b]);
  };
  if (simplex.count < 1 || simplex.count > 3) return false;
  const Vector w0 = corner(0);
  Vector from_origin = w0;  // perpendicular to the simplex, on its side of the origin
  if (simplex.count == 2) {
    const Vector e = corner(1) - w0;
    from_origin = cross(cross(e, w0), e);
  } else if (simplex.count == 3) {
    const Vector n = cross(corner(1) - w0, corner(2) - w0);
    from_origin = dot(n, w0).sign() == Sign::negative ? Vector{-n.x, -n.y, -n.z} : n;
  }
  Vector d{-from_origin.x, -from_origin.y, -from_origin.z};
  if (!parts(a, b, WorldDirection(d), near_a, near_b, certificate, tally)) return false;
  certificate.direction.kind = Direction::Kind::exact;
  certificate.direction.numbers = std::make_shared<const std::array<Dyadic, 3>>(
      std::array<Dyadic, 3>{std::move(d.x), std::move(d.y), std::move(d.z)});
  return true;
}

}  // namespace sunder::solid
