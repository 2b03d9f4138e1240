// The rules about bodies that move: docs/claims.md, "Rules", from `parted_all_along` to `not_before`.
#include <verifier/cpp/rules.h>

#include <utility>

namespace sunder_verifier {
namespace {

// A point, less how far the body has come by then.
Numbers moved_back(const Numbers& point, const Number& time, const StatedMotion& body) {
  const std::size_t size = length(point) + length({time}) + body.begin->size() + body.end->size();
  take_steps(16, size, size);
  Numbers result;
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    Numbers parts{point[axis]};
    for (const auto& [place, sign] : {std::pair(body.begin, 1), std::pair(body.end, -1)}) {
      if (!place->is_image()) continue;
      const Scaled& moved = place->translation;
      parts.push_back({sign * time.n * moved.rows[0][axis], time.d, time.e + moved.e});
    }
    const Common all = common(parts);
    Number sum{0, all.d, all.e};
    for (const Integer& n : all.integers) sum.n += n;
    result.push_back(std::move(sum));
  }
  return result;
}

}  // namespace

void check_parted_all_along(const Claim& claim, const StatedMotion& a, const StatedMotion& b) {
  check_parted(claim, *a.begin, *b.begin);
  check_parted(claim, *a.end, *b.end);
}

void check_holds_at(const Claim& claim, const StatedMotion& body, const Number& time, const Numbers& point) {
  check_holds(claim, *body.begin, moved_back(point, time, body));
}

void check_not_before(const Claim& claim, const StatedMotion& a, const StatedMotion& b, const Number& time,
                      const Numbers& point) {
  const Integers direction = common(claim.direction).integers;  // along a positive multiple
  Integers back = direction;
  for (Integer& n : back) n = -n;
  const Integers of_a = projective(moved_back(point, time, a)), of_b = projective(moved_back(point, time, b));
  const auto require_behind = [](const HullBody& body, const Integers& way, const Integers& place) {
    require(is_behind("not_before", body, way, place), "not_before", body.quoted + " extends beyond the point");
  };
  require_behind(*a.begin, direction, of_a);
  require_behind(*b.begin, back, of_b);
  // The direction times both, the way from the first to the second.
  Integer nearer = 0;
  for (std::size_t axis = 0; axis < direction.size(); ++axis) {
    nearer += direction[axis] * (of_b[axis] * of_a.back() - of_a[axis] * of_b.back());
  }
  require(nearer > 0, "not_before",
          "along the direction " + a.begin->quoted + " and " + b.begin->quoted + " do not come nearer");
}

}  // namespace sunder_verifier
