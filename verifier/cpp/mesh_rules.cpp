// The rules about meshes: docs/claims.md, "Meshes".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/mesh_parts.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {

namespace {

// The corners of a part's triangles, each once. A large part marks the points that it has seen, one mark for each point
// of the mesh; a small part sorts its corners, so that its cost does not depend on the mesh.
Indices corners_of(const MeshBody& mesh, const Part& part) {
  const std::span<const MeshTriangle> triangles(mesh.pieces->triangles.data() + part.first, part.end - part.first);
  Indices corners;
  if (16 * triangles.size() >= mesh.rows().size()) {
    std::vector<bool> is_known(mesh.rows().size());
    for (const MeshTriangle& triangle : triangles) {
      for (const std::size_t k : triangle) {
        if (!is_known[k]) corners.push_back(k);
        is_known[k] = true;
      }
    }
    return corners;
  }
  for (const MeshTriangle& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

Extent extent(const MeshBody& mesh, Integers direction, const Part& part) {
  std::int64_t turned = mesh.given->e, e = turned;
  Integer moved = 0;
  if (mesh.is_image()) {
    take_steps(9, bits(direction), mesh.linear.bits);
    turned += mesh.linear.e;
    e = std::min(turned, mesh.translation.e);
    moved = shifted(dot(direction, mesh.translation.rows[0]), mesh.translation.e - e);
    direction = transposed_times(mesh.linear, direction);
  }
  take_steps(3 * (part.end - part.first), bits(direction), mesh.given->bits);
  const Indices corners = corners_of(mesh, part);
  Integer least = dot(direction, mesh.rows()[corners.front()]), greatest = least;
  for (const std::size_t k : corners) {
    const Integer product = dot(direction, mesh.rows()[k]);
    if (product < least) least = product;
    if (product > greatest) greatest = product;
  }
  return {shifted(least, turned - e) + moved, shifted(greatest, turned - e) + moved, e};
}

bool have_area(const MeshTriangle& triangle, const std::vector<Integers>& rows) {
  return !all_zero(cross(minus(rows[triangle[1]], rows[triangle[0]]), minus(rows[triangle[2]], rows[triangle[0]])));
}

namespace {

// A place among numbers, of which the sign alone counts.
int sign(const Integer& n) { return n.sign(); }

// The corners of a mesh as they are seen from a point, along a ray: two coordinates across it, one along it, in a frame
// that is not mirrored.
class Seen {
 public:
  Seen(const MeshBody& mesh, const Integers& direction, const Integers& from) {
    const std::size_t axis = direction[0] != 0 ? 0 : direction[1] != 0 ? 1 : 2;
    std::array<std::size_t, 2> others{(axis + 1) % 3, (axis + 2) % 3};
    if (direction[axis] < 0) std::swap(others[0], others[1]);
    std::array<Integers, 3> frame{Integers(3), Integers(3), direction};
    for (std::size_t k = 0; k < 2; ++k) {
      frame[k][others[k]] = direction[axis];
      frame[k][axis] = -direction[others[k]];
    }
    for (std::size_t k = 0; k < mesh.rows().size(); ++k) {
      const auto [at, e] = image(mesh, k);
      Integers way;  // times the denominator of the point
      for (std::size_t c = 0; c < 3; ++c) {
        way.push_back(shifted(at[c] * from[3], std::max<std::int64_t>(e, 0)) -
                      shifted(from[c], std::max<std::int64_t>(-e, 0)));
      }
      corners_.push_back({dot(frame[0], way), dot(frame[1], way), dot(frame[2], way)});
    }
  }

  const std::array<Integer, 3>& operator[](std::size_t k) const { return corners_[k]; }

 private:
  std::vector<std::array<Integer, 3>> corners_;
};

// How often the closed pieces wind around a point x, .., w, or whether a ray from it crosses them an odd number of
// times: along the ray, how often it leaves them, less how often it enters.
std::int64_t winding(const char* rule, const MeshBody& mesh, const Numbers& along, const Integers& point) {
  const Integers direction = common(along).integers;
  const std::size_t size = bits(direction) + mesh.size() + bits(point);
  const MeshPieces& pieces = *mesh.pieces;
  take_steps(8 * (mesh.rows().size() + pieces.triangles.size()), size, size);
  require(!all_zero(direction), rule, "the direction is zero");
  const Seen seen(mesh, direction, point);
  std::int64_t sum = 0;
  for (std::size_t t = 0; t < pieces.triangles.size(); ++t) {
    if (!pieces.is_closed[t]) continue;
    const auto& [i, j, k] = pieces.triangles[t];
    const std::array corners{&seen[i], &seen[j], &seen[k]};
    const auto are_all = [&](std::size_t axis, int way) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const auto* corner) { return sign((*corner)[axis]) == way; });
    };
    if (are_all(0, 1) || are_all(0, -1) || are_all(1, 1) || are_all(1, -1)) continue;
    std::array<Integer, 3> turns;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto &p = *corners[c], &q = *corners[after(c, 3)];
      turns[c] = p[0] * q[1] - q[0] * p[1];
    }
    const auto [least, greatest] = std::minmax_element(turns.begin(), turns.end());
    if ((*least < 0 && *greatest > 0) || are_all(2, -1)) continue;
    Integer height = 0;  // of the point before the triangle, as seen from the side that the ray goes on to
    for (std::size_t c = 0; c < 3; ++c) height += turns[c] * (*corners[after(after(c, 3), 3)])[2];
    const bool is_inner = *least > 0 || *greatest < 0;
    require(is_inner && height != 0, rule, "the ray meets an edge, or begins on a triangle, of " + mesh.quoted);
    const int way = sign(turns[0]);
    if (sign(height) == way) sum += way;
  }
  return pieces.by_winding ? sum : sum % 2;
}

