#include <sunder/predicate/along.h>
#include <sunder/predicate/round_image.h>
#include <sunder/solid/round/round_quick.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sunder::solid {

namespace {

using V = Vector3<double>;

V sum(const V& p, double by, const V& q) { return {p.x + by * q.x, p.y + by * q.y, p.z + by * q.z}; }
double length(const V& v) { return std::sqrt(dot(v, v)); }
Point3 point(const V& v) { return {v.x, v.y, v.z}; }
V vector(const Point3& p) { return {p.x, p.y, p.z}; }

// A body in its place, in doubles. What is said of its core is of a curved body said of itself.
struct Side {
  const RoundBody& body;
  const Affine3& pose;
  RoundImage image;

  Side(const RoundBody& of, const Pose& at) : body(of), pose(at.affine()) { set(at); }

  bool is_curved() const { return body.is_curved(); }
  bool is_ball() const { return !is_curved() && image.ends == 1; }
  bool is_capsule() const { return !is_curved() && image.ends == 2; }
  bool is_box() const { return body.box() != nullptr; }
  double radius() const { return is_curved() ? 0 : image.radius; }  // around the core

  V turned(const V& v) const {
    const auto& m = pose.linear;
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
            m[6] * v.x + m[7] * v.y + m[8] * v.z};
  }
  V pulled(const V& v) const {
    const auto& m = pose.linear;
    return {m[0] * v.x + m[3] * v.y + m[6] * v.z, m[1] * v.x + m[4] * v.y + m[7] * v.z,
            m[2] * v.x + m[5] * v.y + m[8] * v.z};
  }
  V translation() const { return {pose.translation[0], pose.translation[1], pose.translation[2]}; }

  V middle() const {
    if (image.kind == RoundKind::cone) return sum(image.from, 0.25 * image.length, image.axis);
    if (image.kind == RoundKind::cylinder) return sum(image.from, 0.5 * image.length, image.axis);
    if (image.ends == 1) return image.from;
    if (image.ends == 2) return sum(image.from, 0.5, image.axis);
    return sum(translation(), 1, turned(vector(body.core().search_graph().middle)));
  }

 private:
  void set(const Pose& at) {
    const SearchGraph& graph = body.core().search_graph();
    const double size = std::max(at.linear_range().greatest * graph.sizes.greatest, at.translation_range().greatest);
    const std::size_t n = graph.vertices.size();
    if (body.is_curved()) {
      const std::span<const Point3> points = body.points();
      set_image(image, body.kind(), pose, points.data(), static_cast<std::uint32_t>(points.size()), body.radius(),
                size);
    } else if (n <= 2) {
      set_image(image, RoundKind::hull, pose, graph.vertices.data(), static_cast<std::uint32_t>(n), body.radius(),
                size);
    } else {
      set_image(image, pose, graph.all.data(), graph.padded, body.radius(), size);
      if (graph.padded == 0) image.is_tame = false;  // of many vertices
    }
  }
};

// The point of a core that is nearest to another: what makes it.
struct Nearest {
  V at;
  RoundCombination made{};  // of hulls
};

void put(RoundCombination& made, std::uint32_t vertex, double weight) {
  if (!(weight > 0)) return;
  made.vertices[made.count] = vertex;
  made.weights[made.count++] = weight;
}

// The point of a segment, from 0 to 1.
Nearest on_segment(const RoundImage& image, double t) {
  Nearest found{};
  const double rest = 1 - t;
  put(found.made, 0, rest);
  put(found.made, 1, t);
  found.at = {rest * image.from.x + t * image.to.x, rest * image.from.y + t * image.to.y,
              rest * image.from.z + t * image.to.z};
  return found;
}

// In a box, of the corner at `place` 0 and those after it in the order of the coordinates, of which the greatest comes
// first: a simplex that holds the point. Source: Freudenthal 1942; Kuhn 1960.
Nearest in_box(const Side& side, const V& x) {
  const RoundBox& box = *side.body.box();
  const V local = side.pulled(x - side.translation()) - vector(box.middle);
  std::array<std::pair<double, std::size_t>, 3> part;  // from 0 to 1 along each side
  for (std::size_t k = 0; k < 3; ++k) {
    const V half = vector(box.half[k]);
    part[k] = {std::clamp(0.5 + 0.5 * dot(local, half) / dot(half, half), 0.0, 1.0), k};
  }
  if (part[0].first < part[1].first) std::swap(part[0], part[1]);
  if (part[1].first < part[2].first) std::swap(part[1], part[2]);
  if (part[0].first < part[1].first) std::swap(part[0], part[1]);
  Nearest found{};
  std::size_t place = 0;
  put(found.made, box.corners[place], 1 - part[0].first);
  for (std::size_t k = 0; k < 3; ++k) {
    place |= std::size_t{1} << part[k].second;
    put(found.made, box.corners[place], part[k].first - (k < 2 ? part[k + 1].first : 0));
  }
  // Of these vertices as they are.
  V total{0, 0, 0};
  double weight = 0;
  for (std::size_t k = 0; k < found.made.count; ++k) {
    total = sum(total, found.made.weights[k], vector(side.body.core().search_graph().vertices[found.made.vertices[k]]));
    weight += found.made.weights[k];
  }
  found.at = sum(side.translation(), 1, side.turned({total.x / weight, total.y / weight, total.z / weight}));
  return found;
}

