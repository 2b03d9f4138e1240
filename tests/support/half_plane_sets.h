// Sets of half-planes for tests: small and nasty, from a seed.
#pragma once

#include <sunder/base/random.h>
#include <sunder/planar/object/constraints.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::tests {

enum class HalfPlaneFamily : std::uint8_t {
  grid,        // small whole numbers: every degeneracy is common
  concurrent,  // nearly all through one point
  few_ways,    // of up to three directions and their opposites
  last_bit,    // through one point, but for rounding and some units in the last place
  tangents,    // of a circle: none is redundant
  scaled,      // small whole numbers, each half-plane scaled by a power of two up to 2^900 and down to 2^-900
  any_scale,   // each number from 1e-300 to 1e300, and zeros
  barely,      // around the origin, as near as doubles can tell
};
inline constexpr std::size_t half_plane_family_count = 8;

inline std::string_view name_of(HalfPlaneFamily family) {
  constexpr std::array<std::string_view, half_plane_family_count> names{
      "grid", "concurrent", "few ways", "last bit", "tangents", "scaled", "any scale", "barely"};
  return names[static_cast<std::size_t>(family)];
}

// Endless streams of sets, of constraints and of arrows, family after family in turn.
class HalfPlaneSets {
 public:
  explicit HalfPlaneSets(std::uint64_t seed) : random_(seed) {}

  HalfPlaneFamily family() const { return family_; }  // of the set that was made last
  Random& random() { return random_; }

  std::vector<Constraint> constraints() {
    family_ = static_cast<HalfPlaneFamily>(turn_++ % half_plane_family_count);
    const std::size_t count = random_.below(family_ == HalfPlaneFamily::tangents ? 24 : 11) + random_.below(4);
    px_ = whole(3);
    py_ = whole(3);
    x_ = random_.uniform(-1, 1);
    y_ = random_.uniform(-1, 1);
    way_count_ = 1 + random_.below(3);
    wide_ = turn_ / half_plane_family_count % 4 == 0;
    for (auto& [a, b] : ways_) {
      a = whole(3);
      b = a == 0 ? 1 : whole(3);
    }
    std::vector<Constraint> all;
    while (all.size() < count) {
      if (!all.empty() && random_.below(12) == 0) {
        all.push_back(all[random_.below(all.size())]);
        continue;
      }
      const Constraint next = one();
      if (next.a != 0 || next.b != 0) all.push_back(next);
    }
    return all;
  }

  // Arrows; of the families only those that make sense for points: grid, concurrent, last_bit, any_scale, tangents.
  std::vector<planar::HalfPlane> arrows() {
    constexpr std::array families{HalfPlaneFamily::grid, HalfPlaneFamily::concurrent, HalfPlaneFamily::last_bit,
                                  HalfPlaneFamily::any_scale, HalfPlaneFamily::tangents};
    family_ = families[turn_of_arrows_++ % families.size()];
    const std::size_t count = random_.below(9) + random_.below(4);
    const Point2 p{whole(3), whole(3)};
    std::vector<planar::HalfPlane> all;
    while (all.size() < count) {
      planar::HalfPlane next{{whole(3), whole(3)}, {whole(3), whole(3)}};
      switch (family_) {
        case HalfPlaneFamily::concurrent: {
          const double t = whole(3), dx = whole(3), dy = whole(3);
          next = {{p.x + t * dx, p.y + t * dy}, {p.x + (t + 1) * dx, p.y + (t + 1) * dy}};
          if (random_.below(5) == 0) next.a.x += whole(1);
          break;
        }
        case HalfPlaneFamily::last_bit: {
          const double t = random_.uniform(-2, 2), s = t + random_.uniform(0.1, 1), dx = random_.uniform(-1, 1),
                       dy = random_.uniform(-1, 1);
          next = {{0.3 + t * dx, 0.7 + t * dy}, {0.3 + s * dx, 0.7 + s * dy}};
          break;
        }
        case HalfPlaneFamily::any_scale: next = {{wild(), wild()}, {wild(), wild()}}; break;
        case HalfPlaneFamily::tangents: {
          const double angle = random_.uniform(0, 7), x = std::cos(angle), y = std::sin(angle);
          next = {{x, y}, {x - y, y + x}};
          break;
        }
        default: break;
      }
      if (next.a != next.b) all.push_back(next);
    }
    return all;
  }

 private:
  double whole(std::int64_t most) { return static_cast<double>(random_.between(-most, most)); }
  double wild() {
    return random_.below(6) == 0 ? 0
                                 : random_.uniform(-1, 1) * std::exp2(static_cast<double>(random_.between(-997, 997)));
  }

  Constraint one() {
    switch (family_) {
      case HalfPlaneFamily::grid: return {whole(3), whole(3), static_cast<double>(random_.between(-3, 6))};
      case HalfPlaneFamily::concurrent: {
        const double a = whole(4), b = whole(4), off = random_.below(4) == 0 ? whole(1) : 0;
        return {a, b, a * px_ + b * py_ + off};
      }
      case HalfPlaneFamily::few_ways: {
        const auto& [a, b] = ways_[random_.below(way_count_)];
        const double size = static_cast<double>(random_.between(1, 3)) * (random_.below(2) == 0 ? 1 : -1);
        const double shift = random_.below(3) > 0 ? 0 : size * whole(1), room = random_.below(3) > 0 ? 0 : whole(1);
        return {a * size, b * size, wide_ ? std::fabs(size) : shift + std::fabs(size) * room};
      }
      case HalfPlaneFamily::last_bit: {
        const double a = random_.uniform(-1, 1), b = random_.uniform(-1, 1);
        return {a, b, (a * x_ + b * y_) * (1 + static_cast<double>(random_.between(-1, 3)) * 0x1p-52)};
      }
      case HalfPlaneFamily::tangents: {
        const double angle = random_.uniform(0, 7);
        return {std::cos(angle), std::sin(angle), 1};
      }
      case HalfPlaneFamily::scaled: {
        const double scale = std::exp2(static_cast<double>(random_.between(-900, 900)));
        return {whole(3) * scale, whole(3) * scale, static_cast<double>(random_.between(-2, 5)) * scale};
      }
      case HalfPlaneFamily::any_scale: return {wild(), wild(), wild()};
      case HalfPlaneFamily::barely: {
        const double c = random_.below(8) == 0 ? -5e-324 : random_.below(2) == 0 ? 0 : 5e-324;
        const bool small = random_.below(2) == 0;
        return {small ? whole(2) : random_.uniform(-1, 1), small ? whole(2) : random_.uniform(-1, 1), c};
      }
    }
    return {};
  }

  Random random_;
  std::size_t turn_ = 0, turn_of_arrows_ = 0;
  HalfPlaneFamily family_ = HalfPlaneFamily::grid;
  double px_ = 0, py_ = 0, x_ = 0, y_ = 0;
  std::array<std::array<double, 2>, 3> ways_{};
  std::uint64_t way_count_ = 1;
  bool wide_ = false;  // few_ways: around the origin, so that strips are common
};

}  // namespace sunder::tests
