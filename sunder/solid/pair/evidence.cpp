#include <sunder/certificate/direction.h>
#include <sunder/predicate/common_point.h>
#include <sunder/solid/pair/evidence.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace sunder::solid {

namespace {

// Weights below this part of the largest are taken for zero where a proposal is made from what a search left.
constexpr double negligible = 0x1p-40;

PlacedVertices vertices_of(const Placed& body) { return {body.graph.vertices, body.pose, body.tame}; }

// The exact part of both apart checks: the extreme vertices, then strictness.
bool parts(const Placed& a, const Placed& b, const WorldDirection& direction, std::uint32_t near_a, std::uint32_t near_b,
           PairCertificate& certificate, StageTally& tally) {
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

// The different vertices of one body in a simplex, with the sums of their weights.
struct Support {
  std::array<std::uint32_t, 4> vertex{};
  std::array<double, 4> weight{};
  int count = 0;

  void add(std::uint32_t v, double w) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (vertex[i] == v) {
        weight[i] += w;
        return;
      }
    }
    vertex[static_cast<std::size_t>(count)] = v;
    weight[static_cast<std::size_t>(count++)] = w;
  }
};

// The weights, up to a factor, of the point of the simplex that is nearest to the origin. The simplex is the least face
// that holds it (closest_simplex.h).
std::array<double, 4> weights_of_nearest(const DifferenceSimplex& s) {
  const Point3 &a = s.vertex[0].at, &b = s.vertex[1].at, &c = s.vertex[2].at;
  const auto minus = [](const Point3& p, const Point3& q) { return Point3{p.x - q.x, p.y - q.y, p.z - q.z}; };
  const auto dot = [](const Point3& p, const Point3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; };
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

// The vertices of both bodies that a simplex is made of, with weights: solutions of
//   sum over A of w_i a_i = sum over B of w_j b_j,  sum over A of w_i = sum over B of w_j.
// Drops vertices, keeping a solution with weights that are not negative, until what is left has only one (up to a
// factor): Caratheodory's theorem, in floating point. The first vertices of A and of B serve as origins; what remains
// are three equations in the edges from them.
class Reduction {
 public:
  void add(std::uint32_t vertex, bool of_a, const Posed& p, double weight) {
    const auto& m = p.pose->linear;
    const Point3& v = p.point;
    Member& member = member_[static_cast<std::size_t>(count_++)];
    member = {vertex, of_a, weight, {}};
    const double side = of_a ? 1 : -1;
    for (std::size_t i = 0; i < 3; ++i) member.edge[i] = side * (m[3 * i] * v.x + m[3 * i + 1] * v.y + m[3 * i + 2] * v.z);
    if (of_a) count_a_ = count_;
  }

  void reduce() {
    find_dependencies();
    for (std::size_t d = 0; d < static_cast<std::size_t>(dependencies_); ++d) {
      const std::size_t leaving = shift_weights(dependency_[d]);
      if (leaving == none) continue;
      dropped_[leaving] = true;
      for (std::size_t e = d + 1; e < static_cast<std::size_t>(dependencies_); ++e) {
        const double factor = dependency_[e][leaving] / dependency_[d][leaving];
        for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) dependency_[e][i] -= factor * dependency_[d][i];
        dependency_[e][leaving] = 0;
      }
    }
  }

  // Drops vertices whose weight is next to nothing: what touching and shared vertices leave behind.
  void drop_negligible() {
    double largest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) largest = std::max(largest, member_[i].weight);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
      dropped_[i] = dropped_[i] || !(member_[i].weight > largest * negligible);
    }
  }

  bool write(PairCertificate& certificate) const {
    std::array<std::uint32_t, 8> left{};
    std::size_t n = 0;
    certificate.verdict = Verdict::meet;
    certificate.count_a = certificate.count_b = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
      if (dropped_[i]) continue;
      left[n++] = member_[i].vertex;
      ++(member_[i].of_a ? certificate.count_a : certificate.count_b);
    }
    if (n > 5 || certificate.count_a == 0 || certificate.count_b == 0) return false;
    std::copy_n(left.begin(), 5, certificate.vertices.begin());
    return true;
  }

 private:
  static constexpr std::size_t none = 8;

  struct Member {
    std::uint32_t vertex = 0;
    bool of_a = false;
    double weight = 0;
    std::array<double, 3> edge{};  // the turned vertex; from find_dependencies on, less that of its body's first
  };

  // Gauss-Jordan elimination of the three equations with full pivoting: each edge without a pivot gives a dependency.
  // A pivot that is next to nothing is taken for none: the outcome is a proposal.
  void find_dependencies() {
    const std::size_t n = static_cast<std::size_t>(count_), first_b = static_cast<std::size_t>(count_a_);
    double largest = 0;
    for (std::size_t j = n; j-- > 0;) {
      const std::size_t first = j < first_b ? 0 : first_b;
      for (std::size_t i = 0; i < 3; ++i) {
        member_[j].edge[i] -= member_[first].edge[i];
        largest = std::max(largest, std::fabs(member_[j].edge[i]));
      }
    }
    std::array<std::size_t, 3> pivot_of_row{none, none, none};
    std::array<bool, 8> is_pivot{};
    is_pivot[0] = is_pivot[first_b] = true;  // the origins take no part
    for (std::size_t rank = 0; rank < 3; ++rank) {
      std::size_t row = 0, column = none;
      double best = largest * 0x1p-36;
      for (std::size_t j = 0; j < n; ++j) {
        if (is_pivot[j]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          if (pivot_of_row[i] == none && std::fabs(member_[j].edge[i]) > best) {
            best = std::fabs(member_[j].edge[i]);
            row = i;
            column = j;
          }
        }
      }
      if (column == none) break;
      pivot_of_row[row] = column;
      is_pivot[column] = true;
      const double scale = 1 / member_[column].edge[row];
      for (std::size_t j = 0; j < n; ++j) {
        if (is_pivot[j]) continue;
        const double factor = member_[j].edge[row] * scale;
        for (std::size_t i = 0; i < 3; ++i) member_[j].edge[i] -= factor * member_[column].edge[i];
        member_[j].edge[row] = factor;
      }
    }
    for (std::size_t j = 0; j < n; ++j) {
      if (is_pivot[j]) continue;
      std::array<double, 8>& d = dependency_[static_cast<std::size_t>(dependencies_++)];
      d.fill(0);
      d[j] = -1;
      for (std::size_t i = 0; i < 3; ++i) {
        if (pivot_of_row[i] != none) d[pivot_of_row[i]] = member_[j].edge[i];
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (i != 0 && i != first_b) d[i < first_b ? 0 : first_b] -= d[i];
      }
    }
  }

  // Moves the weights along the dependency until the first one vanishes; returns which.
  std::size_t shift_weights(const std::array<double, 8>& dependency) {
    std::size_t leaving = none;
    double step = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
      if (!(dependency[i] > 0)) continue;
      const double ratio = member_[i].weight / dependency[i];
      if (leaving == none || ratio < step) {
        step = ratio;
        leaving = i;
      }
    }
    if (leaving == none) return none;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) member_[i].weight -= step * dependency[i];
    member_[leaving].weight = 0;
    return leaving;
  }

  std::array<Member, 8> member_;
  int count_ = 0;
  int count_a_ = 0;
  std::array<bool, 8> dropped_{};
  std::array<std::array<double, 8>, 6> dependency_;  // the first dependencies_ of them
  int dependencies_ = 0;
};

}  // namespace

