#include <bench/inputs/segment_count.h>
#include <bench/inputs/segment_scenarios.h>

#include <tests/support/shapes.h>

#include <sunder/base/random.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bench {
namespace {

using sunder::Random;
using sunder::tests::shuffle;
namespace tests = sunder::tests;

constexpr double kPi = 3.141592653589793;
constexpr double kJitter = 0.24;    // of a grid's vertex; below 1/4, edges meet at shared ends only
constexpr double kTipJitter = 4.9;  // of a tangled star's tip, in spaces between vertices; found by trial: N crossings
constexpr std::size_t kEnough = 20000;  // segments in all inputs of a family and size together
constexpr std::size_t kMostInputs = 64;

double snapped(double v) { return tests::snapped(v, 40); }
Xy snapped(const Xy& p) { return {snapped(p.x), snapped(p.y)}; }

struct Grid {
  std::size_t columns, rows;
  std::vector<Xy> points;  // row by row
  const Xy& at(std::size_t x, std::size_t y) const { return points[y * columns + x]; }
};

Grid jittered_grid(std::size_t columns, std::size_t rows, Random& random) {
  Grid grid{columns, rows, {}};
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const double dx = random.uniform(-kJitter, kJitter), dy = random.uniform(-kJitter, kJitter);
      grid.points.push_back(snapped({static_cast<double>(x) + dx, static_cast<double>(y) + dy}));
    }
  }
  return grid;
}

// n edges of the smallest square grid that has so many.
std::vector<Line> mesh(std::size_t n, Random& random) {
  std::size_t side = 2;
  while (2 * side * (side - 1) < n) ++side;
  const Grid grid = jittered_grid(side, side, random);
  std::vector<Line> lines;
  for (std::size_t y = 0; y < side; ++y) {
    for (std::size_t x = 0; x < side; ++x) {
      if (x + 1 < side) lines.push_back({grid.at(x, y), grid.at(x + 1, y)});
      if (y + 1 < side) lines.push_back({grid.at(x, y), grid.at(x, y + 1)});
    }
  }
  shuffle(lines, random);
  lines.resize(n);
  return lines;
}

Xy between(const Line& l, double t) { return snapped({l.a.x + t * (l.b.x - l.a.x), l.a.y + t * (l.b.y - l.a.y)}); }

void shrink(std::vector<Line>& lines) {
  for (Line& l : lines) l = {between(l, 0.05), between(l, 0.95)};
}

// A short segment across the middle of another.
Line across(const Line& l) {
  const double x = (l.a.x + l.b.x) / 2, y = (l.a.y + l.b.y) / 2, dx = (l.b.x - l.a.x) / 50, dy = (l.b.y - l.a.y) / 50;
  return {snapped({x - dy, y + dx}), snapped({x + dy, y - dx})};
}

// At the end: of the list, too, so that whoever goes by numbers is late as well.
std::vector<Line> hidden(std::size_t n, bool at_end, Random& random) {
  std::vector<Line> lines = mesh(n - 1, random);
  if (!at_end) {
    lines.push_back(across(lines[random.below(lines.size())]));
    std::swap(lines.back(), lines[random.below(lines.size())]);
    return lines;
  }
  const auto begins_before = [](const Line& s, const Line& t) {
    return std::min(s.a.x, s.b.x) < std::min(t.a.x, t.b.x);
  };
  std::iter_swap(std::max_element(lines.begin(), lines.end(), begins_before), lines.end() - 1);
  lines.push_back(across(lines.back()));
  return lines;
}

