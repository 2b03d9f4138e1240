// Placed bodies with a radius in doubles: the first stage of predicate/disc/round_shape.h, where many directions and points
// are asked about one pair. Also called: floating-point filter; semi-static error bound.
//
// The image of a body is made once; then each question costs some ten nanoseconds, and is told surely or not at all.
// With u = 2^-53 let R be the size of a core: no product of an entry of the pose and a coordinate, and no number of the
// translation, is above R; and E that of what is around it: the radius, of an ellipsoid three times the greatest entry
// times the radius. Components of d are at most 1 in size.
//   - A component of an image sums terms of 4 R at most, with three roundings; of a combination of vertices there are 8
//     more. So a point is off by at most 65 u R, and P d, of at most 7 R |d|, by 45 u R |d|. A combination of images,
//     whose weights sum to 1 but for 8 u as sums of doubles tell, so but for 11 u, has 4 more of 4 R: off by 125 u R.
//   - The pose of a cylinder or cone is a rotation, as far as 2^-19: so its axis, of four roundings, is off by at most
//     7 u of its length, the axis of length 1 by 18 u; what is along it of a vector, and what is perpendicular, by 28 u
//     of the vector. The axis is at most 6.2 R long, so its length is off by 62 u R.
//   - |L^T d| of an ellipsoid is off by at most 22 u of the greatest entry times |d|. Whether a point is in one is
//     asked where it is a ball, through the adjoint: by the spectral norm, of 4.5 times the square of the greatest
//     entry, that is off by at most 563 u of the point's size where 640 u are paid.
// So reaches along d are off by at most 128 u (R + E), and distances, those to a slope aside, by 128 u (R + E + F),
// where F is the distance of the point; what is along a slope by 160 u, times the slope. 2^-45 is 256 u: it pays for
// the last sums and for computing the bound too. No formula overflows where sizes are at most 2^60, and what underflows
// is below 2^-440 where they are at least 2^-300; of hulls of more than two vertices, whose d is pulled back, also
// where the greatest entry of the pose is from 2^-500 to 2^500. Others are not tame: nothing is told of them.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/disc/round_kind.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <cstdint>

namespace sunder {

struct RoundImage {
  RoundKind kind = RoundKind::hull;
  bool is_tame = false;      // false: nothing is told of it
  std::uint32_t ends = 1;    // 1 or 2; of hulls of more than two vertices 0
  Vector3<double> from, to;  // images of the ends
  Vector3<double> axis;      // of two ends: the way between them; of cylinders and cones of length 1
  double length = 0;         // of cylinders and cones: of the axis
  double radius = 0;
  double size = 0;      // as above: the size of the core and that of the radius, together
  double greatest = 0;  // entry of the linear part of the pose, in size
  const Affine3* pose = nullptr;
  const double* all = nullptr;    // of more than two vertices, as SearchGraph keeps them: x of all, y, z
  std::uint32_t count = 0;        // of these, padded to a multiple of four
  const Point3* range = nullptr;  // of a box along the axes of its frame instead: its lowest corner and its highest
};

// An upper bound on the error of sums of such sizes.
inline constexpr double round_image_error = 0x1p-45;

// Of sizes that are tame, as above.
inline bool is_moderate_size(double size) { return size >= 0x1p-300 && size <= 0x1p60; }

// A hull of one or two points, a cylinder or cone of base and top, an ellipsoid about the origin. size: of the core, as
// above; greatest: entry of the linear part, in size. The pose has to stay; of cylinders and cones it is a rotation as
// far as 2^-19.
void set_image(RoundImage& image, RoundKind kind, const Affine3& pose, const Point3* points, std::uint32_t ends,
               double radius, double size, double greatest);

// A ball, whose centre is `at`, the image of a point.
inline RoundImage ball_image(const Vector3<double>& at, double radius, double size) {
  RoundImage image;
  image.is_tame = is_moderate_size(size + radius);
  image.from = at;
  image.radius = radius;
  image.size = size + radius;
  return image;
}

// A hull of more points.
void set_image(RoundImage& image, const Affine3& pose, const double* all, std::uint32_t count, double radius,
               double size, double greatest);

// A hull of the corners of a box along the axes of its frame: `range` holds the lowest and the highest, and stays.
void set_image(RoundImage& image, const Affine3& pose, const Point3* range, double radius, double size,
               double greatest);

// How far the body reaches along d.
double reach_along(const RoundImage& image, const Vector3<double>& d);

// positive, negative: the plane across the direction parts A from B strictly, or does not. The greatest component of d
// is 1 in size.
Guess gap_guess(const Vector3<double>& d, const RoundImage& a, const RoundImage& b);

// positive: the body, no hull, holds the point in its inside; negative: it does not hold it. size: of the core that the
// point is a combination of; 0 where it is the three doubles. A combination is meant over the sum of its weights: so
// these sum to 1 but for some roundings, and the point is made with the same.
Guess side_guess(const RoundImage& image, const Vector3<double>& x, double size = 0);

// positive: the points are nearer to each other than `reach`; negative: they are further apart. Each is a combination
// of vertices of a core, as above, or three doubles. size: of both cores and of the reach. negative: the way from p to
// q, in doubles, over its greatest component, is a direction along which they are further apart than that too; for it
// is off the way between the points themselves by 130 u of the sizes of the cores, and that is all it takes from the
// gap.
Guess nearness_guess(const Vector3<double>& p, const Vector3<double>& q, double reach, double size);

}  // namespace sunder
