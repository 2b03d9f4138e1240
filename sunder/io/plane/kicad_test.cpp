// What the reader of KiCad boards takes, and makes of it. What it refuses: cases/broken-lines (lines_test.cpp).
#include <sunder/base/error.h>
#include <sunder/io/plane/kicad.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

namespace sunder::io {
namespace {

using planar::Segment;

const std::filesystem::path board_cases = std::filesystem::path(tests::cases_folder()) / "boards";

using Names = std::vector<std::string>;
using Numbers = std::vector<std::uint32_t>;

// A board of version 7 with these lists in it.
LineFile board(const std::string& lists, const std::string& group = {}, const std::string& version = "20221018") {
  return parse_lines(
      "(kicad_pcb (version " + version + ") (net 0 \"\") (net 1 \"GND\") (net 2 \"VCC\")\n" + lists + "\n)",
      "a.kicad_pcb", {false, group});
}

std::string segment(const std::string& net, const std::string& layer = "F.Cu") {
  return "(segment (start 1 2) (end 3 4) (width 0.2) (layer " + layer + ") (net " + net + "))";
}

std::string arc(const std::string& points) { return "(arc " + points + " (width 0.2) (layer F.Cu) (net 1))"; }

TEST(KicadTest, Board) {
  const LineFile file = read_lines(board_cases / "two_nets.kicad_pcb");
  EXPECT_EQ(file.format, "KiCad board");
  EXPECT_EQ(file.features, (Names{"net GND", "net GND", "net GND", "net CLOCK", "net CLOCK", "net Net-(\"R1\"-Pad2)"}));
  EXPECT_EQ(file.segments[0], (Segment{{100, 100}, {120, 100}}));
  EXPECT_EQ(file.segments.back(), (Segment{{100, 110}, {104.5, 110.5}}));
  EXPECT_EQ(file.source[2].line, 21u);  // the list is spread over lines
  EXPECT_EQ(file.source.back().line, 32u);
  EXPECT_EQ(file.groups, (Names{"GND", "CLOCK", "Net-(\"R1\"-Pad2)"}));
  EXPECT_EQ(file.layers, (Names{"F.Cu", "B.Cu"}));
  EXPECT_EQ((Numbers{file.group[0], file.group[3], file.group.back()}), (Numbers{0, 1, 2}));
  EXPECT_EQ((Numbers{file.layer[0], file.layer[2], file.layer.back()}), (Numbers{0, 1, 0}));
  EXPECT_EQ(file.remarks,
            (Names{"1 arc was turned into polylines of chords of at most 5 degrees",
                   "1 via is a point of its net, not looked at",
                   "track widths from 0.2 to 0.5 mm; clearance is not checked: tracks are lines without width",
                   "1 net without tracks, of 5 in the table: not looked at",
                   "zones, pads and graphics are not looked at: 0 zones, 0 footprints, 1 drawing"}));
  EXPECT_EQ(read_lines(board_cases / "crossing_nets.kicad_pcb").segments.size(), 3u);
}

TEST(KicadTest, Groups) {
  const std::string lists = segment("1") + segment("2", "B.Cu") + segment("1", "B.Cu");
  for (const std::string group : {"", "net"}) {
    EXPECT_EQ(board(lists, group).groups, (Names{"GND", "VCC"}));
    EXPECT_EQ(board(lists, group).group, (Numbers{0, 1, 0}));
  }
  EXPECT_EQ(board(lists, "layer").groups, (Names{"F.Cu", "B.Cu"}));
  EXPECT_EQ(board(lists, "layer").group, (Numbers{0, 1, 1}));
  EXPECT_EQ(board(lists, "feature").groups, (Names{"net GND", "net VCC", "net GND"}));
  EXPECT_EQ(board(lists, "feature").group, (Numbers{0, 1, 2}));
  try {
    board(lists, "ring");
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_call);
    EXPECT_STREQ(error.what(), "a.kicad_pcb: there is no field 'ring' to group by; there are net, layer, feature");
  }
}

TEST(KicadTest, Versions) {
  for (const std::string version : {"3", "4", "20160815", "20171130", "20211014", "20240108", "20241229", "20251231"}) {
    EXPECT_EQ(board(segment("1"), {}, version).groups, Names{"GND"}) << version;
  }
  for (const std::string version : {"2", "5", "20160814", "20260101", "-4", "4.5", "x", "", "4 4"}) {
    EXPECT_THROW(board(segment("1"), {}, version), Error) << version;
  }
}

TEST(KicadTest, Nets) {
  // By number before KiCad 9; then also by name, in quotes where it is made of digits.
  EXPECT_EQ(board(segment("\"1\"")).groups, Names{"GND"});
  const LineFile named = board(segment("\"GND\"") + segment("1") + segment("\"1\"") + segment("NEW"), {}, "20241229");
  EXPECT_EQ(named.groups, (Names{"GND", "1", "NEW"}));
  EXPECT_EQ(named.group, (Numbers{0, 0, 1, 2}));
  const LineFile none = board(segment("0") + segment("1") + segment("\"\""), {}, "20241229");
  EXPECT_EQ(none.groups, (Names{"(no net)", "GND"}));
  EXPECT_EQ(none.group, (Numbers{0, 1, 0}));
  EXPECT_EQ(none.features[0], "no net");
  EXPECT_EQ(none.remarks[1], "2 tracks without a net: taken for one net");
}

TEST(KicadTest, Layers) {
  // Boards of KiCad 4 and 5 name copper as they like; the table may come last.
  const std::string table = "(layers (0 Top signal) (2 Mid power hide) (31 \"Solder side\" mixed) (44 Edge.Cuts user))";
  const std::string tracks = segment("1", "Top") + segment("1", "\"Solder side\"") + segment("1", "Mid");
  for (const std::string& lists : {table + tracks, tracks + table}) {
    EXPECT_EQ(board(lists, {}, "20171130").layers, (Names{"Top", "Solder side", "Mid"}));
  }
  const LineFile edge = board(table + tracks + segment("1", "Edge.Cuts"));
  EXPECT_EQ(edge.segments.size(), 3u);
  EXPECT_EQ(edge.remarks[1], "1 track not on copper: not looked at");
  // A track without solder mask.
  const LineFile mask = board("(segment (start 1 2) (end 3 4) (layers \"F.Mask\" \"F.Cu\") (net 1))", {}, "20241229");
  EXPECT_EQ(mask.layers, Names{"F.Cu"});
}

TEST(KicadTest, Text) {
  // Comments, all line ends, words with quotes in them, strings with escapes, parentheses in strings.
  const LineFile file = parse_lines(
      "# a ( comment\r\n(kicad_pcb(version 4)\r(net 1 /a\"b)(net 2 \"c \\\" \\\\ ) \x01\")\n  # (\n"
      "(segment(start 0 0)(end 1 1)(layer F.Cu)(net 1)(status 400))\n"
      "(segment (start -.5 +1e-1) (end 1 1) (layer F.Cu) (net 2) (x (y \"z)\") ())))",
      "a.kicad_pcb");
  EXPECT_EQ(file.groups, (Names{"/a\"b", "c \" \\ ) \\x01"}));
  EXPECT_EQ(file.source[0].line, 5u);
  EXPECT_EQ(file.source[1].line, 6u);
  EXPECT_EQ(file.segments[1], (Segment{{-0.5, 0.1}, {1, 1}}));
  EXPECT_EQ(file.remarks, Names{});
  EXPECT_EQ(parse_lines("  (kicad_pcb (version 4) " + segment("0") + ")", "a.txt").format, "KiCad board");
}

TEST(KicadTest, DeepNesting) {
  constexpr std::size_t depth = 1000000;
  const std::string deep = std::string(depth, '(') + std::string(depth, ')');
  EXPECT_EQ(board(deep + segment("1") + "(zone " + deep + ")").segments.size(), 1u);
  EXPECT_THROW(board(std::string(depth, '(')), Error);
}

// K2, for the arc in file.segments.
void check_arc(const LineFile& file, const Point2& centre, double radius, double degrees) {
  const auto angle = [&](const Point2& p) { return std::atan2(p.y - centre.y, p.x - centre.x); };
  double all = 0;
  for (const Segment& s : file.segments) {
    EXPECT_NEAR(std::hypot(s.a.x - centre.x, s.a.y - centre.y), radius, 1e-12 * radius);
    const double step = std::remainder(angle(s.b) - angle(s.a), 2 * std::numbers::pi) * 180 / std::numbers::pi;
    EXPECT_GT(std::copysign(1.0, degrees) * step, 0);
    EXPECT_LE(std::fabs(step), 5);
    EXPECT_GT(std::fabs(step), 2.4);
    all += step;
  }
  EXPECT_NEAR(all, degrees, 1e-9);
  for (std::size_t i = 1; i < file.segments.size(); ++i) EXPECT_EQ(file.segments[i].a, file.segments[i - 1].b);
  EXPECT_EQ(file.features.size(), 1u);
}

TEST(KicadTest, Arcs) {
  const LineFile quarter = board(arc("(start 10 0) (mid 8 6) (end 0 10)"));
  check_arc(quarter, {0, 0}, 10, 90);
  EXPECT_EQ(quarter.segments.front().a, (Point2{10, 0}));
  EXPECT_EQ(quarter.segments.back().b, (Point2{0, 10}));
  int through_mid = 0;
  for (const Segment& s : quarter.segments) through_mid += s.b == Point2{8, 6};
  EXPECT_EQ(through_mid, 1);
  check_arc(board(arc("(start 0 10) (mid 8 6) (end 10 0)")), {0, 0}, 10, -90);
  check_arc(board(arc("(start 15 0) (mid -5 0) (end 11 8)")), {5, 0}, 10,
            std::atan2(8, 6) * 180 / std::numbers::pi - 360);
  check_arc(board(arc("(start 105 103) (mid 107 105) (end 105 107)")), {105, 105}, 2, 180);
  // From the start almost all around, with the mid on it as far off the middle as can be.
  check_arc(board(arc("(start 10 0) (mid 8 6) (end 8 -6)")), {0, 0}, 10,
            360 - std::atan2(6, 8) * 180 / std::numbers::pi);
}

TEST(KicadTest, FlatArcs) {
  const std::map<std::string, std::vector<Segment>> flat{
      {"(start 0 0) (mid 1 2) (end 3 6)", {{{0, 0}, {1, 2}}, {{1, 2}, {3, 6}}}},
      {"(start 0.1 0.1) (mid 0.2 0.2) (end 0.3 0.3)", {{{0.1, 0.1}, {0.2, 0.2}}, {{0.2, 0.2}, {0.3, 0.3}}}},
      {"(start 0 0) (mid 1 1.0000001) (end 2 2)", {{{0, 0}, {1, 1.0000001}}, {{1, 1.0000001}, {2, 2}}}},
      {"(start 0 0) (mid 1 1) (end 0 0)", {{{0, 0}, {1, 1}}, {{1, 1}, {0, 0}}}},
      {"(start 1 1) (mid 1 1) (end 1 1)", {{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}},
      {"(start 0 0) (mid 10 0.1) (end 20 0)", {{{0, 0}, {10, 0.1}}, {{10, 0.1}, {20, 0}}}},  // 1.1 degrees each
  };
  for (const auto& [points, segments] : flat) EXPECT_EQ(board(arc(points)).segments, segments) << points;
}

}  // namespace
}  // namespace sunder::io