// n vertices at increasing angles, tips at the odd ones. Tips are moved sideways by up to tip_jitter spaces.
std::vector<Xy> star(std::size_t n, double tip_jitter, Random& random) {
  std::vector<Xy> ring;
  for (std::size_t i = 0; i < n; ++i) {
    const bool tip = i % 2 != 0;
    const double wanted = tip ? tip_jitter : 0.3, move = random.uniform(-wanted, wanted);
    const double angle = 2 * kPi * (static_cast<double>(i) + 0.5 + move) / static_cast<double>(n);
    const double radius = tip ? random.uniform(0.9, 1) : random.uniform(0.01, 0.02);
    ring.push_back(snapped({radius * std::cos(angle), radius * std::sin(angle)}));
  }
  return ring;
}

// Along the lowest row, and back up and down the columns, from the last to the first.
std::vector<Xy> meander(std::size_t n, Random& random) {
  const std::size_t columns = 2 * static_cast<std::size_t>(std::sqrt(static_cast<double>(n)) / 2), rows = n / columns;
  const Grid grid = jittered_grid(columns, rows, random);
  std::vector<Xy> ring;
  for (std::size_t x = 0; x < columns; ++x) ring.push_back(grid.at(x, 0));
  for (std::size_t x = columns; x-- > 0;) {
    const bool up = (columns - x) % 2 != 0;
    for (std::size_t y = 1; y < rows; ++y) ring.push_back(grid.at(x, up ? y : rows - y));
  }
  return ring;
}

std::vector<Line> edges(const std::vector<Xy>& ring) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < ring.size(); ++i) lines.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return lines;
}

// Horizontals at heights of their own in one square, verticals in the next. Ends have one of four abscissas, so that
// many events of a sweep tie.
std::vector<Line> wires(std::size_t n, Random& random) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = snapped(static_cast<double>(i) / static_cast<double>(n));
    const double from = static_cast<double>(random.below(4)) / 16, to = 1 - static_cast<double>(random.below(4)) / 16;
    lines.push_back(i % 2 == 0 ? Line{{from, at}, {to, at}} : Line{{2 + at, from}, {2 + at, to}});
  }
  shuffle(lines, random);
  return lines;
}

std::vector<Line> coastline(std::size_t n, const std::vector<Line>& map, Random& random) {
  constexpr double width = 512, height = 256;  // of the place for a copy, in degrees
  if (map.empty()) throw std::logic_error("there is no map");
  std::vector<Line> lines;
  std::size_t next = n < map.size() ? random.below(map.size() - n) : 0;
  for (std::size_t copy = 0; lines.size() < n; next = 0, ++copy) {
    const double dx = width * static_cast<double>(copy % 5), dy = height * static_cast<double>(copy / 5);
    for (; next < map.size() && lines.size() < n; ++next) {
      const auto [a, b] = map[next];
      lines.push_back({snapped({a.x + dx, a.y + dy}), snapped({b.x + dx, b.y + dy})});
    }
  }
  return lines;
}

// Segments of one length, their middles anywhere in a square.
void add_random(std::vector<Line>& lines, std::size_t n, double side, double length, Random& random) {
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.uniform(0, side), y = random.uniform(0, side), angle = random.uniform(0, kPi);
    const double dx = length / 2 * std::cos(angle), dy = length / 2 * std::sin(angle);
    lines.push_back({snapped({x - dx, y - dy}), snapped({x + dx, y + dy})});
  }
}

// Where D segments of length L per unit area lie at random, there are D^2 L^2 / pi crossings per unit area; edges of a
// mesh of unit cells cross a segment 4 L / pi times. (Fewer at the rim, which counts where N is small.)
std::vector<Line> crossed_mesh(std::size_t n, Random& random) {
  std::vector<Line> lines = mesh(n / 2, random);
  const double side = std::sqrt(static_cast<double>(n) / 4);
  add_random(lines, n - n / 2, side, std::sqrt(1 + kPi) - 1, random);
  shuffle(lines, random);
  return lines;
}

std::vector<Line> random_lines(std::size_t n, Random& random) {
  std::vector<Line> lines;
  add_random(lines, n, std::sqrt(static_cast<double>(n)), std::sqrt(10 * kPi), random);
  return lines;
}

