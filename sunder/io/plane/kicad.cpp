#include <sunder/io/plane/kicad.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace sunder::io {

namespace {

struct KicadToken {
  enum class Kind { open, close, atom, end };
  Kind kind = Kind::end;
  std::string_view text;  // of an atom; of a string what stands between the quotes
  std::uint32_t line = 1;
  bool quoted = false;
};

// A '#' that is the first on its line begins a comment. A string ends on its line.
class KicadLexer {
 public:
  KicadLexer(std::string_view text, std::string_view place) : text_(text), place_(place) {}

  KicadToken next() {
    skip_blanks();
    KicadToken token;
    token.line = line_;
    at_line_begin_ = false;
    if (at_ == text_.size()) return token;
    const std::size_t begin = at_;
    const char c = text_[at_++];
    token.text = text_.substr(begin, 1);
    if (c == '(' || c == ')') {
      token.kind = c == '(' ? KicadToken::Kind::open : KicadToken::Kind::close;
      return token;
    }
    token.kind = KicadToken::Kind::atom;
    token.quoted = c == '"';
    if (token.quoted) {
      token.text = string();
    } else {
      at_ = std::min(text_.find_first_of(" \t\r\n\f\v()", at_), text_.size());
      token.text = text_.substr(begin, at_ - begin);
    }
    return token;
  }

  // Is the next token an atom? It stays the next one.
  bool at_atom() {
    skip_blanks();
    return at_ < text_.size() && text_[at_] != '(' && text_[at_] != ')';
  }

 private:
  void skip_blanks() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n' || c == '\r') {
        const bool second_of_two = c == '\n' && at_ > 0 && text_[at_ - 1] == '\r';
        if (!second_of_two) ++line_;
        at_line_begin_ = true;
      } else if (c == '#' && at_line_begin_) {
        at_ = std::min(text_.find_first_of("\r\n", at_), text_.size()) - 1;
      } else if (c != ' ' && c != '\t' && c != '\f' && c != '\v') {
        return;
      }
    }
  }

  std::string_view string() {
    const std::size_t begin = at_;
    for (; at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r'; ++at_) {
      if (text_[at_] == '"') return text_.substr(begin, at_++ - begin);
      const bool escape = text_[at_] == '\\' && at_ + 1 < text_.size();
      if (escape && text_[at_ + 1] != '\n' && text_[at_ + 1] != '\r') ++at_;
    }
    fail_line(place_, line_,
              fmt::format("the string that begins with {} does not end on its line; close it with a quote",
                          quote(text_.substr(begin, at_ - begin))));
  }

  std::string_view text_, place_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  bool at_line_begin_ = true;
};

// A string's text, for people: \" and \\ without the backslash.
std::string shown(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\')) ++i;
    plain += text[i];
  }
  return one_line(plain);
}

