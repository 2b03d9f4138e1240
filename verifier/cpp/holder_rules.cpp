// The rule that a body holds all points of a mesh: docs/claims.md, "around".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// The points x with normal x >= level.
struct HalfSpace {
  Integers normal;
  Integer level;
};

HalfSpace through(const Integers& point, Integers normal) {
  Integer level = dot(normal, point);
  return {std::move(normal), std::move(level)};
}

Integers negative(const Integers& v) { return {-v[0], -v[1], -v[2]}; }

// Half-spaces whose common part is a point, a triangle or a tetrahedron.
std::vector<HalfSpace> half_spaces_of(const std::vector<Integers>& corners, const std::string& name) {
  std::vector<HalfSpace> result;
  if (corners.size() == 1) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (const int sign : {1, -1}) {
        Integers normal(3);
        normal[c] = sign;
        result.push_back(through(corners[0], std::move(normal)));
      }
    }
  } else if (corners.size() == 3) {
    const Integers normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
    require(!all_zero(normal), "around", "three points of " + name + " are on one line");
    for (const Integers& one : {normal, negative(normal)}) result.push_back(through(corners[0], one));
    for (std::size_t k = 0; k < 3; ++k) {
      result.push_back(through(corners[k], cross(normal, minus(corners[after(k, 3)], corners[k]))));
    }
  } else {
    for (std::size_t k = 0; k < 4; ++k) {
      const Integers &p = corners[k == 0 ? 1 : 0], &q = corners[k <= 1 ? 2 : 1], &r = corners[k <= 2 ? 3 : 2];
      const Integers normal = cross(minus(q, p), minus(r, p));
      const int side = dot(normal, minus(corners[k], p)).sign();
      require(side != 0, "around", "four points of " + name + " are in one plane");
      result.push_back(through(p, side > 0 ? normal : negative(normal)));
    }
  }
  return result;
}

void check_around(const IndexLists& holders, const Indices& held, const MeshBody& a, const HullBody& b) {
  const std::size_t size = a.size() + b.size();
  take_steps(64 * holders.size(), size, 2 * size);
  take_steps(24 * a.rows().size(), 3 * size, size);
  const std::int64_t e = std::min(a.given->e, b.given->e);
  const auto in_unit = [e](const Integers& row, std::int64_t unit) {
    return Integers{shifted(row[0], unit - e), shifted(row[1], unit - e), shifted(row[2], unit - e)};
  };
  std::vector<std::vector<HalfSpace>> bounds;
  for (const Indices& holder : holders) {
    std::vector<Integers> corners;
    for (const std::size_t k : holder) corners.push_back(in_unit(b.rows()[k], b.given->e));
    bounds.push_back(half_spaces_of(corners, b.quoted));
  }
  for (std::size_t k = 0; k < a.rows().size(); ++k) {
    const Integers at = in_unit(a.rows()[k], a.given->e);
    const std::vector<HalfSpace>& home = bounds[held[k]];
    require(std::all_of(home.begin(), home.end(), [&](const HalfSpace& h) { return dot(h.normal, at) >= h.level; }),
            "around", "point " + std::to_string(k) + " of " + a.quoted + " is not where it is said to be held");
  }
}

}  // namespace

const ClaimRows claims_of_holders{
    {"around", "holders: holders of b; held: held of holders", rule<check_around>},
};

}  // namespace sunder_verifier
