#include <sunder/picture/rings.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::picture {

namespace {

constexpr double radius = 9, label_height = 16, letter_width = 7.3, gap = 3;  // pixels
constexpr double row_height = 2 * radius + gap;
constexpr std::size_t most_letters = 9, most_told = 5;
constexpr double widest =
    2 * radius + 2 * gap + letter_width * (most_letters + 1);  // a ring with its label is no wider

}  // namespace

bool Rings::Ring::is_mixed() const {
  return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) { return c.kind != contacts[0].kind; });
}

std::string Rings::Ring::label() const {
  if (contacts.size() == 1) return fmt::format("{}", low + 1);
  const bool is_pair = contacts.size() == 2, is_run = high - low + 1 == contacts.size();
  const std::string numbers = fmt::format("{}{}{}", low + 1, is_pair ? ", " : "-", high + 1);
  return (is_pair || is_run) && numbers.size() <= most_letters ? numbers : fmt::format("{}\xc3\x97", contacts.size());
}

// Does its label tell how many they are?
bool Rings::Ring::is_counted() const { return label().ends_with("\xc3\x97"); }

// The label is on the right of the ring, or on the left if it would leave the picture.
Rings::Extent Rings::extent_of(const Ring& ring) const {
  const double width = letter_width * static_cast<double>(ring.label().size() - (ring.is_counted() ? 1 : 0));
  const double beside = radius + gap;
  return ring.at.x + beside + width < right_
             ? Extent{ring.at.x - radius, ring.at.x + beside + width, ring.at.x + beside, width}
             : Extent{ring.at.x - beside - width, ring.at.x + radius, ring.at.x - beside - width, width};
}

std::map<Rings::Place, Rings::Ring>::iterator Rings::nearest_overlapped(const Ring& ring) {
  const long row = std::lround(ring.at.y / row_height);
  const Extent own = extent_of(ring);
  auto found = rings_.end();
  double least = std::numeric_limits<double>::infinity();
  for (long r = row - 1; r <= row + 1; ++r) {
    const auto end = rings_.upper_bound({r, ring.at.x + 2 * widest});
    for (auto other = rings_.lower_bound({r, ring.at.x - 2 * widest}); other != end; ++other) {
      const Point2& at = other->second.at;
      const double away = std::hypot(ring.at.x - at.x, ring.at.y - at.y);
      if (away >= least || std::fabs(ring.at.y - at.y) >= row_height) continue;
      const Extent its = extent_of(other->second);
      if (own.left >= its.right + gap || its.left >= own.right + gap) continue;
      found = other;
      least = away;
    }
  }
  return found;
}

// One that would lie over others is joined with the nearest of them, until there is none.
void Rings::add(const Point2& pixel, std::uint32_t number, std::size_t kind) {
  dots_.insert({std::lround(pixel.x), std::lround(pixel.y)});
  Ring ring{pixel, {{number, static_cast<std::uint32_t>(kind)}}, number, number};
  for (auto over = nearest_overlapped(ring); over != rings_.end(); over = nearest_overlapped(ring)) {
    Ring other = std::move(over->second);
    rings_.erase(over);
    if (other.low < ring.low) std::swap(ring, other);
    ring.high = std::max(ring.high, other.high);
    if (ring.contacts.size() < other.contacts.size()) ring.contacts.swap(other.contacts);
    ring.contacts.insert(ring.contacts.end(), other.contacts.begin(), other.contacts.end());
  }
  rings_.emplace(Place{std::lround(ring.at.y / row_height), ring.at.x}, std::move(ring));
}

std::string Rings::text_of(const Ring& ring, const std::function<std::string(std::uint32_t)>& tell) const {
  std::vector<Contact> contacts = ring.contacts;
  std::sort(contacts.begin(), contacts.end());
  std::vector<std::string> told;
  if (contacts.size() > 1) {
    std::vector<std::string> kinds;
    for (std::uint32_t kind = 0; kind < kinds_.size(); ++kind) {
      const auto n = std::count_if(contacts.begin(), contacts.end(), [&](const Contact& c) { return c.kind == kind; });
      if (n > 0) kinds.push_back(fmt::format("{} {}", n, kinds_[kind].name));
    }
    told.push_back(fmt::format("{} contacts: {}", contacts.size(), fmt::join(kinds, ", ")));
  }
  const std::size_t listed = std::min(contacts.size(), most_told);
  for (std::size_t k = 0; k < listed; ++k) told.push_back(xml_text(tell(contacts[k].number)));
  if (contacts.size() > listed) told.push_back(fmt::format("and {} more", contacts.size() - listed));
  const Extent extent = extent_of(ring);
  return fmt::format(
      "<g class='m {}'><title>{}</title><circle cx='{:.1f}' cy='{:.1f}' r='{}'/>"
      "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{}' rx='3'/><text x='{:.1f}' y='{:.1f}'>{}</text></g>\n",
      class_of(ring.is_mixed() ? Ink::dark : kinds_[contacts[0].kind].ink), fmt::join(told, "\n"), ring.at.x, ring.at.y,
      radius, extent.label_left, ring.at.y - label_height / 2, extent.label_width, label_height, extent.label_left + 1,
      ring.at.y + 4.3, ring.label());
}

std::string Rings::text(const std::function<std::string(std::uint32_t)>& tell) const {
  if (rings_.empty()) return "";
  std::string text = "<path stroke='#1f2a3a' stroke-width='2.6' stroke-linecap='round' d='";
  for (const auto& [x, y] : dots_) text += fmt::format("M{} {}h0", x, y);
  text += "'/>\n";
  for (const auto& [place, ring] : rings_) text += text_of(ring, tell);
  return text;
}

std::vector<std::string> Rings::notes() const {
  const auto some = [&](bool (Ring::*is)() const) {
    return std::any_of(rings_.begin(), rings_.end(), [&](const auto& entry) { return (entry.second.*is)(); });
  };
  std::vector<std::string> notes;
  if (some(&Ring::is_counted)) {
    notes.emplace_back(
        "5\xc3\x97: five contacts whose rings would lie over each other. Dots are the places of all; pointing at the "
        "ring tells about the first.");
  }
  if (some(&Ring::is_mixed)) notes.emplace_back("Dark rings stand for contacts of several kinds.");
  return notes;
}

}  // namespace sunder::picture
