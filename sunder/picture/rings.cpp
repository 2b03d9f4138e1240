#include <sunder/picture/density.h>
#include <sunder/picture/rings.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace sunder::picture {

namespace {

constexpr double radius = 9, label_height = 16, label_letter_width = 7.3, gap = 3;  // pixels
constexpr double row_height = 2 * radius + gap;
constexpr std::size_t most_letters = 9, most_told = 5, most_ringed = 10'000;
constexpr double widest =
    2 * radius + 2 * gap + label_letter_width * (most_letters + 1);  // a ring with its label is no wider

struct Numbered {
  std::uint32_t number;
  std::size_t kind;
  friend auto operator<=>(const Numbered&, const Numbered&) = default;
};

struct Ring {
  Point2 at;                       // of its first contact
  double right;                    // where a label on the right must end
  std::vector<Numbered> contacts;  // not sorted
  std::uint32_t low, high;         // the first and the last number of them

  std::string label() const {
    if (contacts.size() == 1) return fmt::format("{}", low + 1);
    const bool is_pair = contacts.size() == 2, is_run = high - low + 1 == contacts.size();
    const std::string numbers = fmt::format("{}{}{}", low + 1, is_pair ? ", " : "-", high + 1);
    return (is_pair || is_run) && numbers.size() <= most_letters ? numbers : fmt::format("{}\xc3\x97", contacts.size());
  }
  bool is_counted() const { return label().ends_with("\xc3\x97"); }  // its label tells how many they are
  bool is_mixed() const {
    return std::any_of(contacts.begin(), contacts.end(), [&](const Numbered& c) { return c.kind != contacts[0].kind; });
  }

  double label_width() const {
    return label_letter_width * static_cast<double>(label().size() - (is_counted() ? 1 : 0));
  }
  // On the right of the ring, or on the left if it would leave the picture.
  double label_left() const {
    const double beside = radius + gap, width = label_width();
    return at.x + beside + width < right ? at.x + beside : at.x - beside - width;
  }
  // Both ends of the ring with its label.
  std::pair<double, double> extent() const {
    const double left = label_left();
    return {std::min(at.x - radius, left), std::max(at.x + radius, left + label_width())};
  }

  void join(Ring other) {
    if (other.low < low) std::swap(*this, other);
    high = std::max(high, other.high);
    if (contacts.size() < other.contacts.size()) contacts.swap(other.contacts);
    contacts.insert(contacts.end(), other.contacts.begin(), other.contacts.end());
  }
};

using Rings = std::map<std::pair<long, double>, Ring>;  // by row and x; no two overlap

Rings::iterator nearest_overlapped(Rings& rings, const Ring& ring) {
  const long row = std::lround(ring.at.y / row_height);
  const auto [left, right] = ring.extent();
  auto found = rings.end();
  double least = std::numeric_limits<double>::infinity();
  for (long r = row - 1; r <= row + 1; ++r) {
    const auto end = rings.upper_bound({r, ring.at.x + 2 * widest});
    for (auto other = rings.lower_bound({r, ring.at.x - 2 * widest}); other != end; ++other) {
      const Point2& at = other->second.at;
      const double away = std::hypot(ring.at.x - at.x, ring.at.y - at.y);
      if (away >= least || std::fabs(ring.at.y - at.y) >= row_height) continue;
      const auto [its_left, its_right] = other->second.extent();
      if (left >= its_right + gap || its_left >= right + gap) continue;
      found = other;
      least = away;
    }
  }
  return found;
}

// A ring that would lie over others is joined with the nearest of them, until there is none.
void add(Rings& rings, Ring ring) {
  for (auto over = nearest_overlapped(rings, ring); over != rings.end(); over = nearest_overlapped(rings, ring)) {
    ring.join(std::move(over->second));
    rings.erase(over);
  }
  const std::pair place(std::lround(ring.at.y / row_height), ring.at.x);
  rings.emplace(place, std::move(ring));
}

std::string text_of(const Ring& ring, std::span<const RingKind> kinds,
                    const std::function<std::string(std::uint32_t)>& tell) {
  std::vector<Numbered> contacts = ring.contacts;
  std::sort(contacts.begin(), contacts.end());
  std::vector<std::string> told;
  if (contacts.size() > 1) {
    std::vector<std::string> counts;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const auto n = std::count_if(contacts.begin(), contacts.end(), [&](const Numbered& c) { return c.kind == k; });
      if (n > 0) counts.push_back(fmt::format("{} {}", n, kinds[k].name));
    }
    told.push_back(fmt::format("{} contacts: {}", contacts.size(), fmt::join(counts, ", ")));
  }
  const std::size_t listed = std::min(contacts.size(), most_told);
  for (std::size_t k = 0; k < listed; ++k) told.push_back(xml_text(tell(contacts[k].number)));
  if (contacts.size() > listed) told.push_back(fmt::format("and {} more", contacts.size() - listed));
  return fmt::format(
      "<g class='m {}'><title>{}</title><circle cx='{:.1f}' cy='{:.1f}' r='{}'/>"
      "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{}' rx='3'/><text x='{:.1f}' y='{:.1f}'>{}</text></g>\n",
      class_of(ring.is_mixed() ? Ink::dark : kinds[contacts[0].kind].ink), fmt::join(told, "\n"), ring.at.x, ring.at.y,
      radius, ring.label_left(), ring.at.y - label_height / 2, ring.label_width(), label_height, ring.label_left() + 1,
      ring.at.y + 4.3, ring.label());
}