using Pair = std::array<Part, 2>;
using Pieces = std::set<std::size_t>;

struct Scalar {
  Integer n;
  std::int64_t e;
};

// What is required of two parts besides, which the direction parts: with how far they reach along it.
using Besides =
    std::function<void(const Integers& direction, const Pair& parts, const Extent& of_a, const Extent& of_b)>;

// From where A's part ends to where B's begins, as an integer * 2^e.
Scalar gap_between(const Extent& of_a, const Extent& of_b) {
  const std::int64_t e = std::min(of_a.e, of_b.e);
  return {shifted(of_b.least, of_b.e - e) - shifted(of_a.greatest, of_a.e - e), e};
}

// That it is as far as square / over * 2^e, squared. length: of what that is made of.
Besides far_apart(const char* rule, const MeshBody& a, const MeshBody& b, const Integer& square, const Integer& over,
                  std::int64_t e, std::size_t length) {
  return [=, &a, &b](const Integers& direction, const Pair&, const Extent& of_a, const Extent& of_b) {
    const std::size_t size = bits(direction) + a.size() + b.size() + length;
    take_steps(16, size, size);
    const Scalar gap = gap_between(of_a, of_b);
    require(
        compare(gap.n * gap.n * over, 2 * gap.e, square * dot(direction, direction), e) >= 0, rule,
        "a part of " + a.quoted + " and one of " + b.quoted + " are less far apart than stated, along their direction");
  };
}