Nearest in_cylinder(const RoundImage& image, const V& x) {
  const V from = x - image.from;
  const double along = dot(from, image.axis);
  const V across = sum(from, -along, image.axis);
  const double far2 = dot(across, across), r = image.radius;
  const double by = far2 > r * r ? r / std::sqrt(far2) : 1;
  return {sum(sum(image.from, std::clamp(along, 0.0, image.length), image.axis), by, across)};
}

// In the half plane of the axis and the point: of the triangle of base, rim and apex.
Nearest in_cone(const RoundImage& image, const V& x) {
  const V from = x - image.from;
  const double along = dot(from, image.axis), l = image.length, r = image.radius;
  const V across = sum(from, -along, image.axis);
  const double far = length(across);
  double up = along, out = far;
  if (r * along + l * (far - r) > 0) {  // beyond the side
    const double t = std::clamp((l * along - r * (far - r)) / (l * l + r * r), 0.0, 1.0);
    up = t * l;
    out = (1 - t) * r;
    if (along < 0) {
      up = 0;
      out = std::min(far, r);
    }
  } else if (along < 0) {
    up = 0;
    out = std::min(far, r);
  }
  return {sum(sum(image.from, up, image.axis), far > 0 ? out / far : 0, across)};
}

bool has_nearest(const Side& side) {
  return side.is_ball() || side.is_capsule() || (side.is_curved() && side.image.kind != RoundKind::ellipsoid) ||
         (side.is_box() && side.image.count > 0);
}

// Requires has_nearest.
Nearest nearest_in(const Side& side, const V& x) {
  const RoundImage& image = side.image;
  if (image.kind == RoundKind::cylinder) return in_cylinder(image, x);
  if (image.kind == RoundKind::cone) return in_cone(image, x);
  if (side.is_ball()) return {image.from, {1, {0}, {1}}};
  if (!side.is_capsule()) return in_box(side, x);
  return on_segment(image, std::clamp(dot(x - image.from, image.axis) / dot(image.axis, image.axis), 0.0, 1.0));
}

// Where segments are nearest to each other: of the first, from 0 to 1. Source: Ericson 2005, section 5.1.9.
double nearest_of_segments(const RoundImage& a, const RoundImage& b) {
  const V way = a.from - b.from;
  const double aa = dot(a.axis, a.axis), bb = dot(b.axis, b.axis), ab = dot(a.axis, b.axis);
  const double of_a = dot(a.axis, way), of_b = dot(b.axis, way);
  const double across = aa * bb - ab * ab;
  const double s = across > 0 ? std::clamp((ab * of_b - of_a * bb) / across, 0.0, 1.0) : 0;
  const double t = std::clamp((ab * s + of_b) / bb, 0.0, 1.0);
  return std::clamp((ab * t - of_a) / aa, 0.0, 1.0);
}

class Quick {
 public:
  Quick(const Side& a, const Side& b, RoundAnswer& answer, Point3& way)
      : a_(a), b_(b), answer_(answer), way_(way), size_(a.image.size + b.image.size) {}

  bool run() {
    if (!(a_.image.is_tame && b_.image.is_tame)) return false;
    const bool first = a_.is_ball() || (a_.is_capsule() && !b_.is_ball());
    if (first || b_.is_ball() || b_.is_capsule()) {
      const Side &own = first ? a_ : b_, &other = first ? b_ : a_;
      if (!has_nearest(other)) return false;
      return own.is_ball() ? ball(own, other) : capsule(own, other);
    }
    return false;
  }

 private:
  bool ball(const Side& own, const Side& other) {
    const Nearest centre{own.image.from, {1, {0}, {1}}};
    return settles(own, centre, other, nearest_in(other, centre.at));
  }

