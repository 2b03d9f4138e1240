// The rule "surrounds": docs/claims.md, "Depth".
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

namespace sunder_verifier {
namespace {

// The point of the core that the weights of a hull make; of others the point, which the body holds.
Numbers place_of(const SurfaceEnd& end, const HullBody& body) {
  if (body.around != Around::nothing && body.around != Around::hull) {
    Claim claim;
    claim.weights = end.weights;
    claim.from = end.from;
    check_holds(claim, body, end.point);
    return end.point;
  }
  const Common weights = common_weights(end.weights.values);
  Integer total = 0;
  for (const Integer& weight : weights.integers) {
    require(weight >= 0, "surrounds", "a weight of " + body.quoted + " is negative");
    total += weight;
  }
  Integer one = weights.d;
  if (weights.e < 0) {
    one = shifted(one, -weights.e);
  } else {
    total = shifted(total, weights.e);
  }
  require(total == one, "surrounds", "the weights of " + body.quoted + " do not sum to 1");
  Numbers place(3);
  for (std::size_t k = 0; k < end.weights.named.size(); ++k) {
    const auto [at, e] = image(body, end.weights.named[k]);  // of each point in the same unit
    const std::int64_t up = std::max<std::int64_t>(e, 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      place[axis].n += weights.integers[k] * shifted(at[axis], up);
      place[axis].d = weights.d;
      place[axis].e = weights.e + e - up;
    }
  }
  return place;
}

// x, y, z, w of a point of A less one of B.
Integers difference_of(const SurfaceCorner& corner, const HullBody& a, const HullBody& b) {
  const Numbers p = place_of(corner.of_a, a), q = place_of(corner.of_b, b);
  take_steps(16, a.size() + b.size() + length(p) + length(q), a.size() + b.size() + length(p) + length(q));
  Numbers way;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Common both = common({p[axis], q[axis]});
    way.push_back({both.integers[0] - both.integers[1], both.d, both.e});
  }
  return projective(way);
}

Number radius_of(const HullBody& body) { return body.around == Around::hull ? body.radius : Number{}; }

}  // namespace

void check_surrounds(const Claim& claim, const HullBody& a, const HullBody& b, const Number& least) {
  const Number r = radius_of(a), s = radius_of(b);
  // What is left of `least` beyond the radii, in units of 2^e.
  const Common lengths = common({least, r, s});
  const Integer rest = lengths.integers[0] - lengths.integers[1] - lengths.integers[2];
  const auto squared = [&](const Integer& n, const Integer& whole) {  // n^2, and (rest whole 2^e)^2, in one unit
    const Common both = common({{n * n, 1, 0}, {rest * rest * whole, lengths.d * lengths.d, 2 * lengths.e}});
    return std::pair(both.integers[0], both.integers[1]);
  };
  std::vector<Integers> at;
  std::size_t size = length({least, r, s});
  for (const SurfaceCorner& corner : claim.corners) {
    at.push_back(difference_of(corner, a, b));
    size = std::max(size, bits(at.back()));
  }
  if (claim.triangles.empty()) {
    require(at.size() == 1, "surrounds", "there is no surface, and more than one point");
    const Integers& p = at[0];
    take_steps(8, size, size);
    const Common both = common({{p[0] * p[0] + p[1] * p[1] + p[2] * p[2], 1, 0},
                                {rest * rest * p[3] * p[3], lengths.d * lengths.d, 2 * lengths.e}});
    require(rest <= 0 && both.integers[0] <= both.integers[1], "surrounds", "the point is too far from the origin");
    return;
  }
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [i, j, k] : claim.triangles) {
    take_steps(24, size, size);
    const Integers ij = cross(at[i], at[j]), jk = cross(at[j], at[k]), ki = cross(at[k], at[i]);
    const Integer volume = at[i][0] * jk[0] + at[i][1] * jk[1] + at[i][2] * jk[2];
    require(volume > 0, "surrounds", "a triangle is not counterclockwise from outside");
    Integers normal;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      normal.push_back(at[k][3] * ij[axis] + at[i][3] * jk[axis] + at[j][3] * ki[axis]);
    }
    if (rest > 0) {
      const auto [far, wanted] = squared(volume, dot(normal, normal));
      require(far >= wanted, "surrounds", "a triangle is too near to the origin");
    }
    for (const auto& edge : {std::pair(i, j), {j, k}, {k, i}}) {
      require(edges.insert(edge).second, "surrounds", "an edge occurs twice in the same direction");
    }
  }
  for (const auto& [from, to] : edges) {
    require(edges.count({to, from}) == 1, "surrounds", "the surface is not closed");
  }
}

}  // namespace sunder_verifier
