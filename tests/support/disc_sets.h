// Sets of discs for differential tests: small and nasty, from a seed.
#pragma once

#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/planar/pair/disc_disc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sunder::tests {

// --- Of which some meet ----------------------------------------------------------------------------------------------

enum class DiscFamily : int {
  grid,       // integer centres and radii in a small square: every contact is common
  sparse,     // small discs in the unit square, few of which meet
  packed,     // touching discs in rows, with points and small ones between, now and then one too large
  last_bit,   // each touches one before it, or misses it by a few bits
  nested,     // about few centres: equal ones, rings, touching from inside
  upright,    // with equal first or last abscissas, or heights
  any_scale,  // 1e-300 to 1e300, mixed; or integers at such a scale
  points,     // radius zero, on integers, with few discs
  crowd,      // more, many of them in one place
};
inline constexpr int disc_family_count = 9;
inline constexpr std::array<const char*, disc_family_count> disc_family_names{
    "grid", "sparse", "packed", "last_bit", "nested", "upright", "any_scale", "points", "crowd"};

class DiscSets {
 public:
  explicit DiscSets(std::uint64_t seed) : random_(seed) {}
  Random& random() { return random_; }

  DiscFamily family() const { return family_; }
  std::vector<Disc> next() {
    family_ = static_cast<DiscFamily>(turn_++ % disc_family_count);
    if (family_ == DiscFamily::crowd && random_.below(16) != 0) family_ = DiscFamily::sparse;
    std::vector<Disc> set = of_family();
    shuffle(set, random_);
    if (!set.empty() && random_.below(40) == 0) set.push_back(set[random_.below(set.size())]);
    return set;
  }

 private:
  double integer(std::int64_t low, std::int64_t high) { return static_cast<double>(random_.between(low, high)); }
  Disc on_integers(std::int64_t side, std::int64_t radius) {
    const double x = integer(0, side), y = integer(0, side);
    return {{x, y}, integer(0, radius)};
  }
  Disc in_square(double x, double y, double size, double radius) {
    const double u = random_.unit(), v = random_.unit();
    return {{x + size * u, y + size * v}, radius * random_.unit()};
  }

  std::vector<Disc> of_family() {
    std::vector<Disc> set;
    const std::int64_t count = random_.between(2, 14);
    const auto repeat = [&](std::int64_t times, const auto& make) {
      for (std::int64_t k = 0; k < times; ++k) set.push_back(make());
    };
    switch (family_) {
      case DiscFamily::grid: {
        const std::int64_t side = random_.between(3, 30);
        repeat(std::min<std::int64_t>(count, 8), [&] { return on_integers(side, 3); });
        break;
      }
      case DiscFamily::sparse: repeat(2 * count, [&] { return in_square(0, 0, 1, 0.05); }); break;
      case DiscFamily::packed: pack(set); break;
      case DiscFamily::last_bit: touch(set, random_.between(2, 7)); break;
      case DiscFamily::nested: nest(set, random_.between(2, 4)); break;
      case DiscFamily::upright: {
        const double at = integer(-3, 3), step = integer(2, 6), how = integer(0, 2);
        for (std::int64_t k = 0; k < count / 2 + 1; ++k) {
          const double r = integer(0, 2), y = step * static_cast<double>(k) + integer(0, 1);
          set.push_back(how == 0 ? Disc{{at - r, y}, r} : how == 1 ? Disc{{at + r, y}, r} : Disc{{y, at}, r});
        }
        break;
      }
      case DiscFamily::any_scale: {
        const double unit = std::ldexp(1, static_cast<int>(random_.between(-1074, 1015)));
        if (random_.below(2) == 0) {
          repeat(random_.between(2, 4), [&] {
            const Disc c = on_integers(8, 3);
            return Disc{{unit * c.center.x, unit * c.center.y}, unit * c.radius};
          });
        } else {
          const auto any = [&](double x) { return std::ldexp(x, static_cast<int>(random_.between(-1074, 1022))); };
          repeat(random_.between(2, 3), [&] {
            const double x = any(random_.uniform(-2, 2)), y = any(random_.uniform(-2, 2));
            return Disc{{x, y}, random_.below(3) == 0 ? 0 : any(random_.unit())};
          });
        }
        break;
      }
      case DiscFamily::points: {
        repeat(random_.between(2, 9), [&] { return on_integers(9, 0); });
        if (random_.below(2) == 0) set.push_back(on_integers(9, 2));
        break;
      }
      case DiscFamily::crowd: {
        repeat(200, [&] { return in_square(0, 0, 1, 0.0015); });
        const double x = random_.unit(), y = random_.unit();
        repeat(75, [&] { return in_square(x, y, 0.01, 0.00004); });
        break;
      }
    }
    return set;
  }

