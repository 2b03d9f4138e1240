// The rules about meshes: docs/claims.md, "Meshes".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// Triangles that follow each other.
struct Part {
  std::size_t first, end;

  friend bool operator==(const Part&, const Part&) = default;
};

// How far the corners of a part reach along a direction, from the least to the greatest, as integers * 2^e.
struct Extent {
  Integer least, greatest;
  std::int64_t e;
};

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
  Indices corners;
  for (std::size_t t = part.first; t < part.end; ++t) {
    corners.insert(corners.end(), mesh.pieces->triangles[t].begin(), mesh.pieces->triangles[t].end());
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  Integer least = dot(direction, mesh.rows()[corners.front()]), greatest = least;
  for (const std::size_t k : corners) {
    const Integer product = dot(direction, mesh.rows()[k]);
    if (product < least) least = product;
    if (product > greatest) greatest = product;
  }
  return {shifted(least, turned - e) + moved, shifted(greatest, turned - e) + moved, e};
}

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

void check_covered(const Groups& cuts, const Points& directions, const StatedRays& rays_a, const StatedRays& rays_b,
                   const MeshBody& a, const MeshBody& b) {
  const std::array<const MeshBody*, 2> meshes{&a, &b};
  const Pair whole{Part{0, a.pieces->triangles.size()}, Part{0, b.pieces->triangles.size()}};
  std::array<std::set<std::size_t>, 2> outside;  // pieces
  std::vector<Pair> left{whole};
  std::size_t used = 0;
  for (const std::int64_t k : cuts) {
    require(!left.empty(), "covered", "the walk goes on where no pair of parts is left");
    const Pair pair = left.back();
    left.pop_back();
    if (k != 0) {
      const std::size_t which = k > 0 ? 0 : 1, at = static_cast<std::size_t>(std::abs(k));
      require(pair[which].first < at && at < pair[which].end, "covered",
              "a part is cut where it has no triangles on both sides");
      Pair before = pair, behind = pair;
      before[which].end = behind[which].first = at;
      left.push_back(behind);
      left.push_back(before);
      continue;
    }
    require(used < directions.size(), "covered", "there is no direction for a pair of parts");
    const Integers direction = common(directions[used++]).integers;
    const Extent of_a = extent(a, direction, pair[0]), of_b = extent(b, direction, pair[1]);
    require(compare(of_a.greatest, of_a.e, of_b.least, of_b.e) < 0, "covered",
            "a part of " + a.quoted + " is not strictly less far along its direction than one of " + b.quoted);
    for (const std::size_t which : {0u, 1u}) {
      if (pair[1 - which] != whole[1 - which]) continue;
      const auto piece = meshes[which]->pieces->piece.begin();
      outside[which].insert(piece + static_cast<std::ptrdiff_t>(pair[which].first),
                            piece + static_cast<std::ptrdiff_t>(pair[which].end));
    }
  }
  require(left.empty() && used == directions.size(), "covered",
          "the walk does not end with its numbers and directions");
  const std::array<const StatedRays*, 2> rays{&rays_a, &rays_b};
  for (const std::size_t which : {0u, 1u}) {
    const MeshBody &mesh = *meshes[which], &other = *meshes[1 - which];
    for (const auto& [triangle, along] : *rays[which]) {
      auto [place, e] = image(mesh, mesh.pieces->triangles[triangle][0]);
      for (Integer& n : place) n = shifted(n, std::max<std::int64_t>(e, 0));
      place.push_back(shifted(1, std::max<std::int64_t>(-e, 0)));
      require(winding("covered", other, along, place) == 0, "covered",
              "triangle " + std::to_string(triangle) + " of " + mesh.quoted + " is inside of " + other.quoted);
      outside[which].insert(mesh.pieces->piece[triangle]);
    }
    const auto& all = mesh.pieces->piece;
    const bool are_all = other.pieces->closed == 0 || std::all_of(all.begin(), all.end(), [&](std::size_t piece) {
                           return outside[which].contains(piece);
                         });
    require(are_all, "covered", "a piece of " + mesh.quoted + " is not shown to be outside of " + other.quoted);
  }
}

void check_on_triangle(const std::size_t& triangle, const WeightList& weights, const MeshBody& mesh,
                       const Numbers& point) {
  const MeshTriangle& corners = mesh.pieces->triangles[triangle];
  for (const std::size_t k : weights.named) {
    require(std::find(corners.begin(), corners.end(), k) != corners.end(), "on_triangle",
            "a weight is not of a corner of the triangle");
  }
  holds(weights, {}, mesh, point);
}

void check_encloses(const Numbers& along, const MeshBody& mesh, const Numbers& point) {
  require(winding("encloses", mesh, along, projective(point)) != 0, "encloses",
          "the point is not inside of " + mesh.quoted);
}

}  // namespace

const ClaimRows claims_of_meshes{
    {"covered", "cuts: cuts; directions: points; rays_a: rays of a; rays_b: rays of b", rule<check_covered>},
    {"on_triangle", "triangle: triangle of subject; weights: weights of subject", rule<check_on_triangle>},
    {"encloses", "direction: point", rule<check_encloses>},
};

}  // namespace sunder_verifier