// Requires that each triangle of A is parted from each of B. The pieces of each that are parted from all of the other.
std::array<Pieces, 2> parted(const char* rule, const Groups& cuts, const Points& directions, const MeshBody& a,
                             const MeshBody& b, const Besides& besides = {}) {
  const std::array<const MeshBody*, 2> meshes{&a, &b};
  const Pair whole{Part{0, a.pieces->triangles.size()}, Part{0, b.pieces->triangles.size()}};
  std::array<Pieces, 2> outside;
  std::vector<Pair> left{whole};
  std::size_t used = 0;
  for (const std::int64_t k : cuts) {
    require(!left.empty(), rule, "the walk goes on where no pair of parts is left");
    const Pair pair = left.back();
    left.pop_back();
    if (k != 0) {
      const std::size_t which = k > 0 ? 0 : 1, at = static_cast<std::size_t>(std::abs(k));
      require(pair[which].first < at && at < pair[which].end, rule,
              "a part is cut where it has no triangles on both sides");
      Pair before = pair, behind = pair;
      before[which].end = behind[which].first = at;
      left.push_back(behind);
      left.push_back(before);
      continue;
    }
    require(used < directions.size(), rule, "there is no direction for a pair of parts");
    const Integers direction = common(directions[used++]).integers;
    const Extent of_a = extent(a, direction, pair[0]), of_b = extent(b, direction, pair[1]);
    require(compare(of_a.greatest, of_a.e, of_b.least, of_b.e) < 0, rule,
            "a part of " + a.quoted + " is not strictly less far along its direction than one of " + b.quoted);
    if (besides) besides(direction, pair, of_a, of_b);
    for (const std::size_t which : {0u, 1u}) {
      if (pair[1 - which] != whole[1 - which]) continue;
      const auto piece = meshes[which]->pieces->piece.begin();
      outside[which].insert(piece + static_cast<std::ptrdiff_t>(pair[which].first),
                            piece + static_cast<std::ptrdiff_t>(pair[which].end));
    }
  }
  require(left.empty() && used == directions.size(), rule, "the walk does not end with its numbers and directions");
  return outside;
}

Integers place_of(const MeshBody& mesh, std::size_t point) {
  auto [place, e] = image(mesh, point);
  for (Integer& n : place) n = shifted(n, std::max<std::int64_t>(e, 0));
  place.push_back(shifted(1, std::max<std::int64_t>(-e, 0)));
  return place;
}

// Adds the pieces that rays from first corners of triangles tell to be inside of another mesh, or outside of it.
void add_told(const char* rule, const MeshBody& mesh, const MeshBody& other, const StatedRays& rays, bool inside,
              Pieces& pieces) {
  for (const auto& [triangle, along] : rays) {
    require(triangle < mesh.pieces->triangles.size(), rule, "a ray is of a triangle that is not there");
    const bool is_inside = winding(rule, other, along, place_of(mesh, mesh.pieces->triangles[triangle][0])) != 0;
    require(is_inside == inside, rule,
            "triangle " + std::to_string(triangle) + " of " + mesh.quoted + (inside ? " is not" : " is") +
                " inside of " + other.quoted);
    pieces.insert(mesh.pieces->piece[triangle]);
  }
}

bool are_all_in(const MeshBody& mesh, const Pieces& pieces) {
  const auto& all = mesh.pieces->piece;
  return std::all_of(all.begin(), all.end(), [&](std::size_t piece) { return pieces.contains(piece); });
}

void require_outside(const char* rule, const MeshBody& mesh, const MeshBody& other, const StatedRays& rays,
                     Pieces pieces) {
  add_told(rule, mesh, other, rays, false, pieces);
  require(other.pieces->closed == 0 || are_all_in(mesh, pieces), rule,
          "a piece of " + mesh.quoted + " is not shown to be outside of " + other.quoted);
}

void require_covered(const char* rule, const Groups& cuts, const Points& directions, const StatedRays& rays_a,
                     const StatedRays& rays_b, const MeshBody& a, const MeshBody& b, const Besides& besides = {}) {
  const std::array<Pieces, 2> outside = parted(rule, cuts, directions, a, b, besides);
  require_outside(rule, a, b, rays_a, outside[0]);
  require_outside(rule, b, a, rays_b, outside[1]);
}

void check_covered(const Groups& cuts, const Points& directions, const StatedRays& rays_a, const StatedRays& rays_b,
                   const MeshBody& a, const MeshBody& b) {
  require_covered("covered", cuts, directions, rays_a, rays_b, a, b);
}