  // A ball that moves along the axis: its distance is convex. Where it is least: by the false position, as Illinois
  // has it. Source: Dowell and Jarratt 1971.
  bool capsule(const Side& own, const Side& other) {
    const RoundImage& image = own.image;
    const double length2 = dot(image.axis, image.axis);
    if (!(length2 > 0)) return false;
    // By how much the square of the distance grows, half of it.
    const auto look = [&](double t) {
      ++answer_.cost.iterations;
      const Nearest p = on_segment(image, t), q = nearest_in(other, p.at);
      const double growth = dot(p.at - q.at, image.axis);
      const bool held = settles(own, p, other, q);
      return std::pair(growth, held);
    };
    if (other.is_capsule()) return look(nearest_of_segments(image, other.image)).second;
    double t = std::clamp(dot(other.middle() - image.from, image.axis) / length2, 0.0, 1.0);
    double low = 0, high = 1, of_low = 0, of_high = 0;  // the growth there; 0: not known
    int last = 0;
    for (int i = 0; i < most_steps; ++i) {
      const auto [growth, held] = look(t);
      if (held) return true;
      if (growth == 0) return false;
      if (growth > 0) {
        if (t == 0) return false;
        high = t;
        of_high = growth;
        if (last > 0) of_low /= 2;
        last = 1;
      } else {
        if (t == 1) return false;
        low = t;
        of_low = growth;
        if (last < 0) of_high /= 2;
        last = -1;
      }
      const double next = of_low == 0 ? 0 : of_high == 0 ? 1 : low + (high - low) * (of_low / (of_low - of_high));
      if (next == t || !(next >= low && next <= high)) return false;
      t = next;
    }
    return false;
  }

  // p of the core of `own`, a ball or a capsule, and q of the other's are nearest to each other.
  bool settles(const Side& own, const Nearest& p, const Side& other, const Nearest& q) {
    V way = q.at - p.at;
    const double far2 = dot(way, way), reach = own.radius() + other.radius();
    if (far2 > reach * reach) {
      // Within the axis of a capsule the way is perpendicular to it.
      if (own.is_capsule() && p.made.count == 2) way = perpendicular(way, own.image.axis);
      if (other.is_capsule() && q.made.count == 2) way = perpendicular(way, other.image.axis);
      return parts(&own == &a_ ? way : V{-way.x, -way.y, -way.z});
    }
    ++answer_.cost.proposals;
    const RoundCombination &of_a = &own == &a_ ? p.made : q.made, &of_b = &own == &a_ ? q.made : p.made;
    if (!other.is_curved()) {
      return nearness_guess(p.at, q.at, reach, size_) == Guess::positive &&
             meets(RoundEvidence::Source::between, {}, of_a, of_b);
    }
    // From the point of the other body's surface inwards, by half of what is left over.
    const V inwards = other.middle() - q.at;
    const double slack = reach - std::sqrt(far2), deep = length(inwards);
    const V x = sum(q.at, slack < deep ? 0.5 * slack / deep : 0.5, inwards);
    return side_guess(other.image, x) == Guess::positive &&
           nearness_guess(p.at, x, reach, own.image.size) == Guess::positive &&
           meets(RoundEvidence::Source::point, point(x), of_a, of_b);
  }

  static V perpendicular(const V& v, const V& axis) { return sum(v, -dot(v, axis) / dot(axis, axis), axis); }

  bool parts(const V& way) {
    ++answer_.cost.proposals;
    Point3 d = point(way);
    if (!make_tame(d)) return false;
    way_ = d;
    if (gap_guess(vector(d), a_.image, b_.image) != Guess::positive) return false;
    answer_.evidence.verdict = RoundVerdict::apart;
    answer_.evidence.direction = d;
    return true;
  }

  bool meets(RoundEvidence::Source source, const Point3& x, const RoundCombination& a, const RoundCombination& b) {
    RoundEvidence& evidence = answer_.evidence;
    evidence.verdict = RoundVerdict::meet;
    evidence.source = source;
    evidence.point = x;
    evidence.a = a;
    evidence.b = b;
    return true;
  }

  static constexpr int most_steps = 20;

  const Side& a_;
  const Side& b_;
  RoundAnswer& answer_;
  Point3& way_;
  double size_;
};

}  // namespace

bool decide_quickly(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, RoundAnswer& answer,
                    Point3& way) {
  const Side of_a(a, pose_a), of_b(b, pose_b);
  return Quick(of_a, of_b, answer, way).run();
}

}  // namespace sunder::solid