  void pack(std::vector<Disc>& set) {
    const std::int64_t side = random_.between(2, 4), odd = random_.between(0, 1);
    for (std::int64_t k = 0; k < side * side; ++k) {
      const double x = 2 * static_cast<double>(k % side), y = 2 * static_cast<double>(k / side);
      const std::uint64_t what = random_.below(6);
      if (what == 0) continue;
      if (what == 1) set.push_back({{x + 1, y}, 0});          // between two
      if (what == 2) set.push_back({{x + 1, y + 1}, 0.375});  // in the gap
      set.push_back({{x, y}, what == 3 ? 0.5 : 1});
    }
    if (odd != 0 && !set.empty()) set[random_.below(set.size())].radius += random_.below(2) == 0 ? 0x1p-40 : 0.5;
  }

  void touch(std::vector<Disc>& set, std::int64_t count) {
    set.push_back(in_square(0, 0, 1, 0.3));
    for (std::int64_t k = 1; k < count; ++k) {
      Disc c = in_square(0, 0, 3, 0);
      const Disc& other = set[random_.below(set.size())];
      const double apart = std::hypot(c.center.x - other.center.x, c.center.y - other.center.y);
      c.radius = std::fabs(apart - other.radius);
      for (std::int64_t bits = random_.between(-2, 2); bits != 0; bits += bits < 0 ? 1 : -1) {
        c.radius = std::nextafter(c.radius, bits < 0 ? 0 : 9);
      }
      const auto meets_others = [&] {
        return std::any_of(set.begin(), set.end(), [&](const Disc& d) {
          return &d != &other && planar::disc_disc(c, d) != planar::DiscContact::none;
        });
      };
      if (random_.below(8) == 0 || !meets_others()) set.push_back(c);
    }
  }

  void nest(std::vector<Disc>& set, std::int64_t count) {
    for (std::int64_t k = 0; k < count; ++k) {
      const Disc around{{20.0 * static_cast<double>(k), integer(-2, 2)}, integer(1, 9)};
      set.push_back(around);
      if (random_.below(3) != 0) continue;
      const double r = integer(0, 4), along = random_.below(2) == 0 ? around.radius - r : integer(-3, 3);
      set.push_back({{around.center.x + along, around.center.y}, r});
    }
  }

  Random random_;
  int turn_ = 0;
  DiscFamily family_ = DiscFamily::grid;
};

// --- With something in common, or nearly so --------------------------------------------------------------------------

enum class CommonDiscFamily : int {
  grid,         // whole numbers: touching, nested, equal, concentric
  concurrent,   // circles of whole numbers through a few points
  last_bit,     // those, a unit in the last place off
  generic,      // of about one size, some common part or nearly so
  equal_radii,  // many arcs
  any_scale,    // the same at 1e-300 to 1e300; or numbers of all sizes
};
inline constexpr int common_disc_family_count = 6;
inline constexpr std::array<const char*, common_disc_family_count> common_disc_family_names{
    "grid", "concurrent", "last bit", "generic", "equal radii", "any scale"};

