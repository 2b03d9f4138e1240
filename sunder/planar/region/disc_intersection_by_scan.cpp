// The oracle: every crossing of two circles against all discs.
//
// Where a circle bounds the common part by more than points, its arcs there are between points that are in all discs
// and on another circle. From such a point on, counter-clockwise, the circle stays in all discs up to the next one, or
// leaves one of them at once. It stays in disc k where the point is inside of k; where the circles do not cross and the
// disc is in k; and where they cross and the point is the one at which the circle enters k.
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/predicate/disc/disc_powers.h>
#include <sunder/predicate/disc/discs.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>

namespace sunder::planar {

namespace {

class DiscScan {
 public:
  explicit DiscScan(const Discs& circles) : circles_(circles) {}

  DiscIntersection run() {
    if (circles_.size() == 0) return out_;
    name_deepest();
    if (!find_inner_disc()) {
      for (std::uint32_t i = 0; i < circles_.size(); ++i) find_arcs_of(i);
      out_.kind = !arcs_.empty() ? DiscIntersectionKind::region
                  : has_point_   ? DiscIntersectionKind::point
                                 : DiscIntersectionKind::empty;
      if (!arcs_.empty()) link();
    }
    out_.cost.exact = tally_.exact;
    return out_;
  }

 private:
  // Of circle `disc`, from one point of the common part to another.
  struct Arc {
    std::uint32_t disc;
    DiscCrossing begin, end;
  };

  Disc disc(std::uint32_t i) const { return circles_[i]; }
  std::uint32_t size() const { return circles_.size(); }

  // Any discs that name the deepest point: those whose weights are not negative, and no other one has a greater power.
  void name_deepest() {
    const auto names = [&](std::initializer_list<std::uint32_t> discs) {
      DeepestPoint& deepest = out_.deepest;
      deepest.count = static_cast<std::uint32_t>(discs.size());
      std::copy(discs.begin(), discs.end(), deepest.discs.begin());
      const DiscBasis basis = discs_of(circles_.all(), deepest.basis());
      for (std::uint32_t k = 0; k < size(); ++k) {
        ++out_.cost.probes;
        if (power_against(basis, disc(k), &tally_) == Sign::positive) return false;
      }
      const DeepestWeights weights = deepest_weights(basis);
      if (std::any_of(weights.numerators.begin(), weights.numerators.end(),
                      [](const Dyadic& w) { return w.sign() == Sign::negative; })) {
        return false;
      }
      deepest.power = deepest_power(basis, &tally_);
      return true;
    };
    for (std::uint32_t i = 0; i < size(); ++i) {
      if (names({i})) return;
    }
    for (std::uint32_t i = 0; i < size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        if (circles_[i].center != circles_[j].center && names({i, j})) return;
      }
    }
    for (std::uint32_t i = 0; i < size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        for (std::uint32_t l = 0; l < j; ++l) {
          const bool on_line = orient_2d(circles_[i].center, circles_[j].center, circles_[l].center) == Sign::zero;
          if (!on_line && names({i, j, l})) return;
        }
      }
    }
  }

  // Is disc i in disc k?
  bool is_in(std::uint32_t i, std::uint32_t k) {
    const Disc &a = circles_[i], &b = circles_[k];
    ++out_.cost.probes;
    return a.radius <= b.radius &&
           distance_against_difference(a.center, a.radius, b.center, b.radius, &tally_) != Sign::positive;
  }

  bool find_inner_disc() {
    for (std::uint32_t i = 0; i < size(); ++i) {
      bool is_inner = true;
      for (std::uint32_t k = 0; k < size() && is_inner; ++k) is_inner = is_in(i, k);
      if (!is_inner) continue;
      out_.kind = circles_[i].radius > 0 ? DiscIntersectionKind::region : DiscIntersectionKind::point;
      if (circles_[i].radius > 0) out_.arcs = {i};
      return true;
    }
    return false;
  }

  bool is_in_all(const DiscCrossing& p) {
    for (std::uint32_t k = 0; k < size(); ++k) {
      ++out_.cost.probes;
      if (disc(k) != p.a && disc(k) != p.b && side_of_disc(p, disc(k), &tally_) == Sign::negative) return false;
    }
    return true;
  }

  bool is_on(const DiscCrossing& p, const Disc& k) {
    return k == p.a || k == p.b || side_of_disc(p, k, &tally_) == Sign::zero;
  }