SegmentInput make_input(SegmentFamily family, std::size_t n, Random& random, const std::vector<Line>& map) {
  SegmentInput input;
  input.shared_ends = true;
  switch (family) {
    case SegmentFamily::loose_mesh: input.shared_ends = false; [[fallthrough]];
    case SegmentFamily::mesh: input.lines = mesh(n, random); break;
    case SegmentFamily::loose_star: input.shared_ends = false; [[fallthrough]];
    case SegmentFamily::star: input.ring = star(n, 0.3, random); break;
    case SegmentFamily::tangled_star: input.ring = star(n, kTipJitter, random); break;
    case SegmentFamily::meander: input.ring = meander(n, random); break;
    case SegmentFamily::map: input.lines = coastline(n, map, random); break;
    case SegmentFamily::hidden_end: input.lines = hidden(n, true, random); break;
    case SegmentFamily::hidden_random: input.lines = hidden(n, false, random); break;
    case SegmentFamily::crossed_mesh: input.lines = crossed_mesh(n, random); break;
    case SegmentFamily::wires:
      input.shared_ends = false;
      input.lines = wires(n, random);
      break;
    case SegmentFamily::random:
      input.shared_ends = false;
      input.lines = random_lines(n, random);
      break;
  }
  if (!input.ring.empty()) input.lines = edges(input.ring);
  if (family == SegmentFamily::loose_mesh || family == SegmentFamily::loose_star) shrink(input.lines);
  if (family == SegmentFamily::loose_star) input.ring.clear();
  return input;
}

std::uint64_t count(SegmentFamily family, const SegmentInput& input) {
  switch (family) {
    case SegmentFamily::wires: return 0;  // each at a height, or an abscissa, of its own
    case SegmentFamily::star:
    case SegmentFamily::loose_star:
    case SegmentFamily::tangled_star: return count_by_angle(input.lines, input.shared_ends);
    default: return count_by_grid(input.lines, input.shared_ends);
  }
}

bool as_promised(SegmentFamily family, std::uint64_t pairs, std::size_t n) {
  switch (family) {
    case SegmentFamily::hidden_end:
    case SegmentFamily::hidden_random: return pairs == 1;
    case SegmentFamily::crossed_mesh:
    case SegmentFamily::tangled_star: return pairs >= n / 2 && pairs <= 2 * n;
    case SegmentFamily::random: return pairs >= 5 * n && pairs <= 20 * n;
    default: return pairs == 0;
  }
}

}  // namespace

std::string_view name_of(SegmentFamily family) {
  constexpr std::array<std::string_view, 12> names{"mesh",    "loose mesh",   "star",       "loose star",
                                                   "map",     "wires",        "hidden end", "hidden random",
                                                   "meander", "crossed mesh", "random",     "tangled star"};
  return names.at(static_cast<std::size_t>(family));
}

std::vector<SegmentInput> make_segment_inputs(SegmentFamily family, std::size_t n, std::uint64_t seed,
                                              const std::vector<Line>& map) {
  Random random(1000 * seed + static_cast<std::uint64_t>(family));
  std::vector<SegmentInput> inputs;
  const std::size_t count_of_inputs = std::clamp<std::size_t>(kEnough / n, 1, kMostInputs);
  for (std::size_t i = 0; i < count_of_inputs; ++i) {
    SegmentInput& input = inputs.emplace_back(make_input(family, n, random, map));
    input.pairs = count(family, input);
    if (!as_promised(family, input.pairs, n)) {
      throw std::logic_error(std::string(name_of(family)) + ", " + std::to_string(n) + " segments: " +
                             std::to_string(input.pairs) + " pairs meet, which is not what it promises");
    }
  }
  return inputs;
}

std::vector<Line> rounded(std::vector<Line> lines) {
  for (Line& l : lines) l = {snapped(l.a), snapped(l.b)};
  return lines;
}

}  // namespace bench
