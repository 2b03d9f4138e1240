#include <bench/inputs/set_count.h>
#include <bench/inputs/set_scenarios.h>

#include <tests/support/shapes.h>

#include <sunder/base/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace bench {
namespace {

using sunder::Random;
using sunder::tests::jittered_angles;
using sunder::tests::shuffle;
namespace tests = sunder::tests;

constexpr double kPi = 3.141592653589793;
constexpr double kCell = 0.49;          // of a cell's side, from its middle: objects in neighbouring cells are apart
constexpr std::size_t kEnough = 20000;  // objects in all inputs of a family and size together
constexpr std::size_t kMostInputs = 64;
constexpr std::size_t kSmall = 100000;  // objects: up to here a single contact is hidden at nine places, at least
constexpr int kLevels = 10;             // of the quadtree, below its roots
constexpr double kLeavesOfRoot = 8.5;

double snapped(double v) { return tests::snapped(v, 40); }
Xy snapped(const Xy& p) { return {snapped(p.x), snapped(p.y)}; }

std::size_t root_of(std::size_t n) {  // rounded up
  std::size_t side = 1;
  while (side * side < n) ++side;
  return side;
}

// Turned by an eighth and sqrt(2) / 2 times as large, so that boxes of neighbours in a grid meet.
Xy turned(const Xy& p) { return {(p.x - p.y) / 2, (p.x + p.y) / 2}; }
constexpr double kTurnedSize = 0.7071067811865475;

// --- Discs -----------------------------------------------------------------------------------------------------------

// Calls with the middles of n cells of side 1.
template <class OfCell>
void for_cells(std::size_t n, const OfCell& of_cell) {
  const std::size_t side = root_of(n);
  for (std::size_t i = 0; i < n; ++i) {
    of_cell(Xy{static_cast<double>(i % side) + 0.5, static_cast<double>(i / side) + 0.5});
  }
}

std::vector<Disc> spread_discs(std::size_t n, Random& random) {
  std::vector<Disc> discs;
  for_cells(n, [&](const Xy& middle) {
    const double radius = random.uniform(0.05, 0.25), room = kCell - radius;
    const double dx = random.uniform(-room, room), dy = random.uniform(-room, room);
    discs.push_back({snapped({middle.x + dx, middle.y + dy}), snapped(radius)});
  });
  return discs;
}

// Radii from 0.92 to 0.98 of half the distance of neighbours.
std::vector<Disc> packed_discs(std::size_t n, Random& random) {
  std::vector<Disc> discs;
  for_cells(n, [&](const Xy& middle) {
    discs.push_back({snapped(turned(middle)), snapped(kTurnedSize * random.uniform(0.46, kCell))});
  });
  return discs;
}

// A square at each level but the last is split with probability 1/4, so that all levels hold about as many squares.
std::vector<Disc> sized_discs(std::size_t n, Random& random) {
  struct Square {
    Xy low;
    double side;
    int level;
  };
  const std::size_t columns = root_of(static_cast<std::size_t>(static_cast<double>(n) / kLeavesOfRoot) + 1);
  std::vector<Disc> discs;
  std::vector<Square> open;
  for (std::size_t root = 0; discs.size() < n; ++root) {
    open.push_back({{static_cast<double>(root % columns), static_cast<double>(root / columns)}, 1, 0});
    while (!open.empty() && discs.size() < n) {
      const Square square = open.back();
      open.pop_back();
      const double half = square.side / 2;
      if (square.level < kLevels && random.below(4) == 0) {
        for (const auto& [x, y] : {Xy{0, 0}, Xy{0, 1}, Xy{1, 0}, Xy{1, 1}}) {
          open.push_back({{square.low.x + x * half, square.low.y + y * half}, half, square.level + 1});
        }
        continue;
      }
      const double radius = square.side * random.uniform(0.3, kCell), room = kCell * square.side - radius;
      const double dx = random.uniform(-room, room), dy = random.uniform(-room, room);
      const Xy center{square.low.x + half + dx, square.low.y + half + dy};
      discs.push_back({snapped(turned(center)), snapped(kTurnedSize * radius)});
    }
    open.clear();
  }
  return discs;
}

std::vector<Disc> one_disc(std::size_t n, Random& random) {
  std::vector<Disc> discs = spread_discs(n - 1, random);
  const Disc met = discs[random.below(discs.size())];
  const double angle = random.uniform(0, 2 * kPi);
  discs.push_back({snapped({met.center.x + met.radius * std::cos(angle), met.center.y + met.radius * std::sin(angle)}),
                   snapped(0.008)});
  return discs;
}

// At N discs of mean radius r in an area of N, there are about N (4 r^2) pi / 2 contacts; fewer at the rim.
std::vector<Disc> crowded_discs(std::size_t n, Random& random) {
  const double side = std::sqrt(static_cast<double>(n));
  std::vector<Disc> discs;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.uniform(0, side), y = random.uniform(0, side), radius = random.uniform(0.2, 0.6);
    discs.push_back({snapped({x, y}), snapped(radius)});
  }
  return discs;
}