Point2 operator+(const Point2& p, const Point2& q) { return {p.x + q.x, p.y + q.y}; }
Point2 operator-(const Point2& p, const Point2& q) { return {p.x - q.x, p.y - q.y}; }
double cross(const Point2& p, const Point2& q) { return p.x * q.y - p.y * q.x; }
double square(const Point2& p) { return p.x * p.x + p.y * p.y; }
bool is_finite(const Point2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

// Part of a circle, counter-clockwise or not. Only + - * / and square roots: the same on any machine.
struct Disc {
  Point2 centre;
  double radius = 0;
  bool counter_clockwise = false;

  // Of the arc from p to q: on its right where it runs counter-clockwise.
  Point2 middle(const Point2& p, const Point2& q) const {
    const Point2 along = q - p;
    const double scale = (counter_clockwise ? radius : -radius) / std::sqrt(square(along));
    return centre + Point2{along.y * scale, -along.x * scale};
  }

  // Does the arc from p to q span more than 5 degrees? The constant is below (2 sin 2.5 degrees)^2 by about 1e-13.
  bool is_long(const Point2& p, const Point2& q) const {
    const double side = cross(q - p, centre - p);
    const bool over_180_degrees = counter_clockwise ? side < 0 : side > 0;
    return over_180_degrees || square(q - p) > 0.0076106038155 * radius * radius;
  }
};

constexpr int most_halvings = 7;  // 360 / 2^7 < 5

// Appends the corners behind p, of chords of equal length.
void append_arc(const Disc& circle, const Point2& p, const Point2& q, std::vector<Point2>& corners) {
  int halvings = 0;
  for (Point2 end = q; halvings < most_halvings && circle.is_long(p, end); ++halvings) end = circle.middle(p, end);
  std::vector<Point2> points{p, q};
  for (; halvings > 0; --halvings) {
    std::vector<Point2> finer{p};
    for (std::size_t i = 1; i < points.size(); ++i) {
      finer.push_back(circle.middle(points[i - 1], points[i]));
      finer.push_back(points[i]);
    }
    points = std::move(finer);
  }
  corners.insert(corners.end(), points.begin() + 1, points.end());
}

// Below this, in proportion to the products that it is the difference of, a cross product counts as zero. The arc then
// spans some 1e-6 radians at most; above it, the rounding of the cross product moves the circle by 1e-9 of its radius.
constexpr double flat = 0x1p-20;

// The corners of the polyline (K2). Not all are finite where doubles cannot hold the circle.
std::vector<Point2> corners_of_arc(const Point2& start, const Point2& mid, const Point2& end) {
  const Point2 m = mid - start, e = end - start;  // the start is the origin
  const double size = std::max({std::fabs(m.x), std::fabs(m.y), std::fabs(e.x), std::fabs(e.y)});
  if (size > 0 && (size < 1e-100 || size > 1e100)) return {{std::numeric_limits<double>::infinity(), 0}};
  const double turn = cross(m, e);
  if (std::fabs(turn) <= flat * (std::fabs(m.x * e.y) + std::fabs(m.y * e.x))) return {start, mid, end};
  Disc circle;
  circle.centre = {(e.y * square(m) - m.y * square(e)) / (2 * turn), (m.x * square(e) - e.x * square(m)) / (2 * turn)};
  circle.radius = std::sqrt(square(circle.centre));
  circle.counter_clockwise = turn > 0;
  std::vector<Point2> corners{{0, 0}};
  append_arc(circle, {0, 0}, m, corners);
  const std::size_t middle = corners.size() - 1;
  append_arc(circle, m, e, corners);
  for (Point2& corner : corners) corner = start + corner;
  corners.front() = start;
  corners[middle] = mid;
  corners.back() = end;
  return corners;
}

struct Track {
  std::string_view kind;  // segment, arc
  std::uint32_t line = 0;
  Point2 start, mid, end;  // mid: of an arc
  KicadToken layer, net;
};

class Board {
 public:
  Board(std::string_view text, std::string_view place, const LineOptions& options)
      : place_(place), group_(options.group), lexer_(text, place) {}

  LineFile parse() {
    if (!group_.empty() && group_ != "net" && group_ != "layer" && group_ != "feature") {
      fail_group(place_, group_, "net, layer, feature");
    }
    file_.format = "KiCad board";
    read();
    for (const Track& track : tracks_) add(track);
    if (file_.segments.empty()) fail_file(place_, "the board has no tracks on copper; route it, or give another");
    if (group_ == "layer") file_.groups = file_.layers;
    add_remarks();
    return std::move(file_);
  }

 private:
  // --- Lists -------------------------------------------------------------------------------------------------------

  // Goes on by one token, and keeps the list of what is open.
  KicadToken step() {
    const KicadToken token = lexer_.next();
    if (token.kind == KicadToken::Kind::open) open_.push_back(token.line);
    if (token.kind == KicadToken::Kind::close) open_.pop_back();
    if (token.kind == KicadToken::Kind::end) {
      fail_line(place_, token.line,
                fmt::format("ends within the list that begins on line {}; is a ')' missing, or the file cut off?",
                            open_.back()));
    }
    return token;
  }

  // Goes into the next list within the open one; its first atom is put into `head`. False: the open list ended.
  bool enter(KicadToken& head) {
    for (;;) {
      const KicadToken token = step();
      if (token.kind == KicadToken::Kind::close) return false;
      if (token.kind == KicadToken::Kind::atom) continue;
      head = lexer_.at_atom() ? lexer_.next() : KicadToken{KicadToken::Kind::atom, {}, token.line, false};
      return true;
    }
  }

  // The atoms of the open list, to its end. Lists within are passed over.
  const std::vector<KicadToken>& leave() {
    atoms_.clear();
    const std::size_t depth = open_.size();
    while (open_.size() >= depth) {
      const KicadToken token = step();
      if (token.kind == KicadToken::Kind::atom && open_.size() == depth) atoms_.push_back(token);
    }
    return atoms_;
  }

  // --- What stands in the board --------------------------------------------------------------------------------------

  void read() {
    const KicadToken first = lexer_.next();
    if (first.kind != KicadToken::Kind::open) {
      fail_line(place_, first.line, "is no KiCad board, which begins with (kicad_pcb; give a .kicad_pcb file");
    }
    open_.push_back(first.line);
    const KicadToken type = lexer_.at_atom() ? lexer_.next() : KicadToken();
    if (type.text != "kicad_pcb") {
      fail_line(place_, first.line,
                fmt::format("begins with {}, so it is no board; give the .kicad_pcb file",
                            quote("(" + std::string(type.text))));
    }
    for (KicadToken head; enter(head);) read_item(head);
    const KicadToken last = lexer_.next();
    if (last.kind != KicadToken::Kind::end) {
      fail_line(place_, last.line,
                fmt::format("{} stands after the end of the board; is a '(' missing, or a ')' "
                            "too many?",
                            quote(last.text)));
    }
    if (version_ == 0) fail_line(place_, first.line, "the board has no (version ...); save it with KiCad");
  }

  void read_item(const KicadToken& head) {
    const std::string_view name = head.text;
    if (name == "segment" || name == "arc") return read_track(head);
    if (name == "layers") return read_layers();
    const std::vector<KicadToken>& atoms = leave();
    if (name == "version") {
      read_version(head.line, atoms);
    } else if (name == "net") {
      read_net(head.line, atoms);
    } else if (name == "via") {
      ++vias_;
    } else if (name == "zone") {
      ++zones_;
    } else if (name == "footprint" || name == "module") {
      ++footprints_;
    } else if (name.starts_with("gr_") || name == "dimension" || name == "target" || name == "image") {
      ++drawings_;
    } else if (!holds_no_copper(name)) {
      ++others_;
    }
  }

  // Lists that every board has, or that only name or arrange what stands elsewhere.
  static bool holds_no_copper(std::string_view name) {
    constexpr std::array<std::string_view, 17> known{
        "general",        "paper",          "page",  "title_block", "setup",     "net_class",
        "property",       "group",          "host",  "generated",   "generator", "generator_version",
        "embedded_fonts", "embedded_files", "links", "no_connects", "area"};
    return std::find(known.begin(), known.end(), name) != known.end();
  }

  void read_version(std::uint32_t line, const std::vector<KicadToken>& atoms) {
    std::int64_t version = 0;
    const bool known = atoms.size() == 1 && parse_integer(atoms[0].text, version) &&
                       ((3 <= version && version <= 4) || (20160815 <= version && version <= 20251231));
    if (!known) {
      fail_line(
          place_, line,
          fmt::format("a board of an unknown version, {}; known are 3, 4 and 20160815 to 20251231 (KiCad 4 to 9): "
                      "save it with one of these",
                      quote(atoms.empty() ? std::string_view() : atoms[0].text)));
    }
    version_ = version;
  }

  void read_net(std::uint32_t line, const std::vector<KicadToken>& atoms) {
    std::int64_t number = 0;
    if (atoms.size() != 2 || !parse_integer(atoms[0].text, number)) {
      fail_line(place_, line, "a net of the table is not a number and a name; save the board again");
    }
    if (!nets_.try_emplace(number, atoms[1].text).second) {
      fail_line(place_, line, fmt::format("net {} is in the table twice; give it another number", number));
    }
  }

  void read_layers() {
    for (KicadToken head; enter(head);) {
      const std::vector<KicadToken>& atoms = leave();
      if (atoms.size() < 2) {
        fail_line(place_, head.line, "a layer of the table is not a number, a name and a type; save the board again");
      }
      is_copper_[atoms[0].text] = atoms[1].text != "user";
    }
  }

  void read_track(const KicadToken& kind) {
    Track track;
    track.kind = kind.text;
    track.line = open_.back();
    std::array<bool, 5> has{};
    const std::array<std::string_view, 5> needed{"start", "end", "layer", "net", "mid"};
    for (KicadToken head; enter(head);) {
      if (head.text == "segment" || head.text == "arc" || head.text == "via") {
        fail_line(
            place_, head.line,
            fmt::format("a list {} stands within the track of line {}; is a ')' missing?", head.text, track.line));
      }
      const std::string_view name = head.text == "layers" ? std::string_view("layer") : head.text;
      const std::vector<KicadToken>& atoms = leave();
      const auto found = std::find(needed.begin(), needed.end(), name);
      if (found != needed.end()) {
        bool& seen = has[static_cast<std::size_t>(found - needed.begin())];
        if (seen) fail_line(place_, head.line, fmt::format("the track has two lists {}; remove one", name));
        seen = true;
      }
      if (name == "start") track.start = point(head, atoms);
      if (name == "mid") track.mid = point(head, atoms);
      if (name == "end") track.end = point(head, atoms);
      if (name == "width") add_width(number(head, one_of(head, atoms)));
      if (name == "layer") track.layer = layer_of(head, atoms);
      if (name == "net") track.net = one_of(head, atoms);
    }
    for (std::size_t i = 0; i < (kind.text == "arc" ? 5 : 4); ++i) {
      if (!has[i]) {
        fail_line(place_, track.line,
                  fmt::format("this {} has no ({} ...); save the board again", kind.text, needed[i]));
      }
    }
    tracks_.push_back(track);
  }

  void require_count(const KicadToken& head, const std::vector<KicadToken>& atoms, std::size_t count) const {
    if (atoms.size() == count) return;
    fail_line(
        place_, head.line,
        fmt::format("{} has {}, not {}; save the board again", head.text, count_of(atoms.size(), "value"), count));
  }

  double number(const KicadToken& head, const KicadToken& atom) const {
    double value = 0;
    if (const char* problem = parse_number(atom.text, value)) {
      fail_line(place_, atom.line, fmt::format("{} {} {}", head.text, quote(atom.text), problem));
    }
    return value;
  }

  Point2 point(const KicadToken& head, const std::vector<KicadToken>& atoms) const {
    require_count(head, atoms, 2);
    return {number(head, atoms[0]), number(head, atoms[1])};
  }

  KicadToken one_of(const KicadToken& head, const std::vector<KicadToken>& atoms) const {
    require_count(head, atoms, 1);
    return atoms[0];
  }

  // Since KiCad 9, of a track without solder mask: (layers "F.Cu" "F.Mask").
  KicadToken layer_of(const KicadToken& head, const std::vector<KicadToken>& atoms) const {
    if (head.text == "layer") return one_of(head, atoms);
    const auto is_of_copper = [](const KicadToken& atom) { return atom.text.ends_with(".Cu"); };
    if (std::count_if(atoms.begin(), atoms.end(), is_of_copper) != 1) {
      fail_line(place_, head.line, "a track is not on exactly one layer of copper; save the board again");
    }
    return *std::find_if(atoms.begin(), atoms.end(), is_of_copper);
  }

  void add_width(double width) {
    narrowest_ = std::min(narrowest_, width);
    widest_ = std::max(widest_, width);
  }

  // --- The file ------------------------------------------------------------------------------------------------------

  using Positions = std::unordered_map<std::string_view, std::uint32_t>;

  // The position of `key` in `names`; when it is new, its name is put there.
  static std::uint32_t position_of(std::string_view key, std::string_view name, Positions& known,
                                   std::vector<std::string>& names) {
    const auto [place, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(names.size()));
    if (is_new) names.push_back(shown(name));
    return place->second;
  }

  // Empty: no net.
  std::string_view net_of(const Track& track) const {
    const KicadToken& net = track.net;
    std::int64_t number = 0;
    const bool is_number = parse_integer(net.text, number);
    const bool by_name = version_ >= 20241229;  // KiCad 9 ff. may give names
    if (by_name && (net.quoted || !is_number)) return net.text;
    if (!is_number) {
      fail_line(place_, net.line, fmt::format("net {} is not a number; save the board again", quote(net.text)));
    }
    const auto found = nets_.find(number);
    if (found == nets_.end() && number != 0) {
      fail_line(place_, net.line,
                fmt::format("net {} is not in the board's table of nets; correct the number, or add the net", number));
    }
    return found == nets_.end() ? std::string_view() : found->second;
  }

  bool is_copper(const Track& track) const {
    const std::string_view name = track.layer.text;
    if (const auto found = is_copper_.find(name); found != is_copper_.end()) return found->second;
    if (!name.ends_with(".Cu")) {
      fail_line(place_, track.layer.line,
                fmt::format("layer {} is not in the board's table of layers; correct the name", quote(name)));
    }
    return true;
  }

  void add(const Track& track) {
    const std::string_view net = net_of(track);
    if (!is_copper(track)) {
      ++not_on_copper_;
      return;
    }
    std::vector<Point2> corners{track.start, track.end};
    if (track.kind == "arc") {
      ++arcs_;
      corners = corners_of_arc(track.start, track.mid, track.end);
      if (!std::all_of(corners.begin(), corners.end(), is_finite)) {
        fail_line(place_, track.line, "the circle of this arc is too large or too small; give millimetres");
      }
    }
    if (net.empty()) ++without_net_;
    used_nets_.insert(net);
    const auto feature = static_cast<std::uint32_t>(file_.features.size());
    file_.features.push_back(net.empty() ? "no net" : "net " + shown(net));
    const std::uint32_t layer = position_of(track.layer.text, track.layer.text, layers_, file_.layers);
    std::uint32_t group = layer;
    if (group_.empty() || group_ == "net") {
      group = position_of(net, net.empty() ? "(no net)" : net, groups_, file_.groups);
    }
    if (group_ == "feature") {
      group = feature;
      file_.groups.push_back(file_.features.back());
    }
    for (std::size_t i = 1; i < corners.size(); ++i) {
      file_.segments.push_back({corners[i - 1], corners[i]});
      file_.source.push_back({feature, track.line});
      file_.layer.push_back(layer);
      file_.group.push_back(group);
    }
  }

  void add_remarks() {
    std::vector<std::string>& remarks = file_.remarks;
    const auto tell = [&](std::size_t count, std::string_view noun, std::string_view what) {
      if (count > 0) remarks.push_back(fmt::format("{} {}", count_of(count, noun), what));
    };
    tell(arcs_, "arc",
         arcs_ == 1 ? "was turned into polylines of chords of at most 5 degrees"
                    : "were turned into polylines of chords of at most 5 degrees");
    tell(vias_, "via", vias_ == 1 ? "is a point of its net, not looked at" : "are points of their nets, not looked at");
    if (narrowest_ <= widest_) {
      const std::string all =
          narrowest_ < widest_ ? fmt::format("s from {} to {}", narrowest_, widest_) : fmt::format(" {}", widest_);
      remarks.push_back(fmt::format("track width{} mm; clearance is not checked: tracks are lines without width", all));
    }
    tell(without_net_, "track", "without a net: taken for one net");
    tell(not_on_copper_, "track", "not on copper: not looked at");
    const auto trackless = std::count_if(nets_.begin(), nets_.end(), [&](const auto& net) {
      return !net.second.empty() && !used_nets_.contains(net.second);
    });
    tell(static_cast<std::size_t>(trackless), "net",
         fmt::format("without tracks, of {} in the table: not looked at", nets_.size()));
    tell(others_, "list", "of an unknown kind: not looked at");
    if (zones_ + footprints_ + drawings_ > 0) {
      remarks.push_back(fmt::format("zones, pads and graphics are not looked at: {}, {}, {}", count_of(zones_, "zone"),
                                    count_of(footprints_, "footprint"), count_of(drawings_, "drawing")));
    }
  }

  std::string_view place_;
  std::string group_;
  KicadLexer lexer_;
  std::vector<std::uint32_t> open_;  // the lines on which the open lists begin
  std::vector<KicadToken> atoms_;

  std::int64_t version_ = 0;
  std::unordered_map<std::int64_t, std::string_view> nets_;
  std::unordered_map<std::string_view, bool> is_copper_;
  std::vector<Track> tracks_;
  std::size_t vias_ = 0, zones_ = 0, footprints_ = 0, drawings_ = 0, others_ = 0;
  std::size_t arcs_ = 0, without_net_ = 0, not_on_copper_ = 0;
  double narrowest_ = std::numeric_limits<double>::infinity(), widest_ = -narrowest_;

  LineFile file_;
  Positions layers_, groups_;
  std::unordered_set<std::string_view> used_nets_;
};

}  // namespace

LineFile parse_kicad(std::string_view text, std::string_view place, const LineOptions& options) {
  return Board(text, place, options).parse();
}

}  // namespace sunder::io
