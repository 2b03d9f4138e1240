#include <sunder/base/lanes.h>
#include <sunder/certificate/direction.h>
#include <sunder/predicate/common_point.h>
#include <sunder/solid/pair/evidence.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace sunder::solid {

namespace {

// Weights below this part of the largest are taken for zero where a proposal is made from what a search left.
constexpr double negligible = 0x1p-40;

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

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

// The different vertices of one body in a simplex.
struct Support {
  std::array<std::uint32_t, 4> vertex{};
  std::size_t count = 0;

  // Returns where the vertex stands.
  std::size_t add(std::uint32_t v) {
    for (std::size_t i = 0; i < count; ++i) {
      if (vertex[i] == v) return i;
    }
    vertex[count] = v;
    return count++;
  }
};

// The weights, up to a factor, of the point of the simplex that is nearest to the origin. The simplex is the least face
// that holds it (closest_simplex.h).
std::array<double, 4> weights_of_nearest(const DifferenceSimplex& s) {
  const Point3 &a = s.vertex[0].at, &b = s.vertex[1].at, &c = s.vertex[2].at;
  switch (s.count) {
    case 1: return {1};
    case 2: {
      const Point3 e = minus(b, a);
      return {dot(b, e), -dot(a, e)};
    }
    case 3: {
      const Point3 u = minus(b, a), v = minus(c, a);
      const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ua = -dot(u, a), va = -dot(v, a);
      const double wb = vv * ua - uv * va, wc = uu * va - uv * ua;
      return {(uu * vv - uv * uv) - wb - wc, wb, wc};
    }
    default: return weights_of_origin(s);
  }
}

// Of the vertices that make a tetrahedron which holds the origin, five that are enough (Caratheodory's theorem), in
// floating point. This is what a search for deep bodies ends with; so there are no branches, and no stores of single
// numbers into rows that are read whole.
//
// The four difference vertices w_k = a_k - b_k have weights m_k > 0 with sum m_k w_k = 0. Moving weight from a_0 to a_k
// is made good by weight on the w_m: with sum y_m w_m = a_0 - a_k and sum y_m = 0, the weights may move along
//   1 at a_k, -1 at a_0, and y_m at both a_m and b_m
// until the first one vanishes. The three moves, k = 1, 2, 3, are independent; after each, the others are combined with
// it so that they leave alone what has vanished. Five columns without a dependency are left, so no vertex twice.
class TetrahedronReduction {
 public:
  // The weights: of the origin in the tetrahedron, up to a factor, all positive.
  TetrahedronReduction(const Placed& a, const DifferenceSimplex& tetrahedron, const std::array<double, 4>& weights)
      : vertex_(tetrahedron.vertex) {
    const Point3 w0 = vertex_[0].at, a0 = a.turned(vertex_[0].a, tetrahedron.scale);
    const Point3 e1 = minus(vertex_[1].at, w0), e2 = minus(vertex_[2].at, w0), e3 = minus(vertex_[3].at, w0);
    const Point3 n1 = cross(e2, e3), n2 = cross(e3, e1), n3 = cross(e1, e2);
    const double scale = 1 / dot(e1, n1);
    const auto move = [&](std::size_t k, double to1, double to2, double to3) {
      const Point3 back = minus(a0, a.turned(vertex_[k].a, tetrahedron.scale));
      const double y1 = dot(n1, back) * scale, y2 = dot(n2, back) * scale, y3 = dot(n3, back) * scale;
      const double y0 = -(y1 + y2 + y3);
      return Row{Lanes{y0 - 1, y1 + to1}, Lanes{y2 + to2, y3 + to3}, Lanes{y0, y1}, Lanes{y2, y3}};
    };
    moves_ = {move(1, 1, 0, 0), move(2, 0, 1, 0), move(3, 0, 0, 1)};
    const Lanes w01{weights[0], weights[1]}, w23{weights[2], weights[3]};
    weight_ = {w01, w23, w01, w23};
  }

  // Names the five vertices. False where rounding has left no move, or vertices of one body only.
  bool reduce(PairCertificate& certificate) {
    std::uint32_t held = 255;  // a bit for each place
    for (std::size_t k = 0; k < 3; ++k) {
      const Row& move = moves_[k];
      Row speed;
      for (std::size_t i = 0; i < 4; ++i) speed[i] = move[i] / weight_[i];
      const std::uint32_t leaver = first_of_greatest(speed.data(), 4);
      if (!(at(speed, leaver) > 0)) return false;
      held &= ~(1u << leaver);
      const Row& others = others_than[leaver];
      const double step = 1 / at(speed, leaver), part = 1 / at(move, leaver);
      for (std::size_t next = k + 1; next < 3; ++next) {
        Row& changed = moves_[next];
        const double factor = at(changed, leaver) * part;
        for (std::size_t i = 0; i < 4; ++i) changed[i] = (changed[i] - factor * move[i]) * others[i];
      }
      // What has vanished counts as 1 from here on; no move touches it.
      for (std::size_t i = 0; i < 4; ++i) weight_[i] = (weight_[i] - step * move[i]) * others[i] + (1 - others[i]);
    }
    certificate.verdict = Verdict::meet;
    std::uint32_t of_a = 0;
    for (std::uint32_t& name : certificate.vertices) {
      const std::size_t place = static_cast<std::size_t>(std::countr_zero(held)) % places;
      name = place < 4 ? vertex_[place].a : vertex_[place - 4].b;
      of_a += std::uint32_t{place < 4};
      held &= held - 1;
    }
    certificate.count_a = static_cast<std::uint8_t>(of_a);
    certificate.count_b = static_cast<std::uint8_t>(5 - of_a);
    return certificate.count_a > 0 && certificate.count_b > 0;
  }