// --- Polygons --------------------------------------------------------------------------------------------------------

constexpr std::size_t kCoinVertices = 16;
constexpr double kLength = 4;  // of a needle, in widths

// Vertices on an ellipse, turned by an eighth: convex.
Ring coin(const Xy& middle, double half_length, double half_width, Random& random) {
  Ring ring;
  for (const double angle : jittered_angles(kCoinVertices, 0.3, random)) {
    const Xy p = turned({half_length * std::cos(angle), half_width * std::sin(angle)});
    ring.push_back(snapped({middle.x + p.x, middle.y + p.y}));
  }
  return ring;
}

Ring coin_in(const Disc& disc, Random& random) {
  const double radius = disc.radius / kTurnedSize;
  return coin(disc.center, radius, radius, random);
}

std::vector<Ring> coins_in(const std::vector<Disc>& discs, Random& random) {
  std::vector<Ring> rings;
  for (const Disc& disc : discs) rings.push_back(coin_in(disc, random));
  return rings;
}

std::vector<Ring> needles(std::size_t n, Random& random) {
  const std::size_t columns = root_of(1 + n / static_cast<std::size_t>(kLength));
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < n; ++i) {
    const Xy middle{kLength * (static_cast<double>(i % columns) + 0.5), static_cast<double>(i / columns) + 0.5};
    rings.push_back(coin(turned(middle), kLength * kCell, kCell, random));
  }
  return rings;
}

// Vertices alternate between an outer and an inner radius.
Ring star_in(const Disc& disc, Random& random) {
  const double inner = disc.radius * random.uniform(0.3, 0.6);
  Ring ring;
  for (const double angle : jittered_angles(8 + 2 * random.below(29), 0.3, random)) {
    const double radius = ring.size() % 2 == 0 ? disc.radius * random.uniform(0.8, 1) : inner;
    ring.push_back(snapped({disc.center.x + radius * std::cos(angle), disc.center.y + radius * std::sin(angle)}));
  }
  return ring;
}

std::vector<Ring> stars(std::size_t n, Random& random) {
  std::vector<Ring> rings;
  for (const Disc& disc : packed_discs(n, random)) rings.push_back(star_in(disc, random));
  return rings;
}

// The cells of a jittered grid, whose sides are wiggly lines that neighbours share, shrunk towards their middles: they
// are star-shaped, seen from there.
std::vector<Ring> tracts(std::size_t n, Random& random) {
  constexpr std::size_t pieces = 8;  // of a side
  constexpr double jitter = 0.15, wiggle = 0.02, shrink = 0.98;
  const std::size_t side = root_of(n), corners = side + 1;
  std::vector<Xy> corner;
  for (std::size_t i = 0; i < corners * corners; ++i) {
    const double dx = random.uniform(-jitter, jitter), dy = random.uniform(-jitter, jitter);
    corner.push_back({static_cast<double>(i % corners) + dx, static_cast<double>(i / corners) + dy});
  }
  // The inner points of the sides to the right of each corner, and upwards from each.
  std::array<std::vector<Xy>, 2> inner;
  for (std::size_t i = 0; i < corners * corners; ++i) {
    for (std::size_t up = 0; up < 2; ++up) {
      const std::size_t j = std::min(i + (up == 0 ? 1 : corners), corner.size() - 1);
      for (std::size_t k = 1; k < pieces; ++k) {
        const double t = static_cast<double>(k) / pieces;
        const double dx = random.uniform(-wiggle, wiggle), dy = random.uniform(-wiggle, wiggle);
        inner[up].push_back(
            {corner[i].x + t * (corner[j].x - corner[i].x) + dx, corner[i].y + t * (corner[j].y - corner[i].y) + dy});
      }
    }
  }
  std::vector<Ring> rings;
  for (std::size_t cell = 0; cell < n; ++cell) {
    const std::size_t at = cell / side * corners + cell % side;
    Ring& ring = rings.emplace_back();
    const auto add_side = [&](std::size_t from, std::size_t up, bool backwards, std::size_t first) {
      ring.push_back(corner[first]);
      for (std::size_t k = 1; k < pieces; ++k) {
        ring.push_back(inner[up][from * (pieces - 1) + (backwards ? pieces - k : k) - 1]);
      }
    };
    add_side(at, 0, false, at);
    add_side(at + 1, 1, false, at + 1);
    add_side(at + corners, 0, true, at + corners + 1);
    add_side(at, 1, true, at + corners);
    Xy middle;
    for (const std::size_t c : {at, at + 1, at + corners, at + corners + 1}) {
      middle = {middle.x + corner[c].x / 4, middle.y + corner[c].y / 4};
    }
    for (Xy& p : ring) p = snapped({middle.x + shrink * (p.x - middle.x), middle.y + shrink * (p.y - middle.y)});
  }
  return rings;
}

