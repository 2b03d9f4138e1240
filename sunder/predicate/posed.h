// A point under a pose, without computing its image: predicates decide about the exact image.
#pragma once

#include <sunder/number/rounded.h>
#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace sunder {

// How often which stage decided (see predicate/filter/stages.h). Predicates add to it where one is given.
struct StageTally {
  std::uint32_t rounded = 0;  // floating point with an error bound
  std::uint32_t interval = 0;
  std::uint32_t exact = 0;
};

// The sign that a stage has decided on: counted(&StageTally::exact, tally, sign).
inline Sign counted(std::uint32_t StageTally::* stage, StageTally* tally, Sign sign) {
  if (tally) ++(tally->*stage);
  return sign;
}

// The sizes of some numbers: the least and the greatest absolute value of those that are not zero.
struct SizeRange {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0;

  void include(double x) {
    const double size = std::fabs(x);
    if (size == 0) return;
    least = std::min(least, size);
    greatest = std::max(greatest, size);
  }
};

inline SizeRange size_range(std::span<const double> numbers) {
  SizeRange range;
  for (const double x : numbers) range.include(x);
  return range;
}

inline SizeRange size_range(std::span<const Point3> points) {
  SizeRange range;
  for (const Point3& p : points) {
    range.include(p.x);
    range.include(p.y);
    range.include(p.z);
  }
  return range;
}

// True when floating point neither overflows nor underflows in formulas of up to three factors over images of such
// points, and in the products direction . matrix . difference of predicate/point/along.h. Only products can underflow.
// Rounded, a product of a matrix entry and a coordinate is zero or in [2^-200, 2^250], a multiple of 2^-252. A number
// of the translation is a multiple of 2^-302. So images and their differences are multiples of 2^-302 below 2^253, and
// a product of three of them is a multiple of 2^-906 below 2^762. A matrix entry times a component of a tame direction,
// zero or in [2^-60, 1], is zero or at least 2^-960. With m and x the least entry and coordinate, sums of these are
// zero or at least m 2^-113, differences of coordinates zero or at least x 2^-53: so their product is zero or at least
// 2^-366.
inline bool images_are_tame(const SizeRange& linear, const SizeRange& translation, const SizeRange& points) {
  const double least = linear.least * points.least;  // an underflow gives 0: not tame; no number at all: infinity
  const double greatest = linear.greatest * points.greatest;
  return least >= 0x1p-200 && greatest <= 0x1p250 && linear.least >= 0x1p-900 &&  //
         translation.least >= 0x1p-250 && translation.greatest <= 0x1p250;
}

// True when Along::turn (predicate/point/along.h) neither overflows nor underflows for such points, where images are tame.
// Let all numbers be zero or in [2^-80, 2^80]. Entries times components of a tame direction are multiples of 2^-244,
// and differences of coordinates of 2^-132: so a product of direction and difference is a multiple of 2^-376 below
// 2^165, one of a tame m and a difference of 2^-244 below 2^85, and all stays a multiple of 2^-620.
inline bool turns_are_tame(const SizeRange& linear, const SizeRange& points) {
  const auto is_ordinary = [](const SizeRange& range) {
    return range.greatest == 0 || (range.least >= 0x1p-80 && range.greatest <= 0x1p80);
  };
  return is_ordinary(linear) && is_ordinary(points);
}

// The image of `point` under `pose`. tame: as decided by images_are_tame for these numbers (false is always allowed,
// and costs time only).
template <std::size_t D>
struct Posed;

template <>
struct Posed<3> {
  Point3 point;
  const Affine3* pose;
  bool tame;
  // No product of an entry of the linear part and a coordinate, rounded, and no number of the translation is larger in
  // size. Infinite where that is not known; it costs time only. Used where the image is tame.
  double reach = std::numeric_limits<double>::infinity();
};

template <>
struct Posed<2> {
  Point2 point;
  const Affine2* pose;
  bool tame;
  // No coordinate of the image, computed as (m0 x + m1 y) + t, is further than this from the exact one. Infinite where
  // that is not known or the image is not tame; it costs time only.
  double error = std::numeric_limits<double>::infinity();

  Point2 rounded_image() const {
    const auto& [m, t] = *pose;
    return {(m[0] * point.x + m[1] * point.y) + t[0], (m[2] * point.x + m[3] * point.y) + t[1]};
  }
};

using Posed2 = Posed<2>;
using Posed3 = Posed<3>;

// The error of images (Posed2) of points whose coordinates are at most `coordinates` in size: three roundings, of sums
// of at most 2 linear coordinates + translation; one more pays for computing the bound.
inline double image_error(const SizeRange& linear, const SizeRange& translation, double coordinates) {
  return Rounded<4>::bound * (2 * (linear.greatest * coordinates) + translation.greatest);
}

// A convenience where speed does not matter: finds out by itself whether the image is tame, and its reach.
inline Posed3 posed(const Point3& point, const Affine3& pose) {
  const SizeRange linear = size_range(std::span<const double>(pose.linear)),
                  translation = size_range(std::span<const double>(pose.translation)),
                  coordinates = size_range({&point, 1});
  return {point, &pose, images_are_tame(linear, translation, coordinates),
          std::max(linear.greatest * coordinates.greatest, translation.greatest)};
}

}  // namespace sunder