  // Does circle i, from its point p on, stay in disc k? Requires that p is in it.
  bool stays_in(std::uint32_t i, const DiscCrossing& p, std::uint32_t k) {
    ++out_.cost.probes;
    if (circles_[i] == circles_[k] || !is_on(p, disc(k))) return true;
    if (!circles_cross(disc(i), disc(k), &tally_)) return is_in(i, k);
    return orient_2d(circles_[k].center, circles_[i].center, p, &tally_) == Sign::positive;
  }

  // The points of circle i that are in all discs and on another circle, counter-clockwise, each once.
  std::vector<DiscCrossing> points_on(std::uint32_t i) {
    struct Point {
      DiscCrossing at;
      Bearing bearing;
    };
    std::vector<Point> points;
    const Disc& a = circles_[i];
    const Viewpoint center = viewpoint(a.center);
    for (std::uint32_t k = 0; k < size(); ++k) {
      const Disc& b = circles_[k];
      if (a.center == b.center ||
          distance_against_sum(a.center, a.radius, b.center, b.radius, &tally_) == Sign::positive ||
          distance_against_difference(a.center, a.radius, b.center, b.radius, &tally_) == Sign::negative) {
        continue;
      }
      for (const DiscCrossing& p : {DiscCrossing{disc(i), disc(k)}, DiscCrossing{disc(k), disc(i)}}) {
        if (!is_in_all(p)) continue;
        has_point_ = true;
        if (a.radius > 0) points.push_back({p, bearing(p, center, &tally_)});
      }
    }
    const auto order = [&](const Point& p, const Point& q) {
      return compare_bearings(p.at, p.bearing, q.at, q.bearing, center, &tally_);
    };
    std::sort(points.begin(), points.end(),
              [&](const Point& p, const Point& q) { return order(p, q) == Sign::negative; });
    std::vector<DiscCrossing> out;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (k == 0 || order(points[k - 1], points[k]) != Sign::zero) out.push_back(points[k].at);
    }
    return out;
  }

  void find_arcs_of(std::uint32_t i) {
    for (std::uint32_t k = 0; k < i; ++k) {
      if (circles_[k] == circles_[i]) return;
    }
    const std::vector<DiscCrossing> points = points_on(i);
    const auto after = [&](std::size_t m) { return m + 1 == points.size() ? 0 : m + 1; };
    std::vector<bool> stays(points.size(), true);
    for (std::size_t m = 0; m < points.size(); ++m) {
      for (std::uint32_t k = 0; k < size() && stays[m]; ++k) stays[m] = stays_in(i, points[m], k);
    }
    for (std::size_t m = 0; m < points.size();
         ++m) {  // an arc begins after a point from which the circle does not stay
      std::size_t end = after(m);
      if (stays[m] || !stays[end]) continue;
      const std::size_t begin = end;
      while (stays[end]) end = after(end);
      arcs_.push_back({i, points[begin], points[end]});
    }
  }

  // Does the arc begin where the other one ends? They are of different circles: so if these do not cross, they have one
  // common point at most, and else two, on different sides of the line of the centres.
  bool follows(const Arc& arc, const Arc& before) {
    if (arc.disc == before.disc || !is_on(arc.begin, disc(before.disc)) || !is_on(before.end, disc(arc.disc))) {
      return false;
    }
    const Point2 &from = circles_[before.disc].center, &to = circles_[arc.disc].center;
    return orient_2d(from, to, arc.begin, &tally_) == orient_2d(from, to, before.end, &tally_);
  }

  void link() {
    std::vector<std::uint32_t> around;
    std::size_t at = 0;
    do {
      around.push_back(arcs_[at].disc);
      std::size_t next = 0;
      while (next + 1 < arcs_.size() && !follows(arcs_[next], arcs_[at])) ++next;
      at = next;
    } while (at != 0 && around.size() <= arcs_.size());
    out_.arcs = around;
    for (std::size_t k = 0; k < around.size(); ++k) {
      std::rotate(around.begin(), around.begin() + 1, around.end());
      out_.arcs = std::min(out_.arcs, around);
    }
  }

  const Discs& circles_;
  DiscIntersection out_;
  StageTally tally_;
  std::vector<Arc> arcs_;
  bool has_point_ = false;
};

}  // namespace

DiscIntersection disc_intersection_by_scan(const Discs& circles) { return DiscScan(circles).run(); }

}  // namespace sunder::planar
