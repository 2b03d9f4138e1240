#include <sunder/base/contract.h>
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/round/nearest_on_the_way.h>
#include <sunder/solid/round/round_methods.h>
#include <sunder/solid/round/round_nearest.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/round/round_round_sweep.h>
#include <sunder/solid/round/round_search.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

Exact vector(const std::array<Dyadic, 3>& v) { return {v[0], v[1], v[2]}; }
std::array<Dyadic, 3> numbers(const Exact& v) { return {v.x, v.y, v.z}; }

// What a translation adds from the begin to the end.
Exact way_of(const PlacedRound& begin, const PlacedRound& end) {
  const auto part = [&](std::size_t k) {
    return Dyadic(end.pose.affine().translation[k]) - Dyadic(begin.pose.affine().translation[k]);
  };
  return {part(0), part(1), part(2)};
}

// Where the body is then, rounded.
Pose pose_at(const Translation& of, double time) {
  const auto &from = of.begin().affine().translation, &to = of.end().affine().translation;
  const auto part = [&](std::size_t k) { return (1 - time) * from[k] + time * to[k]; };
  return Pose::from_matrix(of.begin().affine().linear, {part(0), part(1), part(2)});
}

// A direction of doubles, and how far it parts the bodies at the beginning and at the end, about, over its length.
struct Cut {
  Point3 direction{};
  double at_begin = 0, at_end = 0;

  double at(double time) const { return (1 - time) * at_begin + time * at_end; }
  double root() const { return at_begin / (at_begin - at_end); }
};

class RoundSweep {
 public:
  RoundSweep(const RoundBody& a, const Translation& of_a, const RoundBody& b, const Translation& of_b, bool cores_tell)
      : cores_tell_(cores_tell),
        of_a_(of_a),
        of_b_(of_b),
        a_(a, of_a.begin()),
        b_(b, of_b.begin()),
        to_a_(a, of_a.end()),
        to_b_(b, of_b.end()),
        way_a_(way_of(a_, to_a_)),
        way_b_(way_of(b_, to_b_)),
        path_(way_a_ - way_b_) {}

  SweepAnswer decide() {
    if (ends_decide() || cuts_decide()) {
      conclude(answer_, tally_.exact);
    } else {
      if (cores_tell_) hulls_decide();
      conclude(answer_, tally_.exact, true);
    }
    return std::move(answer_);
  }

  // The first time, from the contact that was found.
  RoundFirstContact first(const SweepContact& found) {
    double low = 0;
    for (int step = 0; step < 60; ++step) {
      const std::optional<Cut> cut = nearest_cut(low);
      if (!cut || !(cut->at_begin > cut->at_end)) break;
      const double root = cut->root();
      bool goes_on = false;
      for (const double part : {1 - 0x1p-50, 1 - 0x1p-46, 1 - 0x1p-40}) {
        const double time = root * part;
        if (!(time > low) || !is_parted_before(*cut, time)) continue;
        goes_on = time > low * (1 + 0x1p-50);
        low = time;
        break;
      }
      if (!goes_on) break;
    }
    for (double ahead = std::max(low * 0x1p-50, 0x1p-60); low + ahead < found.time.enclosure().low; ahead *= 4) {
      if (!meets_about(low + ahead) && !hulls_meet_at(low + ahead)) continue;
      return {{low, low + ahead}, *std::get<ContactOnTheWay>(answer_.evidence).contact};
    }
    SweepContact contact = found;
    contact.direction = {};
    const double high = found.time.enclosure().high;
    return {{std::min(low, high), high}, std::move(contact)};
  }

 private:
  void meet(const ExactFraction& time, CommonPoint point) {
    answer_.evidence = ContactOnTheWay{std::make_shared<const SweepContact>(SweepContact{time, std::move(point), {}})};
  }

  bool parts(const WorldDirection& d) {
    ++answer_.cost.proposals;
    for (const auto& [a, b] : {std::pair(&a_, &b_), std::pair(&to_a_, &to_b_)}) {
      const RoundGap gap(*a, *b, d, 0, 0, answer_.cost, tally_);
      if (gap.against(0) != Sign::positive) return false;
    }
    answer_.evidence = PartedOnTheWay{numbers(d.exact())};
    return true;
  }
  bool parts(Point3 direction) { return make_tame(direction) && parts(WorldDirection(direction)); }

  void count(const RoundAnswer& of) {
    answer_.cost.probes += of.cost.probes;
    answer_.cost.iterations += of.cost.iterations;
    answer_.cost.proposals += of.cost.proposals;
    tally_.exact += static_cast<std::uint32_t>(of.cost.exact);
  }