 private:
  static constexpr std::size_t places = 8;  // a_0 to a_3, then b_0 to b_3
  using Row = std::array<Lanes, places / 2>;

  static double at(const Row& row, std::uint32_t place) { return row[place / 2][place % 2]; }

  // 0 in one place, 1 elsewhere.
  static constexpr std::array<Row, places> others_than{
      Row{Lanes{0, 1}, Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 1}}, Row{Lanes{1, 0}, Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 1}},
      Row{Lanes{1, 1}, Lanes{0, 1}, Lanes{1, 1}, Lanes{1, 1}}, Row{Lanes{1, 1}, Lanes{1, 0}, Lanes{1, 1}, Lanes{1, 1}},
      Row{Lanes{1, 1}, Lanes{1, 1}, Lanes{0, 1}, Lanes{1, 1}}, Row{Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 0}, Lanes{1, 1}},
      Row{Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 1}, Lanes{0, 1}}, Row{Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 1}, Lanes{1, 0}},
  };

  const std::array<DifferenceVertex, 4>& vertex_;
  Row weight_;
  std::array<Row, 3> moves_;
};

// The vertices of both bodies that a simplex is made of, with weights: solutions of
//   sum over A of w_i a_i = sum over B of w_j b_j,  sum over A of w_i = sum over B of w_j.
// Drops vertices, keeping a solution with weights that are not negative, until what is left has only one (up to a
// factor): Caratheodory's theorem, in floating point. The first vertices of A and of B serve as origins; what remains
// are three equations in the edges from them. Places 0 to 3 are A's, 4 to 7 B's, some of them empty: loops over all
// eight have no branches.
class Reduction {
 public:
  static constexpr std::size_t places = 8;
  static constexpr std::size_t first_of_b = 4;
  using Row = std::array<double, places>;

