// A plane of the world as a placed mesh sees it: on which side are its points, and all that a box of its tree holds?
// Also called: static filter; plane-box test.
#pragma once

#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/exact_plane.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sunder::solid {

// The plane n . x = d of the frame of the mesh, whose numbers are exact, and are rounded to doubles N and D that are off by
// one unit in the last place. So no image of a point is made, rounded or exact.
// Points: N . p - D in floating point is off by at most 2^-52 s, from the roundings of n and d, and 2^-51 s, from one product
// and three sums, up to the squares of these; s: what |N| . |p| + |D| is at most in the box of the mesh. Underflow takes at
// most 2^-1075 from a product, and 2^-1074 from a number of n or d. 2^-49 s + 2^-1070 (1 + |p|) is more than all of that,
// and than the roundings of s. Nothing is rounded where N is along an axis, of length 1, and N and D are exact: a product
// with 1 or 0 is exact, and the sign of a difference of two doubles is that of the rounded one.
// Boxes: a point of a box is its middle and at most `half` along each axis, which are of length 1 and across each other up to
// parts in 2^20: so it goes no further along N than |N . axis| half, summed, and 2^-17 of |N| times the sum of the halves,
// which counts the roundings of that as well. The middle is off by no more than a point is whose coordinates are as large as
// those of the middle of all and 16 units of the tree together, with some more roundings: 2^-47.
// Where a number is beyond the doubles, nothing is sure.
class PlacedPlane {
 public:
  // `seen`: the plane in the frame of the mesh (ExactPlane::seen_from).
  PlacedPlane(ExactPlane seen, const PlacedMesh& placed) : seen_(std::move(seen)), tree_(placed.mesh().tree()) {
    const Vector3<Interval>& n = seen_.normal_about;
    normal_ = {n.x.low, n.y.low, n.z.low};
    offset_ = seen_.offset_about.low;
    const Box3& box = placed.mesh().box();
    Point3 most, most_of_boxes;
    for (std::size_t c = 0; c < 3; ++c) {
      most[c] = std::max(std::fabs(box.low[c]), std::fabs(box.high[c]));
      most_of_boxes[c] = std::fabs(tree_.middle()[c]) + 16 * tree_.unit();
    }
    error_ = is_exact() ? 0 : 0x1p-49 * size_at(most) + 0x1p-1070 * (1 + most.x + most.y + most.z);
    box_error_ =
        0x1p-47 * size_at(most_of_boxes) + 0x1p-1070 * (1 + most_of_boxes.x + most_of_boxes.y + most_of_boxes.z);
  }

  // positive: above. Of a point in the box of the mesh, in its frame. Exact.
  Sign side_of(const Point3& p, StageTally* tally) const {
    const double height = dot(normal_, p) - offset_;
    if (height > error_) return counted(&StageTally::rounded, tally, Sign::positive);
    if (height < -error_) return counted(&StageTally::rounded, tally, Sign::negative);
    if (error_ == 0 && height == 0) return counted(&StageTally::rounded, tally, Sign::zero);
    return counted(&StageTally::exact, tally, (dot(seen_.normal, coordinates<Dyadic>(p)) - seen_.offset).sign());
  }

  // positive: all of the box of a node is above; negative: below; else unsure.
  Guess side_of(const OrientedBox& box) const {
    const std::array<std::array<float, 4>, 3> rows{box.x, box.y, box.z};
    double middle = 0, reach = 0, halves = 0;
    for (std::size_t c = 0; c < 3; ++c) middle += normal_[c] * static_cast<double>(rows[c][3]);
    for (std::size_t k = 0; k < 3; ++k) {
      double along = 0;
      for (std::size_t c = 0; c < 3; ++c) along += normal_[c] * static_cast<double>(rows[c][k]);
      reach += std::fabs(along) * static_cast<double>(box.half[k]);
      halves += static_cast<double>(box.half[k]);
    }
    reach += 0x1p-17 * halves * (std::fabs(normal_.x) + std::fabs(normal_.y) + std::fabs(normal_.z));
    const double height = dot(normal_, tree_.middle()) + tree_.unit() * middle - offset_,
                 most = tree_.unit() * std::fabs(reach) + box_error_;
    return height > most ? Guess::positive : height < -most ? Guess::negative : Guess::unsure;
  }

 private:
  double size_at(const Point3& p) const {
    return std::fabs(normal_.x) * p.x + std::fabs(normal_.y) * p.y + std::fabs(normal_.z) * p.z + std::fabs(offset_);
  }
  bool is_exact() const {
    const Vector3<Interval>& n = seen_.normal_about;
    int ones = 0, zeros = 0;
    for (const Interval* x : {&n.x, &n.y, &n.z}) {
      ones += x->low == x->high && std::fabs(x->low) == 1;
      zeros += x->low == 0 && x->high == 0;
    }
    return ones == 1 && zeros == 2 && seen_.offset_about.low == seen_.offset_about.high && std::isfinite(offset_);
  }

  ExactPlane seen_;
  const MeshTree& tree_;
  Point3 normal_;
  double offset_ = 0, error_ = 0, box_error_ = 0;
};

}  // namespace sunder::solid
