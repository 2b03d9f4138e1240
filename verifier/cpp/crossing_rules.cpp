// The rules about triangles of one mesh that cross, or do not: docs/claims.md, "Meshes".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/mesh_parts.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace sunder_verifier {
namespace {

// Requires what on_triangle does, by that rule. The corners whose weights are positive.
std::vector<std::size_t> corners_around(const std::size_t& triangle, const WeightList& weights, const MeshBody& mesh,
                                        const Numbers& point) {
  const MeshTriangle& corners = mesh.pieces->triangles[triangle];
  std::vector<std::size_t> around;
  for (std::size_t k = 0; k < weights.named.size(); ++k) {
    const std::size_t named = weights.named[k];
    require(std::find(corners.begin(), corners.end(), named) != corners.end(), "triangles_cross",
            "a weight is not of a corner of the triangle");
    if (weights.values[k].n > 0) around.push_back(named);
  }
  holds(weights, {}, mesh, point);
  return around;
}

void check_triangles_cross(const std::size_t& triangle, const WeightList& weights, const std::size_t& other,
                           const WeightList& other_weights, const MeshBody& mesh, const Numbers& point) {
  require(triangle != other, "triangles_cross", "the two triangles are one");
  require(!mesh.is_image(), "triangles_cross", mesh.quoted + " is mapped");
  const std::vector<std::size_t> one = corners_around(triangle, weights, mesh, point),
                                 two = corners_around(other, other_weights, mesh, point);
  take_steps(16, mesh.size(), mesh.size());
  for (const std::size_t of : {triangle, other}) {
    require(have_area(mesh.pieces->triangles[of], mesh.rows()), "triangles_cross", "a triangle has no area");
  }
  const auto way = [&](const std::vector<std::size_t>& ends) {
    return minus(mesh.rows()[ends[1]], mesh.rows()[ends[0]]);
  };
  const bool do_edges_cross = one.size() == 2 && two.size() == 2 && !all_zero(cross(way(one), way(two)));
  require(one.size() == 3 || two.size() == 3 || do_edges_cross, "triangles_cross",
          "the point is not inside of a triangle, or of edges of both that cross");
}

// The corners of two triangles by whether both have them.
struct SharedCorners {
  Indices of_both, of_first, of_second;

  SharedCorners(const MeshTriangle& t, const MeshTriangle& u) {
    const auto has = [](const MeshTriangle& in, std::size_t k) {
      return std::find(in.begin(), in.end(), k) != in.end();
    };
    for (const std::size_t k : t) (has(u, k) ? of_both : of_first).push_back(k);
    for (const std::size_t k : u) {
      if (!has(t, k)) of_second.push_back(k);
    }
  }
};

// Of two triangles that have one corner in common: the ways from there to the others, and what is across them.
struct Corner {
  Integers p, q, normal;
  Integer above_p, above_q;  // how far p and q are above the other's plane, times the length of its normal

  void look_at(const Corner& other) {
    above_p = dot(other.normal, p);
    above_q = dot(other.normal, q);
  }
  bool is_on_one_side() const { return above_p.sign() * above_q.sign() > 0; }
  bool is_in_plane() const { return above_p == 0 && above_q == 0; }

  // Along the line of both planes, where the triangle leaves the corner.
  Integers way() const {
    const Integer far = abs(above_q), near = abs(above_p);
    Integers result;
    for (std::size_t c = 0; c < 3; ++c) result.push_back(far * p[c] + near * q[c]);
    return result;
  }

