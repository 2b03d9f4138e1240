#include <sunder/picture/plane.h>
#include <sunder/picture/segments.h>

#include <sunder/io/text/text.h>
#include <sunder/planar/pair/segment_segment.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace sunder::picture {

namespace {

using planar::ContactKind;
using planar::Segment;
using planar::SegmentsContact;

constexpr Sheet sheet{1600, 1200, false};
constexpr std::size_t most_classes = 8, most_bold = 5000, longest_name = 40, most_data = 6'000'000;

// The strongest first: it is drawn last, over the others.
constexpr std::array<ContactKind, 4> kinds{ContactKind::crossing, ContactKind::overlap, ContactKind::touch,
                                           ContactKind::shared_endpoint};
constexpr std::array<Ink, 4> inks{Ink::accent, Ink::third, Ink::bold, Ink::second};

// What is shown of a contact, or of a defect.
struct Shown {
  std::uint32_t i, j;
  std::size_t kind;  // a position in the picture's kinds
  Segment place;     // the common point, twice, or part
};

// Of classes of thin lines, in turns.
constexpr std::array<const char*, 6> calm_inks{"#66758c", "#b8965a", "#86a65c", "#a48fc0", "#5fa3ad", "#ad7564"};

// Path data of segments. Those that share an end with the one before become one line.
class SegmentsPath {
 public:
  explicit SegmentsPath(const PlanePicture& picture) : picture_(picture) {}

  // next: the segment that is added next, or null.
  void add(const Segment& s, const Segment* next) {
    if (is_open_ && (s.a == end_ || s.b == end_)) return line(s.a == end_ ? s.b : s.a);
    const auto is_of_next = [&](const Point2& p) { return next != nullptr && (p == next->a || p == next->b); };
    const bool backwards = is_of_next(s.a) && !is_of_next(s.b);
    data_.move(pixel(backwards ? s.b : s.a));
    is_open_ = true;
    line(backwards ? s.a : s.b);
  }

  const std::string& text() const { return data_.text(); }

 private:
  PathData::Tenths pixel(const Point2& p) const { return PathData::tenths(picture_.at(p)); }

  void line(const Point2& to) {
    end_ = to;
    data_.line(pixel(to));
  }

  const PlanePicture& picture_;
  PathData data_;
  bool is_open_ = false;
  Point2 end_;  // of the last segment added
};

std::vector<Point2> ends_of(const planar::Segments& segments) {
  std::vector<Point2> ends;
  for (const Segment& s : segments.all()) ends.insert(ends.end(), {s.a, s.b});
  return ends;
}

class SegmentsDrawing {
 public:
  explicit SegmentsDrawing(const SegmentsPicture& given)
      : given_(given),
        file_(given.file),
        segments_(given.segments),
        picture_(ends_of(segments_), {sheet.width, sheet.most_height, sheet.one_scale, given.y_down}) {
    for (const ContactKind kind : kinds) kinds_.push_back({inks.at(kinds_.size()), name_of(kind)});
    for (const SegmentsContact& c : given.contacts)
      shown_.push_back({c.i, c.j, kind_of(name_of(c.kind)), common_of(c)});
    if (!given.defects.empty()) kinds_.clear();
    for (const PicturedDefect& d : given.defects) shown_.push_back({d.i, d.j, kind_of(d.kind), d.place});
    count_.resize(kinds_.size());
    for (const Shown& shown : shown_) ++count_[shown.kind];
  }

  std::string text() {
    legend();
    lines();
    rings();
    return picture_.text(given_.title.empty() ? "Which of these segments meet?" : given_.title, summary());
  }

 private:
  // A new one has the next ink in turn.
  std::size_t kind_of(std::string_view name) {
    const auto at = std::find_if(kinds_.begin(), kinds_.end(), [&](const RingKind& kind) { return kind.name == name; });
    const auto position = static_cast<std::size_t>(at - kinds_.begin());
    if (at == kinds_.end()) kinds_.push_back({inks.at(position % inks.size()), name});
    return position;
  }

  std::string summary() const {
    std::string text = fmt::format("{} of {}", io::count_of(file_.segments.size(), "segment"),
                                   io::count_of(file_.features.size(), "feature"));
    if (!file_.layers.empty()) text += ", " + io::count_of(file_.layers.size(), "layer");
    if (!file_.groups.empty()) text += ", " + io::count_of(file_.groups.size(), "group");
    return text + "; " + given_.said;
  }

  // Thin lines are in classes: their names, and that of each segment; both empty if all are of one.
  using Classes = std::pair<std::span<const std::string>, std::span<const std::uint32_t>>;
  Classes classes() const {
    if (file_.layers.size() > 1) return {file_.layers, file_.layer};
    const bool some = file_.layers.empty() && file_.groups.size() > 1 && file_.groups.size() <= most_classes;
    return some ? Classes(file_.groups, file_.group) : Classes();
  }

  void legend() {
    for (std::size_t k = 0; k < kinds_.size() && !shown_.empty(); ++k) {
      picture_.legend(fmt::format("<g class='m {}'><circle cx='10' r='9'/></g>", class_of(kinds_[k].ink)),
                      fmt::format("{} {}", kinds_[k].name, count_[k]), count_[k] == 0);
    }
    const auto [names, of_segment] = classes();
    for (std::size_t k = 0; k < std::min(names.size(), most_classes); ++k) {
      picture_.legend(
          fmt::format("<path d='M0 0h20' stroke-width='3' stroke='{}'/>", calm_inks.at(k % calm_inks.size())),
          shortened(names[k], 24));
    }
    if (names.size() > most_classes) picture_.legend("", fmt::format("and {} more", names.size() - most_classes));
  }

