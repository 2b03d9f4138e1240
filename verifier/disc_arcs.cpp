#include "disc_arcs.h"

#include "statement.h"

namespace sunder_verifier {
namespace {

// Of p + q sqrt(r).
int sign_of_root(const Integer& p, const Integer& q, const Integer& r) {
  const int a = p.sign(), b = r.is_zero() ? 0 : q.sign();
  if (a * b >= 0) return a != 0 ? a : b;
  return a * square(p).compare(square(q) * r);
}

// Of p + q sqrt(r) + (s + u sqrt(r)) sqrt(t).
int sign_of_roots(const Integer& p, const Integer& q, const Integer& r, const Integer& s, const Integer& u,
                  const Integer& t) {
  const int a = sign_of_root(p, q, r), b = t.is_zero() ? 0 : sign_of_root(s, u, r);
  if (a * b >= 0) return a != 0 ? a : b;
  const Integer even = square(p) + square(q) * r - t * (square(s) + square(u) * r), odd = 2 * (p * q - t * s * u);
  return a * sign_of_root(even, odd, r);
}

struct Arrow {
  Integer x, y;
};

Integer cross(const Arrow& p, const Arrow& q) { return p.x * q.y - p.y * q.x; }

// A direction, as a vector with square roots: even + odd sqrt(root).
struct Way {
  Arrow even, odd;
  Integer root;
};

int turn(const Way& p, const Arrow& w) { return sign_of_root(cross(p.even, w), cross(p.odd, w), p.root); }

int turn(const Way& p, const Way& q) {
  return sign_of_roots(cross(p.even, q.even), cross(p.odd, q.even), p.root, cross(p.even, q.odd), cross(p.odd, q.odd),
                       q.root);
}

// Is its bearing less than half a turn?
bool is_upper(const Way& p) {
  const int y = sign_of_root(p.even.y, p.odd.y, p.root);
  return y > 0 || (y == 0 && sign_of_root(p.even.x, p.odd.x, p.root) > 0);
}

// Where an arc of a ends and one of b begins: of the points where the circles cross, that at which the way around a
// leaves the disc of b.
class Corner {
 public:
  Corner(const Disc& a, const Disc& b)
      : a_(a),
        u_{b.x - a.x, b.y - a.y},
        distance_squared_(square(u_.x) + square(u_.y)),
        along_(distance_squared_ + square(a.r) - square(b.r)),
        root_(4 * square(a.r) * distance_squared_ - square(along_)) {}

  bool is_crossing() const { return root_ > 0; }

  Way from_first_centre() const { return {{along_ * u_.x, along_ * u_.y}, {-u_.y, u_.x}, root_}; }
  Way from_second_centre() const {
    const Integer back = along_ - 2 * distance_squared_;
    return {{back * u_.x, back * u_.y}, {-u_.y, u_.x}, root_};
  }

  Way from(const PointInUnits& p) const {
    const Way way = from_first_centre();
    const Integer twice = 2 * distance_squared_;
    return {{twice * (a_.x * p.unit - p.x) + way.even.x * p.unit, twice * (a_.y * p.unit - p.y) + way.even.y * p.unit},
            {way.odd.x * p.unit, way.odd.y * p.unit},
            root_};
  }

  // The powers of a point for two discs differ by a linear function of it; that for a is zero here.
  bool is_in(const Disc& disc) const {
    const Arrow v{disc.x - a_.x, disc.y - a_.y};
    const Integer power = square(v.x) + square(v.y) + square(a_.r) - square(disc.r);
    return sign_of_root(power * distance_squared_ - along_ * (u_.x * v.x + u_.y * v.y), -cross(u_, v), root_) <= 0;
  }

 private:
  Disc a_;
  Arrow u_;  // from centre to centre
  // The corner is (along u + sqrt(root) u turned left) / (2 distance_squared) from the centre of a.
  Integer distance_squared_, along_, root_;
};

bool holds(const Disc& outer, const Disc& inner) {
  return outer.r >= inner.r && square(outer.x - inner.x) + square(outer.y - inner.y) <= square(outer.r - inner.r);
}

// Is a vector inside of the angle from one way counter-clockwise to another, to which the first turns as said?
bool is_between(const Arrow& w, const Way& begin, const Way& end, int begin_to_end) {
  if (begin_to_end > 0) return turn(begin, w) > 0 && turn(end, w) < 0;
  if (begin_to_end < 0) return turn(begin, w) > 0 || turn(end, w) < 0;
  return turn(begin, w) > 0;
}

// Do these ways from one point go once around it, each a bit further than the one before?
bool go_round_once(const std::vector<Way>& ways) {
  std::size_t rounds = 0;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const Way &before = ways[(k == 0 ? ways.size() : k) - 1], &way = ways[k];
    const bool was = is_upper(before), is = is_upper(way);
    // Past the bearing 0, if not forward within one half.
    rounds += was == is ? turn(before, way) <= 0 : is;
  }
  return rounds == 1;
}

std::string name(std::size_t disc) { return "circle " + std::to_string(disc); }

void check_whole_disc(const std::vector<Disc>& discs, std::size_t inner) {
  for (std::size_t k = 0; k < discs.size(); ++k) {
    require(holds(discs[k], discs[inner]), "B1", name(k) + " does not hold " + name(inner));
  }
}

}  // namespace

void check_arcs(const std::vector<Disc>& discs, const std::vector<std::size_t>& arcs, const PointInUnits& point) {
  if (arcs.size() == 1) return check_whole_disc(discs, arcs[0]);
  std::vector<Corner> corners;
  std::vector<Way> around;  // the corners from the point
  for (std::size_t m = 0; m < arcs.size(); ++m) {
    const std::size_t next = arcs[m + 1 == arcs.size() ? 0 : m + 1];
    const Disc &a = discs[arcs[m]], &b = discs[next];
    corners.emplace_back(a, b);
    require(corners.back().is_crossing(), "B1",
            "circles " + std::to_string(arcs[m]) + " and " + std::to_string(next) + " do not cross in two points");
    around.push_back(corners.back().from(point));
  }
  require(go_round_once(around), "B2", "the corners do not go once around the point");
  for (std::size_t m = 0; m < arcs.size(); ++m) {
    const Disc& circle = discs[arcs[m]];
    const Way begin = corners[(m == 0 ? arcs.size() : m) - 1].from_second_centre(),
              end = corners[m].from_first_centre();
    const int begin_to_end = turn(begin, end);
    for (std::size_t k = 0; k < discs.size(); ++k) {
      require(corners[m].is_in(discs[k]), "B3", "the end of arc " + std::to_string(m) + " is not in " + name(k));
      const Arrow away{circle.x - discs[k].x, circle.y - discs[k].y};
      require(!is_between(away, begin, end, begin_to_end) || holds(discs[k], circle), "B4",
              "arc " + std::to_string(m) + " is not all in " + name(k));
    }
  }
}

}  // namespace sunder_verifier