// A tiny one across a vertex of any of them; it stays in the cell of that.
void add_contact(std::vector<Ring>& rings, Random& random) {
  const Ring& met = rings[random.below(rings.size())];
  const Xy at = met[random.below(met.size())];
  rings.push_back(coin(at, 0.005, 0.005, random));
}

SetInput make_input(SetFamily family, std::size_t n, Random& random) {
  SetInput input;
  switch (family) {
    case SetFamily::spread_discs: input.discs = spread_discs(n, random); break;
    case SetFamily::packed_discs: input.discs = packed_discs(n, random); break;
    case SetFamily::sized_discs: input.discs = sized_discs(n, random); break;
    case SetFamily::one_disc: input.discs = one_disc(n, random); break;
    case SetFamily::crowded_discs: input.discs = crowded_discs(n, random); break;
    case SetFamily::coins: input.rings = coins_in(packed_discs(n, random), random); break;
    case SetFamily::needles: input.rings = needles(n, random); break;
    case SetFamily::one_in_coins: input.rings = coins_in(packed_discs(n - 1, random), random); break;
    case SetFamily::one_in_needles: input.rings = needles(n - 1, random); break;
    case SetFamily::crowded_coins: input.rings = coins_in(crowded_discs(n, random), random); break;
    case SetFamily::stars: input.rings = stars(n, random); break;
    case SetFamily::tracts: input.rings = tracts(n, random); break;
    case SetFamily::one_in_stars: input.rings = stars(n - 1, random); break;
    case SetFamily::one_in_tracts: input.rings = tracts(n - 1, random); break;
    case SetFamily::inside_star: {
      std::vector<Disc> discs = packed_discs(n - 1, random);
      for (const Disc& disc : discs) input.rings.push_back(star_in(disc, random));
      input.rings.push_back(coin_in({discs[random.below(discs.size())].center, 0.005}, random));
      break;
    }
  }
  if (family == SetFamily::one_in_coins || family == SetFamily::one_in_needles || family == SetFamily::one_in_stars ||
      family == SetFamily::one_in_tracts) {
    add_contact(input.rings, random);
  }
  shuffle(input.discs, random);
  shuffle(input.rings, random);
  return input;
}

// Is it luck how soon the only contact is found?
bool is_one(SetFamily family) {
  switch (family) {
    case SetFamily::one_disc:
    case SetFamily::one_in_coins:
    case SetFamily::one_in_needles:
    case SetFamily::one_in_stars:
    case SetFamily::one_in_tracts:
    case SetFamily::inside_star: return true;
    default: return false;
  }
}

bool as_promised(SetFamily family, std::uint64_t pairs, std::size_t n) {
  if (is_one(family)) return pairs == 1;
  if (family == SetFamily::crowded_discs || family == SetFamily::crowded_coins) return pairs >= n / 2 && pairs <= 2 * n;
  return pairs == 0;
}

}  // namespace

std::string_view name_of(SetFamily family) {
  constexpr std::array<std::string_view, 15> names{
      "spread discs", "packed discs",    "discs of all sizes", "one among discs",   "crowded discs",
      "coins",        "needles",         "one among coins",    "one among needles", "stars",
      "tracts",       "one among stars", "one among tracts",   "one inside a star", "crowded coins"};
  return names.at(static_cast<std::size_t>(family));
}

std::vector<SetInput> make_set_inputs(SetFamily family, std::size_t n, std::uint64_t seed) {
  Random random(1000 * seed + static_cast<std::uint64_t>(family));
  std::vector<SetInput> inputs;
  const std::size_t least = !is_one(family) ? 1 : n <= kSmall ? 9 : 2;
  const std::size_t count_of_inputs = std::clamp<std::size_t>(kEnough / n, least, kMostInputs);
  for (std::size_t i = 0; i < count_of_inputs; ++i) {
    SetInput& input = inputs.emplace_back(make_input(family, n, random));
    input.pairs = count_pairs(input.discs) + count_pairs(input.rings);
    if (!as_promised(family, input.pairs, n)) {
      throw std::logic_error(std::string(name_of(family)) + ", " + std::to_string(n) +
                             " objects: " + std::to_string(input.pairs) + " pairs meet, which is not what it promises");
    }
  }
  return inputs;
}

}  // namespace bench
