// Points and directions that are proposed about a pair of bodies with a radius, in doubles, and what floating point
// with an error bound makes of them. For the sources of solid/round.
#pragma once

#include <sunder/solid/round/round_pieces.h>
#include <sunder/solid/round/round_round.h>

#include <cmath>
#include <cstdint>
#include <optional>

namespace sunder::solid::round_quick {

// A ball and a ball, a box or a cylinder, in closed form. True: decided, surely, and the answer's evidence is filled in;
// nothing of others. `way`: from A to B, about, or as it was.
std::optional<bool> decide_of_ball(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                                   RoundAnswer& answer, Point3& way);

// The direction parts A from B, surely.
bool parts(const V& direction, const RoundImage& a, const RoundImage& b, RoundAnswer& answer, Point3& way);

inline V across(const V& v, const V& axis) { return sum(v, -dot(v, axis) / dot(axis, axis), axis); }

// Keeps references to all that it is made with. True: decided, surely, and the answer's evidence is filled in.
class Proposals {
 public:
  Proposals(const Side& of_a, const Side& of_b, RoundAnswer& answer, Point3& way)
      : a(of_a), b(of_b), size(of_a.image.size + of_b.image.size), answer_(answer), way_(way) {}

  const Side& a;
  const Side& b;
  const double size;  // of both

  RoundAnswer& answer() { return answer_; }
  std::uint32_t exact() const { return tally_.exact; }  // signs that took more than doubles

  // The direction, from A to B, parts them.
  bool parts(const V& direction) { return round_quick::parts(direction, a.image, b.image, answer_, way_); }
  // Do p of the core of A and q of that of B, which are nearest to each other or deepest in the other body, lead to a
  // common point? Thoroughly: more than doubles tell is asked for.
  bool holds(const Nearest& p, const Nearest& q);
  bool holds_thoroughly(const Nearest& p, const Nearest& q);
  // Of a ball or a capsule, and a body whose nearest points are known in closed form; nothing of others.
  std::optional<bool> by_nearest_points();
  // p of the core of `own`, a ball or a capsule, and q of the other's are nearest to each other.
  bool settles(const Side& own, const Nearest& p, const Side& other, const Nearest& q);
  // Does the point of `own` that is nearest to the other's middle lie in the other?
  bool meets_near(const Side& own, const Side& other, const V& middle);
  // Is it the base or the top, flat, that faces the other? d: about, from `own` on, of length 1.
  bool faces(const Side& own, const Side& other, const V& d);
  // From body to body, and a little further than to the surface: where they overlap this comes to a common point, even
  // where sharp edges leave little room. Source: the method of alternating projections, Bregman 1965.
  bool alternates(V x);

  // One more vertex of a hull, or point of a curved body, in what makes a point.
  static void add(const Side& side, Nearest& made, const Far& far, double weight);

 private:
  // A ball that moves along the axis: its distance is convex. Where it is least: by the false position, as Illinois
  // has it. Source: Dowell and Jarratt 1971.
  bool capsule(const Side& own, const Side& other);
  // Is the point in doubles that of the combination, whose weights are over their sum? (round_image.h)
  static bool is_whole(const Nearest& p);
  bool holds(const V& x);
  bool is_inside(const Side& side, const V& x);
  bool holds(const Side& hull, const Nearest& p, const Side& curved, const Nearest& q);
  bool holds_core(const Side& hull, const Nearest& p, const Side& curved);  // a point of its core in the curved body
  template <class Evidence>
  bool is(const Evidence& evidence) {
    answer_.evidence = evidence;
    return true;
  }

  RoundAnswer& answer_;
  Point3& way_;
  StageTally tally_;
  bool is_thorough_ = false;
};

inline bool Proposals::is_whole(const Nearest& p) {
  double total = 0;
  for (std::size_t k = 0; k < p.made.count(); ++k) total += p.made.weights[k];
  return std::fabs(total - 1) <= 0x1p-50;
}

inline bool Proposals::settles(const Side& own, const Nearest& p, const Side& other, const Nearest& q) {
  V way = q.at - p.at;
  const double far2 = dot(way, way), reach = own.radius() + other.radius();
  if (far2 > reach * reach) {
    // Within the axis of a capsule the way is perpendicular to it.
    if (own.is_capsule() && p.made.count() == 2) way = across(way, own.image.axis);
    if (other.is_capsule() && q.made.count() == 2) way = across(way, other.image.axis);
    return parts(&own == &a ? way : V{-way.x, -way.y, -way.z});
  }
  ++answer_.cost.proposals;
  if (!is_whole(p) || (!other.is_curved() && !is_whole(q))) return false;
  const RoundCombination &of_a = &own == &a ? p.made : q.made, &of_b = &own == &a ? q.made : p.made;
  if (!other.is_curved()) {
    return nearness_guess(p.at, q.at, reach, size) == Guess::positive && is(PointBetweenCores{of_a, of_b});
  }
  if (far2 == 0 && holds_core(own, p, other)) return true;
  // From the point of the other body's surface inwards, by half of what is left over.
  const V inwards = other.middle() - q.at;
  const double slack = reach - std::sqrt(far2), deep = length(inwards);
  const V x = sum(q.at, slack < deep ? 0.5 * slack / deep : 0.5, inwards);
  return side_guess(other.image, x) == Guess::positive &&
         nearness_guess(p.at, x, reach, own.image.size) == Guess::positive && is(PointInDoubles{point(x), of_a, of_b});
}

}  // namespace sunder::solid::round_quick