  Reduction(const Placed& a, const Placed& b, const DifferenceSimplex& simplex, const std::array<double, 4>& weights) {
    weight_.fill(0);
    for (Row& row : edges_) row.fill(0);
    const DifferenceVertex* first = nullptr;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
      if (weights[i] == 0) continue;
      const DifferenceVertex& v = simplex.vertex[i];
      if (first == nullptr) first = &v;
      const double scale = simplex.scale;
      add(of_a_, 0, v.a, a.turned(first->a, scale), a.turned(v.a, scale), weights[i]);
      add(of_b_, first_of_b, v.b, b.turned(v.b, scale), b.turned(first->b, scale), weights[i]);
    }
  }

  void reduce() {
    eliminate();
    // Each edge without a pivot is a combination of those with one: a dependency, along which weights can move.
    for (std::size_t j = 0; j < places; ++j) {
      if (!is_free_[j]) continue;
      Row dependency{};
      dependency[j] = -1;
      for (std::size_t i = 0; i < 3; ++i) {
        if (pivot_[i] != none) dependency[pivot_[i]] = edges_[i][j];
      }
      for (std::size_t i = 1; i < first_of_b; ++i) dependency[0] -= dependency[i];
      for (std::size_t i = first_of_b + 1; i < places; ++i) dependency[first_of_b] -= dependency[i];
      for (std::size_t k = 0; k < eliminated_; ++k) {
        // Keeps the weights that vanished before at zero.
        const double factor = dependency[leaver_[k]] / dependency_[k][leaver_[k]];
        for (std::size_t i = 0; i < places; ++i) dependency[i] -= factor * dependency_[k][i];
        dependency[leaver_[k]] = 0;
      }
      shift_weights(dependency);
    }
  }

  // Drops vertices whose weight is next to nothing: what touching and shared vertices leave behind.
  void drop_negligible() {
    const double least = *std::max_element(weight_.begin(), weight_.end()) * negligible;
    for (double& w : weight_) w = w > least ? w : 0;
  }

  // The vertices with positive weights. False where they cannot be a certificate.
  bool write(PairCertificate& certificate) const {
    std::size_t n = 0;
    certificate.verdict = Verdict::meet;
    certificate.count_a = certificate.count_b = 0;
    for (std::size_t i = 0; i < places; ++i) {
      if (!(weight_[i] > 0)) continue;
      if (n == 5) return false;
      certificate.vertices[n++] = i < first_of_b ? of_a_.vertex[i] : of_b_.vertex[i - first_of_b];
      ++(i < first_of_b ? certificate.count_a : certificate.count_b);
    }
    return certificate.count_a > 0 && certificate.count_b > 0;
  }

 private:
  static constexpr std::size_t none = places;

  // Adds a vertex, with the edge from `from` to `to`, or the weight of one that is there already.
  void add(Support& support, std::size_t first_place, std::uint32_t vertex, const Point3& from, const Point3& to,
           double weight) {
    const std::size_t count = support.count;
    const std::size_t place = first_place + support.add(vertex);
    weight_[place] += weight;
    if (support.count == count || count == 0) return;
    edges_[0][place] = to.x - from.x;
    edges_[1][place] = to.y - from.y;
    edges_[2][place] = to.z - from.z;
    is_free_[place] = true;
  }

  // Gauss-Jordan elimination, a pivot in each row: its largest entry. One that is next to nothing is taken for none:
  // the outcome is a proposal.
  void eliminate() {
    double largest = 0;
    for (const Row& row : edges_) {
      for (const double x : row) largest = std::max(largest, std::fabs(x));
    }
    for (std::size_t r = 0; r < 3; ++r) {
      double size = largest * 0x1p-36;
      for (std::size_t j = 0; j < places; ++j) {
        if (is_free_[j] && std::fabs(edges_[r][j]) > size) {
          size = std::fabs(edges_[r][j]);
          pivot_[r] = j;
        }
      }
      if (pivot_[r] == none) continue;
      is_free_[pivot_[r]] = false;
      const double scale = 1 / edges_[r][pivot_[r]];
      for (double& x : edges_[r]) x *= scale;
      for (std::size_t i = 0; i < 3; ++i) {
        if (i == r) continue;
        const double factor = edges_[i][pivot_[r]];
        for (std::size_t j = 0; j < places; ++j) edges_[i][j] -= factor * edges_[r][j];
      }
    }
  }

  // Moves the weights along the dependency until the first one vanishes.
  void shift_weights(const Row& dependency) {
    std::size_t leaving = none;
    double step = 0;
    for (std::size_t i = 0; i < places; ++i) {
      if (!(dependency[i] > 0)) continue;
      const double ratio = weight_[i] / dependency[i];
      if (leaving == none || ratio < step) {
        step = ratio;
        leaving = i;
      }
    }
    if (leaving == none) return;
    for (std::size_t i = 0; i < places; ++i) weight_[i] -= step * dependency[i];
    weight_[leaving] = 0;
    dependency_[eliminated_] = dependency;
    leaver_[eliminated_++] = leaving;
  }

  Support of_a_, of_b_;
  Row weight_;
  std::array<Row, 3> edges_;  // by coordinate; those of B negated
  std::array<bool, places> is_free_{};
  std::array<std::size_t, 3> pivot_{none, none, none};
  std::array<Row, 6> dependency_;      // along which weights vanished: the first eliminated_
  std::array<std::size_t, 6> leaver_;  // and which weight did
  std::size_t eliminated_ = 0;
};

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
    const double least = *std::max_element(weights.begin(), weights.end()) * negligible;
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
  if (simplex.count == 1 || dot(nearest->at, nearest->at) < largest * negligible * negligible) {
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

// check_meet with given weights, either as they are or with negligible ones taken for zero.
bool meet_with_weights(const Placed& a, const Placed& b, const DifferenceSimplex& simplex,
                       const std::array<double, 4>& weights, bool drop, PairCertificate& certificate,
                       StageTally& tally) {
  Reduction reduction(a, b, simplex, weights);
  reduction.reduce();
  if (drop) reduction.drop_negligible();
  return reduction.write(certificate) && named_vertices_meet(a, b, certificate, tally);
}

}  // namespace

bool check_meet(const Placed& a, const Placed& b, const DifferenceSimplex& simplex, PairCertificate& certificate,
                StageTally& tally) {
  if (simplex.count == 0) return false;
  const std::array<double, 4> weights = weights_of_nearest(simplex);
  if (simplex.count == 4 && *std::min_element(weights.begin(), weights.end()) > 0) {
    if (TetrahedronReduction(a, simplex, weights).reduce(certificate) &&
        named_vertices_meet(a, b, certificate, tally)) {
      return true;
    }
  }
  if (simplex.count == 4 && meet_with_weights(a, b, simplex, weights, false, certificate, tally)) return true;
  std::array<double, 4> without_negligible = weights;
  const double largest = *std::max_element(weights.begin(), weights.end());
  for (double& w : without_negligible) w = w > largest * negligible ? w : 0;
  if (meet_with_weights(a, b, simplex, without_negligible, true, certificate, tally)) return true;
  return simplex.count < 4 && meet_with_weights(a, b, simplex, weights, false, certificate, tally);
}

}  // namespace sunder::solid