void draw_density(Canvas& canvas, std::span<const RingContact> contacts, std::span<const RingKind> kinds) {
  Point2 size;
  for (const RingContact& c : contacts) size = {std::max(size.x, c.at.x), std::max(size.y, c.at.y)};
  std::vector<Density> crowds(kinds.size(), Density(size.x, size.y));
  for (const RingContact& c : contacts) crowds[c.kind].add(c.at);
  std::uint32_t most = 0;
  for (std::size_t k = kinds.size(); k-- > 0;) {  // the first kind over the others
    canvas.add(crowds[k].xml(fmt::format("class='{}'", class_of(kinds[k].ink))));
    most = std::max(most, crowds[k].most());
  }
  canvas.note(fmt::format("Too many contacts for rings: darker squares have more of them, up to {}.", most));
}

}  // namespace

void draw_rings(Canvas& canvas, std::span<const RingContact> contacts, std::span<const RingKind> kinds, double right,
                const std::function<std::string(std::uint32_t)>& tell) {
  if (contacts.empty()) return;
  if (contacts.size() > most_ringed) return draw_density(canvas, contacts, kinds);
  std::set<std::pair<long, long>> dots;  // whole pixels
  Rings rings;
  for (const auto& [at, number, kind] : contacts) {
    dots.insert({std::lround(at.x), std::lround(at.y)});
    add(rings, {at, right, {{number, kind}}, number, number});
  }
  canvas.add("<path stroke='#1f2a3a' stroke-width='2.6' stroke-linecap='round' d='");
  for (const auto& [x, y] : dots) canvas.add(fmt::format("M{} {}h0", x, y));
  canvas.add("'/>\n");
  bool some_counted = false, some_mixed = false;
  for (const auto& [place, ring] : rings) {
    canvas.add(text_of(ring, kinds, tell));
    some_counted = some_counted || ring.is_counted();
    some_mixed = some_mixed || ring.is_mixed();
  }
  if (some_counted) {
    canvas.note(
        "5\xc3\x97: five contacts whose rings would lie over each other. Dots are the places of all; pointing at the "
        "ring tells about the first.");
  }
  if (some_mixed) canvas.note("Dark rings stand for contacts of several kinds.");
}

}  // namespace sunder::picture
