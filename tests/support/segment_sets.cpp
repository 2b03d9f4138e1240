#include <tests/support/segment_sets.h>

#include <tests/support/doubles.h>

#include <array>
#include <cmath>

namespace sunder::tests {

namespace {

using planar::Segment;

// One unit in the last place up, down, or not at all.
double nudged(Random& random, double x) {
  const std::uint64_t way = random.below(3);
  return way == 0 ? x : std::nextafter(x, way == 1 ? infinity : -infinity);
}

}  // namespace

std::string_view name_of(SegmentFamily family) {
  constexpr std::array<std::string_view, segment_family_count> names{"grid", "sparse",    "collinear", "last bit",
                                                                     "star", "any scale", "mesh"};
  return names[static_cast<std::size_t>(family)];
}

SegmentSet SegmentSets::next() {
  SegmentSet set;
  set.family = static_cast<SegmentFamily>(turn_++ % segment_family_count);
  std::vector<Segment>& s = set.segments;
  const auto unit = [&] { return random_.uniform(-1, 1); };
  switch (set.family) {
    case SegmentFamily::grid: {
      const std::int64_t side = random_.between(4, 8);
      const auto whole = [&] { return static_cast<double>(random_.between(0, side)); };
      for (std::int64_t n = random_.between(0, 5); n >= 0; --n) s.push_back({{whole(), whole()}, {whole(), whole()}});
      break;
    }
    case SegmentFamily::sparse: {
      const double length = random_.log_uniform(0.01, 0.5);
      for (std::int64_t n = random_.between(1, 40); n > 0; --n) {
        const Point2 p{unit(), unit()};
        s.push_back({p, {p.x + length * unit(), p.y + length * unit()}});
      }
      break;
    }
    case SegmentFamily::collinear: {
      const Point2 p{unit(), unit()}, d{unit(), random_.below(4) == 0 ? 0 : unit()};
      const bool exact = random_.below(2) != 0;
      const auto on_line = [&] {
        const double t = static_cast<double>(random_.between(-20, 20));
        if (exact) return Point2{std::round(8 * d.x) * t, std::round(8 * d.y) * t};
        return Point2{nudged(random_, p.x + t * d.x), nudged(random_, p.y + t * d.y)};
      };
      for (std::int64_t n = random_.between(2, 8); n > 0; --n) s.push_back({on_line(), on_line()});
      break;
    }
    case SegmentFamily::last_bit: {
      for (std::int64_t n = random_.between(1, 6); n > 0; --n) {
        const Point2 a{unit(), unit()}, b{unit(), unit()};
        if (random_.below(2)) s.push_back({a, b});
        // From near the segment, a little to one side.
        const double t = random_.uniform(-0.1, 1.1);
        const Point2 on{nudged(random_, a.x + t * (b.x - a.x)), nudged(random_, a.y + t * (b.y - a.y))};
        s.push_back({on, {on.x + 0.1 * unit(), on.y + 0.1 * unit()}});
        if (random_.below(2)) s.push_back({a, b});
      }
      break;
    }
    case SegmentFamily::star: {
      const std::int64_t n = random_.between(3, 40);
      for (std::int64_t k = 0; k < n; ++k) {
        const double y = static_cast<double>(k) / static_cast<double>(n),
                     slope = random_.uniform(0, 0.5 / static_cast<double>(n));
        s.push_back({{-1 - random_.unit(), y}, {1 + random_.unit(), y + slope}});
      }
      if (random_.below(2)) {
        const double x = unit();
        s.push_back({{x, random_.unit()}, {x + (random_.below(2) ? 0.1 : 0.0), random_.unit()}});
      }
      break;
    }
    case SegmentFamily::any_scale: {
      const bool mixed = random_.below(2) != 0;
      const double scale = random_.log_uniform(1e-300, 1e300);
      const auto number = [&] { return unit() * (mixed ? random_.log_uniform(1e-300, 1e300) : scale); };
      for (std::int64_t n = random_.between(1, 4); n > 0; --n) {
        s.push_back({{number(), number()}, {number(), number()}});
        if (random_.below(4) == 0) s.push_back({s.back().a, {number(), number()}});
      }
      break;
    }
    case SegmentFamily::mesh: {
      const std::int64_t side = random_.between(1, 5);
      std::vector<Point2> p;
      for (std::int64_t y = 0; y <= side; ++y) {
        for (std::int64_t x = 0; x <= side; ++x) {
          p.push_back({static_cast<double>(x) + 0.3 * unit(), static_cast<double>(y) + 0.3 * unit()});
        }
      }
      const auto at = [&](std::int64_t x, std::int64_t y) { return p[static_cast<std::size_t>(y * (side + 1) + x)]; };
      for (std::int64_t y = 0; y <= side; ++y) {
        for (std::int64_t x = 0; x <= side; ++x) {
          if (x < side) s.push_back({at(x, y), at(x + 1, y)});
          if (y < side) s.push_back({at(x, y + 1), at(x, y)});
        }
      }
      if (random_.below(3) == 0) s.push_back({at(0, 0), at(side, side)});
      if (random_.below(4) == 0) s.push_back({at(0, side), at(0, side)});
      break;
    }
  }
  return set;
}

}  // namespace sunder::tests