void check_covered_apart(const Groups& cuts, const Points& directions, const StatedRays& rays_a,
                         const StatedRays& rays_b, const MeshBody& a, const MeshBody& b, const Numbers& from_a,
                         const Numbers& to_b) {
  const Integers p = projective(from_a), q = projective(to_b), way = way_between(p, q);
  const Integer over = p.back() * q.back();
  constexpr const char* rule = "covered_apart";
  require_covered(rule, cuts, directions, rays_a, rays_b, a, b,
                  far_apart(rule, a, b, dot(way, way), over * over, 0, length(from_a) + length(to_b)));
}

void check_covered_clear(const Groups& cuts, const Points& directions, const StatedRays& rays_a,
                         const StatedRays& rays_b, const MeshBody& a, const MeshBody& b, const Number& least) {
  constexpr const char* rule = "covered_clear";
  require_covered(rule, cuts, directions, rays_a, rays_b, a, b,
                  far_apart(rule, a, b, least.n * least.n, 1, 2 * least.e, length({least})));
}

void check_covered_all_along(const Groups& cuts, const Points& directions, const StatedRays& rays_a,
                             const StatedRays& rays_b, const MeshBody& a, const MeshBody& b, const MeshBody& to_a,
                             const MeshBody& to_b) {
  const auto are_parted = [&](const Integers& direction, const Pair& parts, const Extent&, const Extent&) {
    const Extent of_a = extent(to_a, direction, parts[0]), of_b = extent(to_b, direction, parts[1]);
    require(
        compare(of_a.greatest, of_a.e, of_b.least, of_b.e) < 0, "covered_all_along",
        "at the end a part of " + a.quoted + " is not strictly less far along its direction than one of " + b.quoted);
  };
  require_covered("covered_all_along", cuts, directions, rays_a, rays_b, a, b, are_parted);
}

void check_covered_before(const Groups& cuts, const Points& directions, const StatedRays& rays_a,
                          const StatedRays& rays_b, const MeshBody& a, const MeshBody& b, const MeshBody& to_a,
                          const MeshBody& to_b, const Number& time) {
  const Integers ends = common({time, {1, 1, 0}}).integers;
  const Integer &now = ends[0], left = ends[1] - now;
  const auto are_parted = [&](const Integers& direction, const Pair& parts, const Extent& of_a, const Extent& of_b) {
    const Extent at_end_a = extent(to_a, direction, parts[0]), at_end_b = extent(to_b, direction, parts[1]);
    const std::size_t size = bits(direction) + a.size() + b.size() + to_a.size() + to_b.size() + length({time});
    take_steps(16, size, size);
    const Scalar first = gap_between(of_a, of_b), end = gap_between(at_end_a, at_end_b);
    require(compare(first.n * left, first.e, -end.n * now, end.e) >= 0, "covered_before",
            "at the time a part of " + a.quoted + " is further along its direction than one of " + b.quoted);
  };
  require_covered("covered_before", cuts, directions, rays_a, rays_b, a, b, are_parted);
}

void check_covered_within(const Groups& cuts, const Points& directions, const StatedRays& inner,
                          const StatedRays& outer, const MeshBody& a, const MeshBody& b) {
  const std::array<Pieces, 2> outside = parted("covered_within", cuts, directions, a, b);
  Pieces inside;
  add_told("covered_within", a, b, inner, true, inside);
  require(are_all_in(a, inside), "covered_within",
          "a piece of " + a.quoted + " is not shown to be inside of " + b.quoted);
  require_outside("covered_within", b, a, outer, outside[1]);
}