  // As round_round says of them, whose poses are exact; what it finds is tried all along.
  bool ends_decide() {
    const bool at_rest = of_a_.rests() && of_b_.rests();
    for (const bool at_end : {false, true}) {
      if (at_end && at_rest) break;
      const PlacedRound &a = at_end ? to_a_ : a_, &b = at_end ? to_b_ : b_;
      const RoundAnswer here = round_round(a, b);
      count(here);
      if (here.meet()) {
        CommonPoint point = common_point_of(a, b, here.evidence);
        meet({Dyadic(at_end ? 1.0 : 0.0)}, std::move(point));
        return true;
      }
      if (!here.undecided()) {
        if (parts(WorldDirection(vector(direction_of(a, b, here.evidence))))) return true;
        directions_[at_end] = near_direction(a, b, here.evidence);
      }
    }
    return at_rest;
  }

  // Where a point of a body is then that is here at the beginning; and the other way round.
  static ExactPoint3 after(const ExactPoint3& x, const Exact& way, const ExactFraction& time) {
    const Dyadic by = time.numerator * x.denominator;
    return exact_point(sum(times(time.denominator, x.numerators()), times(by, way)), x.denominator * time.denominator);
  }
  static ExactPoint3 before(const ExactPoint3& x, const Exact& way, const ExactFraction& time) {
    const Dyadic by = time.numerator * x.denominator;
    return exact_point(times(time.denominator, x.numerators()) - times(by, way), x.denominator * time.denominator);
  }

  // Do both hold, at that time, a point that is made as this one is, which is one of theirs about then?
  bool meets_at(const ExactFraction& time, const CommonPoint& near) {
    ++answer_.cost.proposals;
    ++tally_.exact;
    const auto core_a = core_point(a_, near.of_a.parts), core_b = core_point(b_, near.of_b.parts);
    std::vector<ExactPoint3> points;
    if (core_a && core_b) {
      const PointOf of_a{after(core_a->at, way_a_, time), {}}, of_b{after(core_b->at, way_b_, time), {}};
      points.push_back(point_between(of_a, a_.radius(), of_b, b_.radius()).at);
    } else {
      points.push_back(near.at);
      if (core_a) points.push_back(after(core_a->at, way_a_, time));
      if (core_b) points.push_back(after(core_b->at, way_b_, time));
    }
    for (const ExactPoint3& x : points) {
      const ExactPoint3 in_a = before(x, way_a_, time), in_b = before(x, way_b_, time);
      if (side_of(a_, in_a, near.of_a) == Sign::negative || side_of(b_, in_b, near.of_b) == Sign::negative) continue;
      CommonPoint point{x, made_by(a_, in_a, near.of_a), made_by(b_, in_b, near.of_b)};
      meet(time, std::move(point));
      return true;
    }
    return false;
  }

  // Do they meet at that time, as poses say that are rounded, and then exactly?
  bool meets_about(double time) {
    const Pose at_a = pose_at(of_a_, time), at_b = pose_at(of_b_, time);
    for (const bool shrinks : {false, true}) {
      const RoundBody of_a = shrinks ? smaller(a_.body) : a_.body, of_b = shrinks ? smaller(b_.body) : b_.body;
      const PlacedRound a(of_a, at_a), b(of_b, at_b);
      const RoundAnswer here = round_round(a, b);
      count(here);
      is_undecided_ = here.undecided();
      if (here.meet()) found_.reset();
      if (here.verdict() == Verdict::apart) found_ = near_direction(a, b, here.evidence);
      if (!here.meet()) return false;
      if (meets_at({Dyadic(time)}, common_point_of(a, b, here.evidence))) return true;
    }
    return false;
  }

  std::optional<Cut> cut_of(const Point3& direction) {
    const double length = std::hypot(direction.x, direction.y, direction.z);
    const Point3 d{direction.x / length, direction.y / length, direction.z / length};
    if (!std::isfinite(d.x + d.y + d.z)) return std::nullopt;
    const auto gap = [&](const PlacedRound& a, const PlacedRound& b) {
      RoundSearch<DoubleDouble> search(a, b);
      search.direction = {d.x, d.y, d.z};
      const DoubleDouble all = dot(search.direction, search.direction);
      const DoubleDouble far =
          search.gap_at(search.probe(answer_.cost)) - search.support.reach * round_detail::root_of(all);
      return nearest(far) / search.simplex.scale;
    };
    const Cut cut{d, gap(a_, b_), gap(to_a_, to_b_)};
    if (!std::isfinite(cut.at_begin) || !std::isfinite(cut.at_end)) return std::nullopt;
    return cut;
  }