// Arrows of whole length: circles about whole points through one whole point.
inline constexpr std::array<std::array<int, 3>, 9> whole_arrows{
    {{3, 4, 5}, {5, 12, 13}, {8, 6, 10}, {0, 5, 5}, {4, 3, 5}, {1, 0, 1}, {7, 24, 25}, {15, 8, 17}, {0, 10, 10}}};

class CommonDiscSets {
 public:
  explicit CommonDiscSets(std::uint64_t seed) : random_(seed) {}

  std::vector<Disc> next(CommonDiscFamily family) {
    std::vector<Disc> set;
    switch (family) {
      case CommonDiscFamily::grid: {
        const std::int64_t side = random_.between(1, 4);
        for (std::int64_t n = random_.between(1, 7); n > 0; --n) {
          set.push_back({{whole(-side, side), whole(-side, side)}, whole(random_.below(8) == 0 ? 0 : 1, 2 * side)});
        }
        break;
      }
      case CommonDiscFamily::concurrent: {
        const std::int64_t reach = random_.between(0, 1) * 5;
        for (std::int64_t n = random_.between(1, 7); n > 0; --n) {
          set.push_back(through({whole(0, 1) * static_cast<double>(reach), whole(0, 1) * static_cast<double>(reach)}));
          if (random_.below(8) == 0) set.push_back(set[random_.below(set.size())]);
          if (random_.below(12) == 0) set.push_back({set.back().center, whole(0, 12)});
        }
        break;
      }
      case CommonDiscFamily::last_bit:
        set = next(random_.below(2) ? CommonDiscFamily::grid : CommonDiscFamily::concurrent);
        for (Disc& c : set) {
          for (double* x : {&c.center.x, &c.center.y, &c.radius}) {
            if (random_.below(3) == 0)
              *x = std::nextafter(*x, random_.below(2) ? HUGE_VAL : x == &c.radius ? 0 : -HUGE_VAL);
          }
        }
        break;
      case CommonDiscFamily::generic: {
        const double size = random_.uniform(0.3, 1.5);
        for (std::int64_t n = random_.between(1, 9); n > 0; --n) {
          set.push_back({{random_.uniform(-1, 1), random_.uniform(-1, 1)}, size * random_.uniform(0.7, 1.5)});
        }
        break;
      }
      case CommonDiscFamily::equal_radii: {
        const double radius = random_.uniform(0.9, 3);
        for (std::int64_t n = random_.between(2, 10); n > 0; --n) {
          const double angle = random_.uniform(0, 7), far = random_.below(2) ? 1 : random_.unit();
          set.push_back({{far * std::cos(angle), far * std::sin(angle)}, radius});
        }
        break;
      }
      case CommonDiscFamily::any_scale: {
        if (random_.below(2)) {
          set = next(static_cast<CommonDiscFamily>(random_.below(5)));
          const int exponent =
              static_cast<int>(random_.below(2) ? random_.between(900, 1015) : -random_.between(900, 1000));
          for (Disc& c : set) {
            c = {{std::ldexp(c.center.x, exponent), std::ldexp(c.center.y, exponent)}, std::ldexp(c.radius, exponent)};
          }
          break;
        }
        const auto any = [&] { return random_.log_uniform(1e-300, 1e300) * (random_.below(2) ? 1 : -1); };
        for (std::int64_t n = random_.between(1, 4); n > 0; --n) {
          const double x = any(), y = any();
          set.push_back({{x, y}, std::fabs(random_.below(3) ? std::max(x, y) : any())});
        }
        break;
      }
    }
    return set;
  }

 private:
  double whole(std::int64_t low, std::int64_t high) { return static_cast<double>(random_.between(low, high)); }

  Disc through(const Point2& p) {
    const auto& [a, b, r] = whole_arrows[random_.below(whole_arrows.size())];
    const double x = random_.below(2) ? a : -a, y = random_.below(2) ? b : -b;
    return {random_.below(2) ? Point2{p.x + x, p.y + y} : Point2{p.x + y, p.y + x}, static_cast<double>(r)};
  }

  Random random_;
};

}  // namespace sunder::tests
