#include <sunder/base/names.h>
#include <sunder/certificate/check.h>
#include <sunder/predicate/point/common_point.h>

#include <algorithm>
#include <cmath>

namespace sunder {

namespace {

// Is there a direction at all: are its indices in range, and its numbers such as exact arithmetic can hold?
bool names_a_direction(const Direction& d, std::size_t n_a, std::size_t n_b) {
  constexpr std::int64_t most = 20000;  // the exponents of certificate files: docs/claims.md
  const auto in_a = [&](std::size_t k) { return d.index[k] < n_a; };
  const auto in_b = [&](std::size_t k) { return d.index[k] < n_b; };
  switch (d.kind) {
    case Direction::Kind::given:
      return std::isfinite(d.given.x) && std::isfinite(d.given.y) && std::isfinite(d.given.z);
    case Direction::Kind::normal_of_a: return in_a(0) && in_a(1) && in_a(2);
    case Direction::Kind::normal_of_b: return in_b(0) && in_b(1) && in_b(2);
    case Direction::Kind::edge_cross_edge: return in_a(0) && in_a(1) && in_b(2) && in_b(3);
    case Direction::Kind::difference: return in_a(0) && in_b(1);
    case Direction::Kind::side_of_a: return in_a(0) && in_a(1);
    case Direction::Kind::side_of_b: return in_b(0) && in_b(1);
    case Direction::Kind::exact:
      return d.numbers != nullptr && std::all_of(d.numbers->begin(), d.numbers->end(), [&](const Dyadic& x) {
               return x.exponent() >= -most && x.exponent() <= most;
             });
  }
  return false;
}

CheckResult check(const Separation& c, const PlacedVertices& a, const PlacedVertices& b) {
  if (c.extreme_a >= a.vertices.size() || c.extreme_b >= b.vertices.size()) return CheckResult::bad_index;
  if (!names_a_direction(c.direction, a.vertices.size(), b.vertices.size())) return CheckResult::bad_index;
  const WorldDirection direction = world_direction(c.direction, a, b);
  if (compare_along(direction, a[c.extreme_a], b[c.extreme_b]) != Sign::positive)
    return CheckResult::not_strictly_apart;
  Along along_a(direction, a.pose, a.tame), along_b(direction, b.pose, b.tame);
  for (const Point3& p : a.vertices) {
    if (along_a.compare(a.vertices[c.extreme_a], p) == Sign::positive) return CheckResult::not_extreme_in_a;
  }
  for (const Point3& p : b.vertices) {
    if (along_b.compare(b.vertices[c.extreme_b], p) == Sign::negative) return CheckResult::not_extreme_in_b;
  }
  return CheckResult::accepted;
}

CheckResult check(const CommonVertices& c, const PlacedVertices& a, const PlacedVertices& b) {
  const std::size_t n = std::size_t{c.count_a} + c.count_b;
  if (c.count_a == 0 || c.count_b == 0 || n > c.vertices.size()) return CheckResult::bad_index;
  std::array<Posed3, 5> points{};
  for (std::size_t i = 0; i < n; ++i) {
    const PlacedVertices& body = i < c.count_a ? a : b;
    if (c.vertices[i] >= body.vertices.size()) return CheckResult::bad_index;
    points[i] = body[c.vertices[i]];
  }
  const std::span<const Posed3> all(points.data(), n);
  return have_common_point(all.first(c.count_a), all.subspan(c.count_a)) ? CheckResult::accepted
                                                                         : CheckResult::no_common_point;
}

}  // namespace

std::string_view name_of(CheckResult result) {
  return name_in<CheckResult::no_common_point>(
      {"accepted", "bad index", "not extreme in a", "not extreme in b", "not strictly apart", "no common point"},
      result);
}

CheckResult check_absolutely(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b) {
  return std::visit([&](const auto& held) { return check(held, a, b); }, certificate);
}

}  // namespace sunder