  // Across the shortest way between them at that time. Nothing where they are not apart, as far as this tells.
  std::optional<Cut> nearest_cut(double time) {
    const PlacedRound a(a_.body, pose_at(of_a_, time)), b(b_.body, pose_at(of_b_, time));
    RoundSearch<DoubleDouble> search(a, b);
    search.begin({});
    search.run({round_steps<DoubleDouble>}, answer_.cost);
    const std::optional<Cut> cut = cut_of(rounded(search.direction));
    return cut && cut->at(time) > 0 ? cut : std::nullopt;
  }

  // The cut that rules out times up to the latest one, and the cut that rules out those from the earliest one on.
  // Between, they are asked about.
  bool cuts_decide() {
    std::optional<Cut> first, last;
    const auto take = [&](const std::optional<Cut>& cut) {
      if (!cut) return;
      const bool falls = cut->at_begin > cut->at_end;
      if (falls && cut->at_begin > 0 && (!first || cut->root() > first->root())) first = cut;
      if (!falls && cut->at_end > 0 && (!last || cut->root() < last->root())) last = cut;
    };
    for (const bool at_end : {false, true}) {
      if (!directions_[at_end]) continue;
      const std::optional<Cut> near = nearest_cut(at_end ? 1 : 0);
      if (near && parts(near->direction)) return true;
      take(cut_of(*directions_[at_end]));
      take(near);
    }
    double tried = -1;
    for (int step = 0; step < 60; ++step) {
      if (first && last && mixture_parts(*first, *last)) return true;
      const double low = first ? first->root() : 0, high = last ? last->root() : 1;
      if (!(low <= high)) return false;
      double time = low + (high - low) / 2;
      if (first && last && step % 2 == 0) {  // where the two are equal
        const double fall = first->at_begin - first->at_end, rise = last->at_end - last->at_begin;
        time = std::clamp((first->at_begin - last->at_begin) / (fall + rise), low, high);
      }
      if (time == tried || !(time >= 0 && time <= 1)) return false;
      tried = time;
      if (meets_about(time)) return true;
      if (is_undecided_) return false;
      const std::optional<Cut> near = nearest_cut(time), other = found_ ? cut_of(*found_) : std::nullopt;
      for (const auto& cut : {near, other}) {
        if (!cut || !(cut->at(time) > 0)) continue;
        if (cut->at_begin > 0 && cut->at_end > 0 && parts(cut->direction)) return true;
        take(cut);
      }
    }
    return false;
  }

  // Of a direction whose gap falls with time and one whose gap rises: the sum of so much of each that it does neither.
  bool mixture_parts(const Cut& falls, const Cut& rises) {
    const auto exact = [](const Point3& d) { return Exact{Dyadic(d.x), Dyadic(d.y), Dyadic(d.z)}; };
    const Exact d = exact(falls.direction), e = exact(rises.direction);
    const Dyadic of_d = dot(path_, d), of_e = dot(path_, e);
    if (of_d.sign() != Sign::positive || of_e.sign() != Sign::negative) return false;
    if (!(falls.root() > rises.root() - 0x1p-40)) return false;
    const Exact mixed = sum(times(-of_e, d), times(of_d, e));
    if (mixed.x.sign() == Sign::zero && mixed.y.sign() == Sign::zero && mixed.z.sign() == Sign::zero) return false;
    return parts(WorldDirection(mixed));
  }

  // Are they apart at all times before this one, as along the direction? Exact: at the beginning the gap along it is at
  // least as long as what of the path goes along it until then.
  bool is_parted_before(const Cut& cut, double time) {
    Point3 direction = cut.direction;
    if (!make_tame(direction)) return false;
    const WorldDirection d(direction);
    const Exact exact = d.exact();
    const Dyadic far = Dyadic(time) * dot(path_, exact), square = dot(exact, exact);
    if (far.sign() != Sign::positive) return false;
    const double least = far.nearest() / std::hypot(direction.x, direction.y, direction.z) * (1 + 0x1p-51);
    if (!std::isfinite(least)) return false;
    if ((Dyadic(least) * Dyadic(least) * square - far * far).sign() == Sign::negative) return false;
    return RoundGap(a_, b_, d, 0, 0, answer_.cost, tally_).against(least) != Sign::negative;
  }

  // Exactly: the cores' nearest points on their ways against both radii.
  void hulls_decide() {
    const auto nearest = nearest_on_the_way(a_.core, b_.core, Exact{}, path_, answer_.cost, tally_);
    if (!nearest) return cores_meet();
    if (!are_within_reach(*nearest)) {
      answer_.evidence = PartedOnTheWay{numbers(times(Dyadic(-1.0), nearest->way.way))};
      return;
    }
    const bool held = meets_at({nearest->at_end, nearest->way.denominator}, made_at(*nearest));
    SUNDER_REQUIRE(held);
    (void)held;
  }