  void path(const std::string& attributes, const std::string& data) {
    if (!data.empty()) picture_.add(fmt::format("<path {} d='{}'/>\n", attributes, data));
  }

  std::string data_of(const std::vector<std::uint32_t>& members) const {
    SegmentsPath data(picture_);
    for (std::size_t k = 0; k < members.size(); ++k) {
      data.add(segments_[members[k]], k + 1 < members.size() ? &segments_[members[k + 1]] : nullptr);
    }
    return data.text();
  }

  void lines() {
    const auto [names, of_segment] = classes();
    std::vector<std::vector<std::uint32_t>> members(std::max(names.size(), std::size_t{1}));
    for (std::uint32_t i = 0; i < segments_.size(); ++i) members[names.empty() ? 0 : of_segment[i]].push_back(i);
    std::vector<std::string> data;
    std::size_t size = 0;
    for (const auto& some : members) size += data.emplace_back(data_of(some)).size();
    if (size > most_data) crowds(members);
    picture_.add("<g transform='scale(.1)' fill='none' stroke-linejoin='round' stroke-linecap='round'>\n");
    const int thin = segments_.size() <= 200 ? 16 : segments_.size() <= 5000 ? 11 : 8;
    for (std::size_t k = 0; k < members.size() && size <= most_data; ++k) {
      path(fmt::format("stroke='{}' stroke-width='{}'", calm_inks.at(k % calm_inks.size()), thin), data[k]);
    }
    std::vector<std::set<std::uint32_t>> bold(kinds_.size());
    SegmentsPath bands(picture_);
    for (std::size_t k = 0; k < shown_.size() && k < most_bold; ++k) {
      const auto& [i, j, kind, place] = shown_[k];
      bold[kind].insert({i, j});
      if (place.a != place.b) bands.add(place, nullptr);
    }
    for (std::size_t k = kinds_.size(); k-- > 0;) {
      path(fmt::format("class='{}' stroke-width='22'", class_of(kinds_[k].ink)),
           data_of({bold[k].begin(), bold[k].end()}));
    }
    path(fmt::format("class='{}' stroke-width='70' stroke-opacity='.5'", class_of(Ink::third)), bands.text());
    picture_.add("</g>\n");
  }

  // What is too much for viewers: of each class where its segments are.
  void crowds(const std::vector<std::vector<std::uint32_t>>& members) {
    for (std::size_t k = 0; k < members.size(); ++k) {
      Density crowd = picture_.density();
      for (const std::uint32_t i : members[k]) crowd.add(picture_.at(segments_[i].a), picture_.at(segments_[i].b));
      picture_.add(crowd.xml(fmt::format("stroke='{}'", calm_inks.at(k % calm_inks.size()))));
    }
    picture_.note("Too many segments for lines: squares are the darker the more of them pass there.");
  }

  // The common point, twice, or part.
  Segment common_of(const SegmentsContact& contact) const {
    const Segment &s = segments_[contact.i], &t = segments_[contact.j];
    if (contact.kind == ContactKind::overlap) return planar::common_part(s, t);
    const Point2 point = planar::common_point_rounded(s, t);
    return {point, point};
  }

  // Of an overlap, in the middle.
  void rings() {
    std::vector<RingContact> places;
    for (std::uint32_t k = 0; k < shown_.size(); ++k) {
      const Point2 a = picture_.at(shown_[k].place.a), b = picture_.at(shown_[k].place.b);
      places.push_back({{(a.x + b.x) / 2, (a.y + b.y) / 2}, k, shown_[k].kind});
    }
    picture_.rings(places, kinds_, [this](std::uint32_t k) { return sentence(k); });
    if (shown_.size() > most_bold) {
      picture_.note(fmt::format("Bold: segments of the first {} {}.", most_bold,
                                given_.defects.empty() ? "contacts" : "defects"));
    }
  }

  // "contact 3: crossing of segment 12 (feature A, line 4) and segment 77 (feature B, line 9) at (x, y)"
  // "defect 3: hole-outside: ring 1 is outside of ring 0, its shell; segment 12 (feature A, line 4)"
  std::string sentence(std::uint32_t k) const {
    const auto& [i, j, kind, place] = shown_[k];
    if (!given_.defects.empty()) {
      return fmt::format("defect {}: {}: {}; {}", k + 1, kinds_[kind].name, given_.defects[k].text, source_of(i));
    }
    const auto about = [](const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); };
    const auto& [a, b] = place;
    return fmt::format("contact {}: {} of {} and {} {}", k + 1, kinds_[kind].name, source_of(i), source_of(j),
                       a == b ? "at " + about(a) : "from " + about(a) + " to " + about(b));
  }

  std::string source_of(std::uint32_t i) const {
    const io::LineSource& source = file_.source[i];
    std::string text =
        fmt::format("segment {} (feature {}", i, shortened(file_.features[source.feature], longest_name));
    if (!file_.groups.empty()) text += ", group " + shortened(file_.groups[file_.group[i]], longest_name);
    if (!file_.layers.empty()) text += ", layer " + shortened(file_.layers[file_.layer[i]], longest_name);
    if (source.line > 0) text += fmt::format(", line {}", source.line);
    return text + ")";
  }

  const SegmentsPicture& given_;
  const io::LineFile& file_;
  const planar::Segments& segments_;
  PlanePicture picture_;
  std::vector<RingKind> kinds_;     // the strongest first; of defects in the order in which they come
  std::vector<Shown> shown_;        // contacts, or defects
  std::vector<std::size_t> count_;  // of these, by kind
};

}  // namespace

std::string segments_svg(const SegmentsPicture& picture) { return SegmentsDrawing(picture).text(); }

}  // namespace sunder::picture