bool check_apart(const Placed& a, const Placed& b, const Point3& direction, std::uint32_t near_a, std::uint32_t near_b,
                 PairCertificate& certificate, StageTally& tally) {
  if (!parts(a, b, WorldDirection(direction), near_a, near_b, certificate, tally)) return false;
  certificate.direction.kind = Direction::Kind::given;
  certificate.direction.given = direction;
  return true;
}

bool check_apart_by_features(const Placed& a, const Placed& b, const DifferenceSimplex& simplex, const Point3& towards,
                             PairCertificate& certificate, StageTally& tally) {
  Support of_a, of_b;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
    of_a.add(simplex.vertex[i].a, 0);
    of_b.add(simplex.vertex[i].b, 0);
  }
  const auto attempt = [&](Direction::Kind kind, const std::array<std::uint32_t, 4>& index) {
    Direction& d = certificate.direction;
    d.kind = kind;
    d.index = index;
    d.reversed = false;
    const Vector3<Interval> n = world_direction(d, vertices_of(a), vertices_of(b)).enclosure();
    d.reversed = n.x.low * towards.x + n.y.low * towards.y + n.z.low * towards.z < 0;
    return parts(a, b, world_direction(d, vertices_of(a), vertices_of(b)), of_a.vertex[0], of_b.vertex[0], certificate,
                 tally);
  };
  const auto& p = of_a.vertex;
  const auto& q = of_b.vertex;
  if (of_a.count == 3 && attempt(Direction::Kind::normal_of_a, {p[0], p[1], p[2]})) return true;
  if (of_b.count == 3 && attempt(Direction::Kind::normal_of_b, {q[0], q[1], q[2]})) return true;
  if (of_a.count == 2 && of_b.count == 2 && attempt(Direction::Kind::edge_cross_edge, {p[0], p[1], q[0], q[1]})) return true;
  return of_a.count == 1 && of_b.count == 1 && attempt(Direction::Kind::difference, {p[0], q[0]});
}