  // Is a way of the plane in the angle between p and q?
  bool has_within(const Integers& x) const { return dot(normal, cross(p, x)) >= 0 && dot(normal, cross(x, q)) >= 0; }
};

// Have two triangles with an area, which share corners, more in common than these and the edge between two?
bool have_more(const MeshTriangle& t, const MeshTriangle& u, const std::vector<Integers>& rows) {
  const SharedCorners shared(t, u);
  if (shared.of_both.size() == 3) return true;
  const Integers& c = rows[shared.of_both[0]];
  const auto way_to = [&](std::size_t k) { return minus(rows[k], c); };
  if (shared.of_both.size() == 2) {
    const Integers edge = way_to(shared.of_both[1]), one = cross(edge, way_to(shared.of_first[0])),
                   other = cross(edge, way_to(shared.of_second[0]));
    return all_zero(cross(one, other)) && dot(one, other) > 0;
  }
  const auto corner = [&](const Indices& others) {
    Corner result{way_to(others[0]), way_to(others[1]), {}, 0, 0};
    result.normal = cross(result.p, result.q);
    return result;
  };
  Corner of_t = corner(shared.of_first), of_u = corner(shared.of_second);
  of_t.look_at(of_u);
  of_u.look_at(of_t);
  if (of_t.is_on_one_side() || of_u.is_on_one_side()) return false;
  if (of_t.is_in_plane() && of_u.is_in_plane()) {
    return of_t.has_within(of_u.p) || of_t.has_within(of_u.q) || of_u.has_within(of_t.p) || of_u.has_within(of_t.q);
  }
  return dot(of_t.way(), of_u.way()) > 0;
}

// A walk over pairs of parts of one mesh, as `no_crossings` says.
class SelfWalk {
 public:
  explicit SelfWalk(const MeshBody& mesh) : mesh_(mesh) {
    const Part whole{0, mesh.pieces->triangles.size()};
    left_.push_back({whole, whole});
  }

  bool is_done() const { return left_.empty(); }

  // Triangles with themselves, and two that share a corner.
  void pass_over() {
    for (; !left_.empty(); left_.pop_back()) {
      const auto& [p, q] = left_.back();
      if (p.end - p.first > 1 || q.end - q.first > 1) return;
      if (p == q) continue;
      const auto &t = mesh_.pieces->triangles[p.first], &u = mesh_.pieces->triangles[q.first];
      if (SharedCorners(t, u).of_both.empty()) return;
      take_steps(24, mesh_.given->bits, 2 * mesh_.given->bits);
      require(!have_more(t, u, mesh_.rows()), "no_crossings",
              "two triangles of " + mesh_.quoted + " have more in common than corners and an edge");
    }
  }

  std::array<Part, 2> next() {
    const std::array<Part, 2> pair = left_.back();
    left_.pop_back();
    return pair;
  }

  void cut(const std::array<Part, 2>& pair, std::int64_t k) {
    const std::size_t which = k > 0 ? 0 : 1, at = static_cast<std::size_t>(std::abs(k));
    const bool is_one = pair[0] == pair[1];
    require(pair[which].first < at && at < pair[which].end && (k > 0 || !is_one), "no_crossings",
            "a part is cut where it has no triangles on both sides");
    const Part before{pair[which].first, at}, behind{at, pair[which].end};
    if (is_one) left_.insert(left_.end(), {{behind, behind}, {before, behind}, {before, before}});
    for (const Part& half : {behind, before}) {
      if (!is_one) left_.push_back(k > 0 ? std::array{half, pair[1]} : std::array{pair[0], half});
    }
  }

 private:
  const MeshBody& mesh_;
  std::vector<std::array<Part, 2>> left_;
};

void check_no_crossings(const Groups& cuts, const Points& directions, const MeshBody& mesh) {
  const char* const rule = "no_crossings";
  require(!mesh.is_image(), rule, mesh.quoted + " is mapped");
  take_steps(16 * mesh.pieces->triangles.size(), mesh.size(), mesh.size());
  for (const MeshTriangle& t : mesh.pieces->triangles) {
    require(have_area(t, mesh.rows()), rule, "a triangle has no area");
  }
  SelfWalk walk(mesh);
  std::size_t used = 0;
  for (const std::int64_t k : cuts) {
    walk.pass_over();
    require(!walk.is_done(), rule, "the walk goes on where no pair of parts is left");
    const std::array<Part, 2> pair = walk.next();
    if (k != 0) {
      walk.cut(pair, k);
      continue;
    }
    require(used < directions.size(), rule, "there is no direction for a pair of parts");
    const Integers direction = common(directions[used++]).integers;
    const Extent first = extent(mesh, direction, pair[0]), second = extent(mesh, direction, pair[1]);
    require(first.greatest < second.least, rule,
            "a part of " + mesh.quoted + " is not strictly less far along its direction than another one");
  }
  walk.pass_over();
  require(walk.is_done() && used == directions.size(), rule, "the walk does not end with its numbers and directions");
}

}  // namespace

const ClaimRows claims_of_crossings{
    {"triangles_cross",
     "triangle: triangle of subject; weights: weights of subject; other_triangle: triangle of subject; "
     "other_weights: weights of subject",
     rule<check_triangles_cross>},
    {"no_crossings", "cuts: cuts; directions: points", rule<check_no_crossings>},
};

}  // namespace sunder_verifier