  // Exactly: the same at one time. Not where the cores themselves meet then.
  bool hulls_meet_at(double time) {
    if (!cores_tell_) return false;
    const Exact then = times(Dyadic(time), path_);
    const auto nearest = nearest_on_the_way(a_.core, b_.core, then, then, answer_.cost, tally_);
    return nearest && are_within_reach(*nearest) && meets_at({Dyadic(time)}, made_at(*nearest));
  }

  bool are_within_reach(const NearestOnTheWay& nearest) const {
    const Dyadic far = Dyadic(a_.radius()) + Dyadic(b_.radius());
    return (nearest.way.squared() - far * far * nearest.way.denominator).sign() != Sign::positive;
  }

  // How the cores make the two points; where these are is not filled in.
  static CommonPoint made_at(const NearestOnTheWay& nearest) { return {{}, nearest.of_a, nearest.of_b}; }

  void cores_meet() {
    const SweepAnswer cores = polyhedron_polyhedron_sweep(a_.body.core(), of_a_, b_.body.core(), of_b_);
    if (const auto* contact = std::get_if<ContactOnTheWay>(&cores.evidence)) {
      answer_.evidence = *contact;
      return;
    }
    const auto first = polyhedron_polyhedron_first_contact(a_.body.core(), of_a_, b_.body.core(), of_b_);
    SUNDER_REQUIRE(first.has_value());
    answer_.evidence = ContactOnTheWay{std::make_shared<const SweepContact>(*first)};
  }

  bool cores_tell_;  // of hulls: the nearest points of their cores decide
  const Translation &of_a_, &of_b_;
  const PlacedRound a_, b_, to_a_, to_b_;            // at the beginning, and at the end
  const Exact way_a_, way_b_, path_;                 // what each adds, and A's as seen from B
  std::array<std::optional<Point3>, 2> directions_;  // that part them at the beginning and at the end
  std::optional<Point3> found_;                      // of the last question at a time between
  bool is_undecided_ = false;
  SweepAnswer answer_;
  StageTally tally_;
};

}  // namespace

SweepAnswer sweep_searched(const RoundBody& a, const Translation& of_a, const RoundBody& b, const Translation& of_b,
                           bool cores_tell) {
  return RoundSweep(a, of_a, b, of_b, cores_tell).decide();
}

RoundFirstContact first_contact_searched(const RoundBody& a, const Translation& of_a, const RoundBody& b,
                                         const Translation& of_b, bool cores_tell, const SweepContact& contact) {
  return RoundSweep(a, of_a, b, of_b, cores_tell).first(contact);
}

std::array<Dyadic, 3> direction_of(const RoundBody& a, const Translation& of_a,  //
                                   const RoundBody& b, const Translation& of_b, const SweepAnswer& answer) {
  if (const auto* parted = std::get_if<PartedOnTheWay>(&answer.evidence)) return parted->direction;
  return parting_direction(answer, a.core(), of_a, b.core(), of_b);
}

SweepContact contact_of(const RoundBody& a, const Translation& of_a,  //
                        const RoundBody& b, const Translation& of_b, const SweepAnswer& answer) {
  if (const auto* on_the_way = std::get_if<ContactOnTheWay>(&answer.evidence)) return *on_the_way->contact;
  const auto& [common, is_at_end] = std::get<CommonVerticesAtAnEnd>(answer.evidence);
  const PlacedRound in_a(a, is_at_end ? of_a.end() : of_a.begin()), in_b(b, is_at_end ? of_b.end() : of_b.begin());
  return {{Dyadic(is_at_end ? 1.0 : 0.0)}, common_point(common, in_a.core, in_b.core), {}};
}

void add_claims(PairClaims& pairs, const ClaimedMotion& bodies, const RoundBody& a, const Translation& of_a,
                const RoundBody& b, const Translation& of_b, const SweepAnswer& answer) {
  SUNDER_REQUIRE(!answer.undecided());
  if (!answer.meet()) {
    return pairs.add_motion_apart(bodies.a, bodies.b, bodies.to_a, bodies.to_b, direction_of(a, of_a, b, of_b, answer));
  }
  const SweepContact contact = contact_of(a, of_a, b, of_b, answer);
  pairs.add_motion_meet(bodies.a, bodies.b, bodies.to_a, bodies.to_b, contact.time, contact.point);
}

void add_claims(PairClaims& pairs, const ClaimedMotion& bodies, const RoundFirstContact& first) {
  const auto& [time, point, along] = first.contact;
  const bool is_proved =
      std::any_of(along.begin(), along.end(), [](const Dyadic& x) { return x.sign() != Sign::zero; });
  const auto [a, b, to_a, to_b] = bodies;
  pairs.add_motion_meet(a, b, to_a, to_b, time, point, is_proved ? &along : nullptr);
}

}  // namespace sunder::solid