namespace {

// check_meet with given weights, either as they are or with negligible ones taken for zero.
bool meet_with_weights(const Placed& a, const Placed& b, const DifferenceSimplex& simplex,
                       const std::array<double, 4>& weights, bool drop, PairCertificate& certificate,
                       StageTally& tally) {
  Support of_a, of_b;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
    if (drop && weights[i] == 0) continue;
    of_a.add(simplex.vertex[i].a, weights[i]);
    of_b.add(simplex.vertex[i].b, weights[i]);
  }
  Reduction reduction;
  for (std::size_t i = 0; i < static_cast<std::size_t>(of_a.count); ++i) {
    reduction.add(of_a.vertex[i], true, a[of_a.vertex[i]], of_a.weight[i]);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(of_b.count); ++i) {
    reduction.add(of_b.vertex[i], false, b[of_b.vertex[i]], of_b.weight[i]);
  }
  reduction.reduce();
  if (drop) reduction.drop_negligible();
  if (!reduction.write(certificate)) return false;
  std::array<Posed, 5> points{};
  const std::size_t k = std::size_t{certificate.count_a} + certificate.count_b;
  for (std::size_t i = 0; i < k; ++i) {
    points[i] = i < certificate.count_a ? a[certificate.vertices[i]] : b[certificate.vertices[i]];
  }
  return have_common_point({points.data(), certificate.count_a}, {points.data() + certificate.count_a, k - certificate.count_a},
                           &tally);
}

}  // namespace

bool check_meet(const Placed& a, const Placed& b, const DifferenceSimplex& simplex, PairCertificate& certificate,
                StageTally& tally) {
  if (simplex.count == 0) return false;
  const std::array<double, 4> weights = weights_of_nearest(simplex);
  if (simplex.count == 4 && meet_with_weights(a, b, simplex, weights, false, certificate, tally)) return true;
  std::array<double, 4> without_negligible = weights;
  const double largest = *std::max_element(weights.begin(), weights.end());
  for (double& w : without_negligible) w = w > largest * negligible ? w : 0;
  if (meet_with_weights(a, b, simplex, without_negligible, true, certificate, tally)) return true;
  return simplex.count < 4 && meet_with_weights(a, b, simplex, weights, false, certificate, tally);
}

}  // namespace sunder::solid