// Requires that the parts of a mesh, one after the other, are parted from a body, and that far; and that the body's first
// point is outside of the mesh, where that is not seen from the parts.
void require_beside(const char* rule, const Groups& until, const Points& directions, const Points& away,
                    const MeshBody& a, const HullBody& b, const Number& least = {}) {
  require(until.size() == directions.size(), rule, "there are not as many directions as parts");
  Part part{0, 0};
  for (std::size_t k = 0; k < until.size(); ++k) {
    part.first = part.end;
    part.end = static_cast<std::size_t>(std::max<std::int64_t>(until[k], 0));
    require(part.first < part.end && part.end <= a.pieces->triangles.size(), rule,
            "the parts do not follow each other in " + a.quoted);
    const Integers direction = common(directions[k]).integers;
    const Extent of_part = extent(a, direction, part);
    require_beyond(rule, {of_part.greatest, of_part.e, a.size()}, direction, b, least);
  }
  require(part.end == a.pieces->triangles.size(), rule, "a triangle of " + a.quoted + " is in no part");
  require(away.size() <= 1, rule, "there is more than one ray");
  for (const Numbers& along : away) {
    auto [place, e] = image(b, 0);
    for (Integer& n : place) n = shifted(n, std::max<std::int64_t>(e, 0));
    place.push_back(shifted(1, std::max<std::int64_t>(-e, 0)));
    require(winding(rule, a, along, place) == 0, rule, "the first point of " + b.quoted + " is inside of " + a.quoted);
  }
  require(!away.empty() || until.size() == 1 || a.pieces->closed == 0, rule,
          b.quoted + " is not shown to be outside of " + a.quoted);
}

void check_beside(const Groups& until, const Points& directions, const Points& away, const MeshBody& a,
                  const HullBody& b) {
  require_beside("beside", until, directions, away, a, b);
}

void check_clear_beside(const Groups& until, const Points& directions, const Points& away, const MeshBody& a,
                        const HullBody& b, const Number& least) {
  require_beside("clear_beside", until, directions, away, a, b, least);
}

void require_on_triangle(const char* rule, std::size_t triangle, const WeightList& weights, const MeshBody& mesh,
                         const Numbers& point) {
  const MeshTriangle& corners = mesh.pieces->triangles[triangle];
  for (const std::size_t k : weights.named) {
    require(std::find(corners.begin(), corners.end(), k) != corners.end(), rule,
            "a weight is not of a corner of the triangle");
  }
  holds(weights, {}, mesh, point);
}

void check_on_triangle(const std::size_t& triangle, const WeightList& weights, const MeshBody& mesh,
                       const Numbers& point) {
  require_on_triangle("on_triangle", triangle, weights, mesh, point);
}

void check_on_triangle_at(const std::size_t& triangle, const WeightList& weights, const MeshBody& mesh,
                          const MeshBody& to, const Number& time, const Numbers& point) {
  require_on_triangle("on_triangle_at", triangle, weights, mesh, moved_back(point, time, mesh, to));
}

void check_encloses(const Numbers& along, const MeshBody& mesh, const Numbers& point) {
  require(winding("encloses", mesh, along, projective(point)) != 0, "encloses",
          "the point is not inside of " + mesh.quoted);
}

// ---- A tree of planes.

// A convex polygon, by its corners x, .., w in lowest terms.
using Corners = std::vector<Integers>;
using PolygonsOfBoth = std::array<std::vector<Corners>, 2>;

// Numbers x, .., w for a point, with a positive w.
Integers lowest_terms(Integers row) {
  if (row.back() < 0) row = opposite(std::move(row));
  return reduced(std::move(row));
}

Integer height(const Integers& plane, const Integers& point) {
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] - plane[3] * point[3];
}

// What of a polygon is above a plane, and what is below; no corners, where it has no point there. New corners are not in
// lowest terms.
std::array<Corners, 2> halves(const Corners& polygon, const Integers& plane) {
  Integers heights;
  for (const Integers& corner : polygon) heights.push_back(height(plane, corner));
  const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
  if (*least >= 0) return {*greatest > 0 ? polygon : Corners(), Corners()};
  if (*greatest <= 0) return {Corners(), polygon};
  std::array<Corners, 2> result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t next = after(k, polygon.size());
    const Integer &here = heights[k], &there = heights[next];
    if (here >= 0) result[0].push_back(polygon[k]);
    if (here <= 0) result[1].push_back(polygon[k]);
    if (sign(here) * sign(there) >= 0) continue;
    Integers crossing;
    for (std::size_t c = 0; c < 4; ++c) crossing.push_back(here * polygon[next][c] - there * polygon[k][c]);
    for (Corners& half : result) half.push_back(crossing);
  }
  return result;
}

