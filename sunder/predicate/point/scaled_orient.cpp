#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/predicate/point/scaled_orient.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sunder {

namespace {

using ThreeDifferences = std::array<Vector3<double>, 3>;

// Each axis and each difference times a power of two, after which all numbers are below 2.
void scale(ThreeDifferences& rows) {
  constexpr int none = -4000;  // below all sums of two exponents
  const auto exponent = [](double x) {
    return x == 0 ? none : static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) - 1023;
  };
  const auto scaled = [](double x, int shift) {  // once rounded where it becomes subnormal, or twice
    const auto power = [](int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52); };
    const int half = std::clamp(shift, -2040, 2040) / 2;
    return x * power(half) * power(std::clamp(shift, -2040, 2040) - half);
  };
  Vector3<int> column{none, none, none};
  for (const auto& row : rows) {
    column.x = std::max(column.x, exponent(row.x));
    column.y = std::max(column.y, exponent(row.y));
    column.z = std::max(column.z, exponent(row.z));
  }
  for (auto& row : rows) {
    const int greatest = std::max({exponent(row.x) - column.x, exponent(row.y) - column.y, exponent(row.z) - column.z});
    row = {scaled(row.x, -column.x - greatest), scaled(row.y, -column.y - greatest),
           scaled(row.z, -column.z - greatest)};
  }
}

// orient_3d(origin, p, q, r), unless floating point is unsure. The differences are doubles with one rounding each.
// Where they need it they are scaled to less than 2, by which each is off by 2^-1074 at most. A product of three such
// numbers, which underflows by 2^-1073 at most, is off by less than 2^-1069, and the six by less than 2^-1060.
Guess scaled_orient_from(const Point3& origin, const Point3& p, const Point3& q, const Point3& r) {
  const auto minus_origin = [&](const Point3& a) {
    return Vector3<double>{a.x - origin.x, a.y - origin.y, a.z - origin.z};
  };
  ThreeDifferences rows{minus_origin(p), minus_origin(q), minus_origin(r)};
  SizeRange sizes;
  for (const auto& row : rows) {
    sizes.include(row.x);
    sizes.include(row.y);
    sizes.include(row.z);
  }
  if (!(sizes.greatest <= std::numeric_limits<double>::max())) return Guess::unsure;
  if (sizes.least < 0x1p-300 || sizes.greatest > 0x1p300) scale(rows);
  const auto rounded = [](const Vector3<double>& v) {
    const auto once = [](double x) { return Rounded<1>{x, std::fabs(x)}; };
    return Vector3<Rounded<1>>{once(v.x), once(v.y), once(v.z)};
  };
  const auto height = dot(cross(rounded(rows[0]), rounded(rows[1])), rounded(rows[2]));
  const double error = height.bound * height.magnitude + 0x1p-1060;
  return height.value > error ? Guess::positive : height.value < -error ? Guess::negative : Guess::unsure;
}

}  // namespace

Guess scaled_orient_3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  // Even permutations. Where three of the points are near to each other, one of those is the origin that tells.
  Guess guess = scaled_orient_from(a, b, c, d);
  if (!is_sure(guess)) guess = scaled_orient_from(d, c, b, a);
  if (!is_sure(guess)) guess = scaled_orient_from(c, d, a, b);
  if (!is_sure(guess)) guess = scaled_orient_from(b, a, d, c);
  return guess;
}

Sign orient_3d_of_any_size(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Guess guess = scaled_orient_3d(a, b, c, d);
  return is_sure(guess) ? to_sign(guess) : orient_3d(a, b, c, d);
}

}  // namespace sunder