std::vector<Corners> polygons_of(const MeshBody& mesh) {
  const MeshPieces& pieces = *mesh.pieces;
  take_steps(16 * (mesh.rows().size() + pieces.closed), mesh.size(), mesh.size());
  std::vector<Integers> corners;
  for (std::size_t k = 0; k < mesh.rows().size(); ++k) corners.push_back(lowest_terms(place_of(mesh, k)));
  std::vector<Corners> result;
  for (std::size_t t = 0; t < pieces.triangles.size(); ++t) {
    const MeshTriangle& triangle = pieces.triangles[t];
    if (!pieces.is_closed[t] || !have_area(triangle, mesh.rows())) continue;
    result.push_back({corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
  }
  return result;
}

// Is a cell outside of a mesh, or inside of it?
enum class Told : std::uint8_t { nothing, outside, inside };
using ToldCells = std::vector<std::array<Told, 2>>;

// A plane that cut a cell, on which side of it the cell is, and the step before, or no_index.
struct PathStep {
  std::size_t plane;
  int side;
  std::size_t before;
};

struct CutCell {
  std::size_t path = no_index;  // its last step
  PolygonsOfBoth parts;         // of triangles that go through it
};

std::size_t most_bits(const Corners& polygon) {
  std::size_t most = 0;
  for (const Integers& corner : polygon) most = std::max(most, bits(corner));
  return most;
}

// Each polygon, and what of it is on either side.
std::array<PolygonsOfBoth, 2> cut_by(const Integers& plane, const PolygonsOfBoth& parts) {
  std::array<PolygonsOfBoth, 2> sides;
  for (const std::size_t which : {0u, 1u}) {
    for (const Corners& polygon : parts[which]) {
      const std::size_t of_plane = bits(plane), of_corners = most_bits(polygon);
      take_steps(8 * polygon.size(), of_plane, of_corners);
      std::array<Corners, 2> half = halves(polygon, plane);
      if (!half[0].empty() && !half[1].empty()) {
        take_steps(32, of_plane + 2 * of_corners, of_plane + 2 * of_corners);
        for (Corners& of_half : half) {
          for (Integers& corner : of_half) corner = lowest_terms(std::move(corner));
        }
      }
      for (const std::size_t k : {0u, 1u}) {
        if (!half[k].empty()) sides[k][which].push_back(std::move(half[k]));
      }
    }
  }
  return sides;
}

// What is told of each cell of a tree of planes.
ToldCells told_cells(const char* rule, const Groups& cuts, const Points& planes, const Points& cells,
                     const std::array<const StatedRays*, 2>& rays, const std::array<const MeshBody*, 2>& meshes) {
  std::vector<Integers> places, of_planes;
  for (const Numbers& cell : cells) places.push_back(projective(cell));
  ToldCells told(cells.size());
  CutCell root;
  for (const std::size_t which : {0u, 1u}) {
    for (const auto& [cell, along] : *rays[which]) {
      require(cell < cells.size(), rule, "a ray is of a cell that is not there");
      told[cell][which] = winding(rule, *meshes[which], along, places[cell]) != 0 ? Told::inside : Told::outside;
    }
  }
  for (const std::size_t which : {0u, 1u}) root.parts[which] = polygons_of(*meshes[which]);
  std::vector<PathStep> path;
  std::vector<CutCell> left;
  left.push_back(std::move(root));
  std::size_t used = 0;
  for (const std::int64_t cut : cuts) {
    require(!left.empty() && (cut == 0 || cut == 1), rule,
            "the walk goes on where no cell is left, or a number is not 0 or 1");
    CutCell cell = std::move(left.back());
    left.pop_back();
    if (cut == 1) {
      require(of_planes.size() < planes.size(), rule, "there is no plane for a cut");
      of_planes.push_back(common(planes[of_planes.size()]).integers);
      std::array<PolygonsOfBoth, 2> sides = cut_by(of_planes.back(), cell.parts);
      for (const std::size_t k : {1u, 0u}) {
        path.push_back({of_planes.size() - 1, k == 0 ? 1 : -1, cell.path});
        left.push_back({path.size() - 1, std::move(sides[k])});
      }
      continue;
    }
    require(used < cells.size(), rule, "there is no point for a cell");
    const std::string name = "cell " + std::to_string(used);
    for (const std::size_t which : {0u, 1u}) {
      require(told[used][which] == Told::nothing || cell.parts[which].empty(), rule,
              "a triangle of " + meshes[which]->quoted + " goes through " + name);
    }
    const Integers& place = places[used++];
    for (std::size_t k = cell.path; k != no_index; k = path[k].before) {
      const auto& [plane, side, before] = path[k];
      take_steps(8, bits(of_planes[plane]), bits(place));
      require(sign(height(of_planes[plane], place)) == side, rule, "the point of " + name + " is not in it");
    }
  }
  require(left.empty() && of_planes.size() == planes.size() && used == cells.size(), rule,
          "the walk does not end with its numbers, planes and points");
  return told;
}

void check_insides_apart(const Groups& cuts, const Points& planes, const Points& cells, const StatedRays& first,
                         const StatedRays& second, const MeshBody& a, const MeshBody& b) {
  for (const auto& [in_a, in_b] : told_cells("insides_apart", cuts, planes, cells, {&first, &second}, {&a, &b})) {
    require(in_a == Told::outside || in_b == Told::outside, "insides_apart",
            "a cell is not shown to be outside of one");
  }
}

void check_part_of(const Groups& cuts, const Points& planes, const Points& cells, const StatedRays& first,
                   const StatedRays& second, const MeshBody& a, const MeshBody& b) {
  for (const auto& [in_a, in_b] : told_cells("part_of", cuts, planes, cells, {&first, &second}, {&a, &b})) {
    require(in_a == Told::outside || in_b == Told::inside, "part_of",
            "a cell is not shown to be outside of " + a.quoted + " or inside of " + b.quoted);
  }
}

void check_equal_insides(const Groups& cuts, const Points& planes, const Points& cells, const StatedRays& first,
                         const StatedRays& second, const MeshBody& a, const MeshBody& b) {
  for (const auto& [in_a, in_b] : told_cells("equal_insides", cuts, planes, cells, {&first, &second}, {&a, &b})) {
    require(in_a != Told::nothing && in_a == in_b, "equal_insides",
            "a cell is not shown to be inside of both or outside");
  }
}

constexpr const char* cover = "cuts: cuts; directions: points; rays_a: rays of a; rays_b: rays of b";
constexpr const char* parts = "until: cuts; directions: points; away: points";
constexpr const char* partition =
    "cuts: cuts; planes: planes; cells: points; rays_first: told rays; rays_second: told rays";

}  // namespace

const ClaimRows claims_of_meshes{
    {"covered", cover, rule<check_covered>},
    {"covered_apart", cover, rule<check_covered_apart>},
    {"covered_clear", cover, rule<check_covered_clear>},
    {"covered_all_along", cover, rule<check_covered_all_along>},
    {"covered_before", cover, rule<check_covered_before>},
    {"covered_within", "cuts: cuts; directions: points; rays_inner: told rays; rays_outer: told rays",
     rule<check_covered_within>},
    {"beside", parts, rule<check_beside>},
    {"clear_beside", parts, rule<check_clear_beside>},
    {"insides_apart", partition, rule<check_insides_apart>},
    {"part_of", partition, rule<check_part_of>},
    {"equal_insides", partition, rule<check_equal_insides>},
    {"on_triangle", "triangle: triangle of subject; weights: weights of subject", rule<check_on_triangle>},
    {"on_triangle_at", "triangle: triangle of subject; weights: weights of subject", rule<check_on_triangle_at>},
    {"encloses", "direction: point", rule<check_encloses>},
};

}  // namespace sunder_verifier
