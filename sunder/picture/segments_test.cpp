#include <sunder/picture/segments.h>

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::picture {
namespace {

using planar::Segment;
using planar::Segments;
using planar::SegmentsContact;
using tinyxml2::XMLElement;

std::vector<SegmentsContact> contacts_of(const Segments& segments) {
  std::vector<SegmentsContact> contacts = planar::segments_all(segments).found;
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

std::string svg_of(const io::LineFile& file, const std::string& title = "", bool y_down = false) {
  const Segments segments(file.segments);
  const std::vector<SegmentsContact> contacts = contacts_of(segments);
  const std::string said =
      contacts.empty() ? "none meet" : std::to_string(contacts.size()) + (contacts.size() == 1 ? " meets" : " meet");
  return segments_svg({file, segments, contacts, said, title, y_down});
}

std::string svg_of(const std::string& csv) { return svg_of(io::parse_lines(csv, "t.csv")); }

io::LineFile file_of(const std::vector<Segment>& segments) {
  io::LineFile file;
  file.segments = segments;
  file.source.resize(segments.size());
  file.features = {"all"};
  file.format = "CSV";
  return file;
}

// A ring: what it says, and where it lies with its label.
struct Ring {
  std::string kind, told, label;
  double x = 0, y = 0, radius = 0, left = 0, right = 0, top = 0, bottom = 0;
};

using Polyline = std::vector<std::array<double, 2>>;

// A picture, read.
struct Read {
  tinyxml2::XMLDocument document;
  std::vector<std::string> texts;
  std::vector<Ring> rings;
  std::vector<std::string> thin, bold, bands, dots;  // data of paths
  double width = 0, height = 0;

  explicit Read(const std::string& svg) {
    EXPECT_EQ(document.Parse(svg.data(), svg.size()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
    const XMLElement* root = document.RootElement();
    if (root == nullptr) return;
    width = root->DoubleAttribute("width");
    height = root->DoubleAttribute("height");
    visit(root);
  }

  bool says(std::string_view text) const {
    return std::any_of(texts.begin(), texts.end(), [&](const auto& t) { return t.find(text) != std::string::npos; });
  }

 private:
  static std::string text_of(const XMLElement* element) {
    const char* text = element == nullptr ? nullptr : element->GetText();
    return text == nullptr ? "" : text;
  }

  void visit(const XMLElement* element) {
    const std::string name = element->Name();
    for (const tinyxml2::XMLAttribute* a = element->FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string value = a->Value();
      EXPECT_EQ(value.find("nan"), std::string::npos) << value.substr(0, 200);
      EXPECT_EQ(value.find("inf"), std::string::npos) << value.substr(0, 200);
    }
    if (name == "text") texts.push_back(text_of(element));
    if (name == "path") sort(element);
    if (name == "g" && element->FirstChildElement("title") != nullptr) ring(element);
    for (const XMLElement* e = element->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) visit(e);
  }

  void sort(const XMLElement* path) {
    const std::string data = path->Attribute("d");
    if (path->Attribute("stroke-opacity") != nullptr) {
      bands.push_back(data);
    } else if (path->Attribute("stroke-width", "22") != nullptr) {
      bold.push_back(data);
    } else if (path->Attribute("stroke-linecap") != nullptr) {
      dots.push_back(data);
    } else if (data[0] == 'm') {
      thin.push_back(data);
    }
  }

  void ring(const XMLElement* g) {
    const XMLElement *circle = g->FirstChildElement("circle"), *rect = g->FirstChildElement("rect");
    Ring r{g->Attribute("class"), text_of(g->FirstChildElement("title")), text_of(g->FirstChildElement("text"))};
    r.x = circle->DoubleAttribute("cx");
    r.y = circle->DoubleAttribute("cy");
    r.radius = circle->DoubleAttribute("r");
    r.left = rect->DoubleAttribute("x");
    r.right = r.left + rect->DoubleAttribute("width");
    r.top = rect->DoubleAttribute("y");
    r.bottom = r.top + rect->DoubleAttribute("height");
    rings.push_back(r);
  }
};

// Path data of m and l with steps, in tenths.
std::vector<Polyline> polylines_of(const std::string& data) {
  std::vector<Polyline> lines;
  double x = 0, y = 0;
  const char* at = data.c_str();
  while (*at != 0) {
    if (*at == '\n') ++at;
    const char letter = *at == 'm' || *at == 'l' ? *at++ : ' ';
    char* end = nullptr;
    x += static_cast<double>(std::strtol(at, &end, 10));
    EXPECT_NE(at, end) << at;
    at = end;
    y += static_cast<double>(std::strtol(at, &end, 10));
    EXPECT_NE(at, end) << at;
    if (at == end) break;
    at = end;
    if (letter == 'm') lines.emplace_back();
    lines.back().push_back({x, y});
  }
  return lines;
}

// How many contacts a ring stands for, by its label.
std::size_t count_of(const Ring& ring) {
  if (ring.label.find("\xc3\x97") != std::string::npos) return std::stoul(ring.label);
  if (ring.label.find(", ") != std::string::npos) return 2;
  const std::size_t dash = ring.label.find('-');
  return dash == std::string::npos ? 1 : std::stoul(ring.label.substr(dash + 1)) - std::stoul(ring.label) + 1;
}

void expect_apart(const std::vector<Ring>& rings) {
  const auto meet = [](const Ring& a, const Ring& b) {
    const auto left = [](const Ring& r) { return std::min(r.left, r.x - r.radius); };
    const auto right = [](const Ring& r) { return std::max(r.right, r.x + r.radius); };
    return left(a) < right(b) && left(b) < right(a) && std::fabs(a.y - b.y) < 2 * a.radius;
  };
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(meet(rings[i], rings[j])) << rings[i].label << " and " << rings[j].label;
    }
  }
}

TEST(SegmentsPicture, ACrossing) {
  const Read picture(svg_of("0,0,2,2,A\n0,2,2,0,B\n9,9,8,9,C\n"));
  EXPECT_EQ(picture.width, 1600);
  EXPECT_TRUE(picture.says("3 segments of 3 features; 1 meets"));
  ASSERT_EQ(picture.rings.size(), 1u);
  EXPECT_EQ(picture.rings[0].label, "1");
  EXPECT_EQ(picture.rings[0].kind, "m c");
  EXPECT_EQ(picture.rings[0].told,
            "contact 1: crossing of segment 0 (feature A, line 1) and segment 1 (feature B, line 2) at (1, 1)");
  ASSERT_EQ(picture.bold.size(), 1u);
  EXPECT_EQ(polylines_of(picture.bold[0]).size(), 2u);
  ASSERT_EQ(picture.thin.size(), 1u);
  EXPECT_EQ(polylines_of(picture.thin[0]).size(), 3u);
}

TEST(SegmentsPicture, NoneMeet) {
  const Read picture(svg_of("0,0,1,0\n0,1,1,1\n"));
  EXPECT_TRUE(picture.says("2 segments of 2 features; none meet"));
  EXPECT_TRUE(picture.rings.empty());
  EXPECT_TRUE(picture.bold.empty());
  EXPECT_FALSE(picture.says("crossing"));
  EXPECT_EQ(polylines_of(picture.thin.at(0)).size(), 2u);
}

TEST(SegmentsPicture, TheLegendCountsEachKind) {
  // Two crossings, a touch, a shared end, and an overlap.
  const Read picture(svg_of("0,0,9,0\n1,-1,1,1\n2,-1,2,1\n3,0,3,1\n9,0,9,5\n20,0,23,0\n22,0,25,0\n"));
  EXPECT_TRUE(picture.says("crossing 2"));
  EXPECT_TRUE(picture.says("touch 1"));
  EXPECT_TRUE(picture.says("shared-endpoint 1"));
  EXPECT_TRUE(picture.says("overlap 1"));
  EXPECT_EQ(picture.bold.size(), 4u);
}

TEST(SegmentsPicture, OfAnOverlapTheCommonPartIsABand) {
  const Read picture(svg_of("0,0,3,0\n2,0,10,0\n0,9,1,9\n"));
  ASSERT_EQ(picture.bands.size(), 1u);
  const std::vector<Polyline> band = polylines_of(picture.bands[0]), thin = polylines_of(picture.thin.at(0));
  ASSERT_EQ(band.size(), 1u);
  ASSERT_EQ(band[0].size(), 2u);
  const double left = thin[0][0][0], right = thin[1][1][0];  // at 0 and 10
  EXPECT_NEAR(band[0][0][0], left + 0.2 * (right - left), 1);
  EXPECT_NEAR(band[0][1][0], left + 0.3 * (right - left), 1);
  ASSERT_EQ(picture.rings.size(), 1u);
  EXPECT_NE(picture.rings[0].told.find("overlap of segment 0 (feature 1, line 1)"), std::string::npos);
  EXPECT_NE(picture.rings[0].told.find("from (2, 0) to (3, 0)"), std::string::npos);
  EXPECT_NEAR(10 * picture.rings[0].x, (band[0][0][0] + band[0][1][0]) / 2, 1);
}

// What is wrong with polygons that is no two edges that meet has a ring, too.
TEST(SegmentsPicture, Defects) {
  const io::LineFile file = file_of({{{0, 0}, {4, 0}}, {{4, 0}, {0, 4}}, {{0, 4}, {0, 0}}, {{8, 8}, {9, 8}}});
  const std::vector<PicturedDefect> defects{{3, 3, {{8, 8}, {8, 8}}, "hole-outside", "ring 1 <is> outside"},
                                            {0, 1, {{4, 0}, {4, 0}}, "crossing", "edges 0 and 1"},
                                            {0, 2, {{0, 0}, {1, 0}}, "overlap", "edges 0 and 2"},
                                            {1, 1, {{0, 4}, {0, 4}}, "hole-outside", "ring 2"}};
  const Read picture(
      segments_svg({file, Segments(file.segments), {}, "0 of 1 feature valid, 4 defects", "", false, defects}));
  EXPECT_TRUE(picture.says("4 segments of 1 feature; 0 of 1 feature valid, 4 defects"));
  EXPECT_FALSE(picture.says("meet;"));
  EXPECT_TRUE(picture.says("hole-outside 2"));
  EXPECT_TRUE(picture.says("crossing 1"));
  EXPECT_TRUE(picture.says("overlap 1"));
  ASSERT_EQ(picture.rings.size(), 4u);
  EXPECT_EQ(picture.rings[0].told, "defect 1: hole-outside: ring 1 <is> outside; segment 3 (feature all)");
  EXPECT_EQ(picture.bold.size(), 3u);
  EXPECT_EQ(picture.bands.size(), 1u);
}

TEST(SegmentsPicture, NamesMayBeAnything) {
  io::LineFile file = io::parse_lines("0,0,2,2,A\n0,2,2,0,B\n", "t.csv");
  file.features = {"<a & \"b\">\n]]>", "\xff\x01 \xef\xbf\xbf"};
  file.groups = {"</title><script>", "\xef\xbf\xbe"};
  file.group = {0, 1};
  file.layers = {"--> \xc3\xa4\xc3\xb6", "'"};
  file.layer = {1, 0};
  const std::string svg = svg_of(file, "<title> & \xe2\x82\xac \xe2\x82");
  const Read picture(svg);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find("\xef\xbf\xbe"), std::string::npos);
  EXPECT_EQ(svg.find("\xef\xbf\xbf"), std::string::npos);
  EXPECT_TRUE(picture.says("<title> & \xe2\x82\xac"));
  ASSERT_EQ(picture.rings.size(), 1u);
  EXPECT_NE(picture.rings[0].told.find("<a & \"b\">"), std::string::npos);
  EXPECT_NE(picture.rings[0].told.find("group </title><script>, layer '"), std::string::npos);
  EXPECT_NE(picture.rings[0].told.find("layer --> \xc3\xa4\xc3\xb6"), std::string::npos);
}

TEST(SegmentsPicture, LongNamesAreCutBetweenCharacters) {
  io::LineFile file = io::parse_lines("0,0,2,2,A\n0,2,2,0,B\n", "t.csv");
  for (std::size_t shift = 0; shift < 3; ++shift) {
    file.features[0] = std::string(shift, 'x');
    for (int i = 0; i < 1000; ++i) file.features[0] += "\xe2\x82\xac";
    const std::string svg = svg_of(file, file.features[0]);
    EXPECT_LT(svg.size(), 6000u);
    EXPECT_EQ(svg.find("\\x"), std::string::npos);
    EXPECT_NE(Read(svg).rings.at(0).told.find("\xe2\x82\xac..., line 1"), std::string::npos);
  }
}

TEST(SegmentsPicture, SegmentsThatShareEndsAreOneLine) {
  // However they point; then one that stands alone.
  const Read picture(svg_of("1,0,0,0\n1,0,1,1\n0,1,1,1\n0,1,0,0\n5,5,6,6\n"));
  const std::vector<Polyline> lines = polylines_of(picture.thin.at(0));
  ASSERT_EQ(lines.size(), 2u);
  ASSERT_EQ(lines[0].size(), 5u);
  EXPECT_EQ(lines[0][0], lines[0][4]);
  EXPECT_EQ(lines[1].size(), 2u);
  const double unit = lines[0][1][0] - lines[0][0][0];
  EXPECT_GT(unit, 0);
  EXPECT_NEAR(lines[0][2][1], lines[0][1][1] - unit, 1);       // y up, to one scale
  EXPECT_NEAR(lines[1][1][0], lines[0][0][0] + 6 * unit, 10);  // rounded six times
}

TEST(SegmentsPicture, YDown) {
  const io::LineFile file = io::parse_lines("0,0,1,0\n0,1,1,1\n", "t.csv");
  const std::vector<Polyline> up = polylines_of(Read(svg_of(file)).thin.at(0));
  const std::vector<Polyline> down = polylines_of(Read(svg_of(file, "", true)).thin.at(0));
  EXPECT_GT(up[0][0][1], up[1][0][1]);
  EXPECT_LT(down[0][0][1], down[1][0][1]);
}

TEST(SegmentsPicture, APathForEachClass) {
  io::LineFile file = io::parse_lines("0,0,1,0\n0,1,1,1\n0,2,1,2\n", "t.csv");
  EXPECT_EQ(Read(svg_of(file)).thin.size(), 1u);
  file.groups = {"GND", "VCC"};
  file.group = {0, 1, 0};
  const Read by_group(svg_of(file));
  EXPECT_EQ(by_group.thin.size(), 2u);
  EXPECT_TRUE(by_group.says("VCC"));
  file.layers = {"F.Cu", "In1.Cu", "B.Cu"};
  file.layer = {0, 1, 2};
  const Read by_layer(svg_of(file));
  EXPECT_EQ(by_layer.thin.size(), 3u);
  EXPECT_TRUE(by_layer.says("In1.Cu"));
  EXPECT_FALSE(by_layer.says("VCC"));
  EXPECT_TRUE(by_layer.says("3 segments of 3 features, 3 layers, 2 groups; none meet"));
}

// A line of this many segments that wanders about.
std::vector<Segment> coastline(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Segment> segments;
  double angle = 0;
  Point2 p{0, 0};
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (std::size_t i = 0; i < n; ++i) {
    angle += 2 * uniform() - 1;
    const Point2 q{p.x + std::cos(angle), p.y + std::sin(angle)};
    segments.push_back({p, q});
    p = q;
  }
  return segments;
}

TEST(SegmentsPicture, ALongCoastlineStaysSmall) {
  const io::LineFile file = file_of(coastline(100000, 1));
  const Segments segments(file.segments);
  const std::string svg = segments_svg({file, segments, {}, "Coastline"});
  EXPECT_LT(svg.size(), 3000000u);
  EXPECT_GT(svg.size(), 10000u);
  const Read picture(svg);
  const std::vector<Polyline> lines = polylines_of(picture.thin.at(0));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].size(), 100001u);
}

TEST(SegmentsPicture, WithAllItsContactsToo) {  // each segment shares an end with the next; many cross
  const std::string svg = svg_of(file_of(coastline(100000, 1)));
  EXPECT_LT(svg.size(), 6000000u);
  const Read picture(svg);
  EXPECT_TRUE(picture.says("Bold: segments of the first 5000 contacts."));
  expect_apart(picture.rings);
}

TEST(SegmentsPicture, AMeshStaysSmall) {
  // The edges of a triangulated square grid, in no order.
  std::mt19937_64 random(2);
  std::vector<Segment> segments;
  for (int x = 0; x < 183; ++x) {
    for (int y = 0; y < 183; ++y) {
      const double a = x * 0.37, b = y * 0.37;
      segments.push_back({{a, b}, {a + 0.37, b}});
      segments.push_back({{a, b}, {a, b + 0.37}});
      segments.push_back({{a, b}, {a + 0.37, b + 0.37}});
    }
  }
  ASSERT_GT(segments.size(), 100000u);
  for (std::size_t i = segments.size(); i > 1; --i) std::swap(segments[i - 1], segments[random() % i]);
  const io::LineFile file = file_of(segments);
  const std::string svg = segments_svg({file, Segments(segments), {}, "Mesh"});
  EXPECT_LT(svg.size(), 8000000u);
  EXPECT_GT(polylines_of(Read(svg).thin.at(0)).size(), 90000u);
}

// S2: of so many that lines would be over 6 MB, the density.
TEST(SegmentsPicture, VeryManyBecomeSquares) {
  std::mt19937_64 random(5);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Segment> segments;
  for (int k = 0; k < 600'000; ++k) {
    const Point2 p{uniform(), uniform()};
    segments.push_back({p, {p.x + 0.01 * uniform(), p.y + 0.01 * uniform()}});
  }
  const io::LineFile file = file_of(segments);
  const std::string svg = segments_svg({file, Segments(segments), {}});
  EXPECT_LT(svg.size(), 2'000'000u);
  const Read picture(svg);
  EXPECT_TRUE(picture.thin.empty());
  EXPECT_TRUE(picture.says("Too many segments for lines"));
}

// Crossings in a square, their places drawn from `place`.
std::vector<Segment> crosses(std::size_t n, const std::function<Point2(std::size_t)>& place) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 p = place(i);
    segments.push_back({{p.x - 1e-6, p.y}, {p.x + 1e-6, p.y}});
    segments.push_back({{p.x, p.y - 1e-6}, {p.x, p.y + 1e-6}});
  }
  return segments;
}

TEST(SegmentsPicture, RingsThatCrowdBecomeOne) {
  std::mt19937_64 random(3);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto everywhere = [&](std::size_t) { return Point2{uniform(), 0.7 * uniform()}; };
  const auto a_heap = [&](std::size_t i) {
    return i == 0 ? Point2{0, 0} : i == 1 ? Point2{1, 1} : Point2{0.3, 0.3 + 1e-3 * uniform()};
  };
  const auto a_line = [](std::size_t i) { return Point2{2 * static_cast<double>(i), static_cast<double>(i)}; };
  const auto a_grid = [](std::size_t i) {
    return Point2{static_cast<double>(i % 20), static_cast<double>(i / 20 % 20)};
  };
  const std::vector<std::function<Point2(std::size_t)>> places{everywhere, a_heap, a_line, a_grid};
  for (const auto& place : places) {
    const io::LineFile file = file_of(crosses(10000, place));
    const Segments segments(file.segments);
    std::vector<SegmentsContact> contacts;  // only these, for a count that is known
    for (std::uint32_t i = 0; i < segments.size(); i += 2) {
      contacts.push_back({i, i + 1, planar::ContactKind::crossing});
    }
    const std::string svg = segments_svg({file, segments, contacts, "Crosses"});
    EXPECT_LT(svg.size(), 4000000u);
    const Read picture(svg);
    expect_apart(picture.rings);
    std::size_t sum = 0;
    for (const Ring& ring : picture.rings) {
      sum += count_of(ring);
      EXPECT_GE(ring.left, 0);
      EXPECT_LE(ring.right, picture.width);
    }
    EXPECT_EQ(sum, 10000u);
    EXPECT_GT(picture.rings.size(), 2u);
    EXPECT_EQ(picture.dots.size(), 1u);
  }
}

TEST(SegmentsPicture, LabelsOfRings) {
  // A heap of consecutive contacts, a pair that is not, and one alone; the last is of two kinds.
  const io::LineFile file = file_of(crosses(8, [](std::size_t i) {
    return std::array<Point2, 8>{{{0, 0}, {5, 5}, {9, 0}, {9, 1e-3}, {9, 2e-3}, {0, 1e-3}, {0, 9}, {0, 9}}}[i];
  }));
  const Segments segments(file.segments);
  std::vector<SegmentsContact> contacts;
  for (std::uint32_t i = 0; i < 16; i += 2) contacts.push_back({i, i + 1, planar::ContactKind::crossing});
  contacts.back().kind = planar::ContactKind::touch;
  const Read picture(segments_svg({file, segments, contacts}));
  std::vector<std::pair<std::string, std::string>> labels;
  for (const Ring& ring : picture.rings) labels.emplace_back(ring.label, ring.kind);
  std::sort(labels.begin(), labels.end());
  EXPECT_EQ(labels, (std::vector<std::pair<std::string, std::string>>{
                        {"1, 6", "m c"}, {"2", "m c"}, {"3-5", "m c"}, {"7, 8", "m x"}}));
  const auto mixed = std::find_if(picture.rings.begin(), picture.rings.end(), [](auto& r) { return r.kind == "m x"; });
  EXPECT_EQ(mixed->told.substr(0, 31), "2 contacts: 1 crossing, 1 touch");
  EXPECT_NE(mixed->told.find("\ncontact 7: "), std::string::npos);
  EXPECT_TRUE(picture.says("Dark rings"));
}

TEST(SegmentsPicture, CoordinatesOfAnySize) {
  const double huge = 1.7976931348623157e308, tiny = 5e-324;
  const std::vector<std::vector<Segment>> cases{{{{0, 0}, {0, 0}}},
                                                {{{huge, -huge}, {huge, -huge}}},
                                                {{{-huge, -huge}, {huge, huge}}, {{-huge, huge}, {huge, -huge}}},
                                                {{{-1e300, 0}, {1e300, 0}}, {{0, 0}, {1, 1}}},
                                                {{{0, -1e300}, {0, 1e300}}, {{0, 0}, {1, 1}}},
                                                {{{0, 0}, {tiny, tiny}}, {{0, tiny}, {tiny, 0}}},
                                                {{{0, 0}, {huge, tiny}}, {{0, tiny}, {huge, 0}}},
                                                {{{tiny, 0}, {0, huge}}, {{tiny, 5}, {-tiny, 7}}},
                                                {{{1e16, 0}, {1e16 + 2, 2}}, {{1e16, 2}, {1e16 + 2, 0}}},
                                                {{{5, 0}, {5, 9}}, {{5, 3}, {5, 12}}},
                                                {{{0, 5}, {9, 5}}, {{3, 5}, {12, 5}}},
                                                {{{0, 0}, {1e6, 1}}, {{0, 1}, {1e6, 0}}},
                                                {{{0, 0}, {1, 1e6}}, {{0, 1e6}, {1, 0}}},
                                                {{{1e308, 1e308}, {1.5e308, 1.2e308}}, {{-1.5e308, 1e308}, {0, -0.0}}},
                                                {{{1, 2}, {3, 4}}, {{3, 4}, {1, 2}}, {{2, 3}, {2, 3}}}};
  for (const std::vector<Segment>& segments : cases) {
    for (const bool y_down : {false, true}) {
      std::ostringstream about;
      about << segments[0].a.x << " " << segments[0].a.y << " to " << segments[0].b.x << " " << segments[0].b.y;
      SCOPED_TRACE(about.str());
      const Read picture(svg_of(file_of(segments), "", y_down));
      EXPECT_GT(picture.height, 150);
      EXPECT_LT(picture.height, 2000);
      ASSERT_EQ(picture.thin.size(), 1u);
      for (const Polyline& line : polylines_of(picture.thin[0])) {
        for (const auto& [x, y] : line) {
          EXPECT_TRUE(0 <= x && x <= 10 * picture.width && 0 <= y && y <= 10 * picture.height) << x << " " << y;
        }
      }
      for (const Ring& ring : picture.rings) {
        EXPECT_TRUE(0 < ring.left && ring.right < picture.width && 0 < ring.top && ring.bottom < picture.height);
      }
      EXPECT_EQ(picture.rings.empty(), contacts_of(Segments(segments)).empty());
    }
  }
}

TEST(SegmentsPicture, SaysWhereItIsNotToOneScale) {
  EXPECT_TRUE(Read(svg_of("0,0,1e6,1\n")).says("Not to one scale"));
  EXPECT_TRUE(Read(svg_of("0,0,1,1e300\n")).says("Not to one scale"));
  EXPECT_FALSE(Read(svg_of("0,0,10,1\n")).says("Not to one scale"));
  EXPECT_FALSE(Read(svg_of("0,0,10,0\n")).says("Not to one scale"));
}

TEST(SegmentsPicture, TicksAreRoundNumbers) {
  const Read picture(svg_of("0.3,0.1,99.7,50.2\n"));
  for (const char* text : {"10", "20", "90", "40"}) EXPECT_TRUE(picture.says(text)) << text;
  const Read coarse(svg_of("10000000000000000,0,10000000000000002,2\n"));  // no doubles between
  EXPECT_TRUE(coarse.says("1e+16"));
  EXPECT_TRUE(coarse.says("1.0000000000000002e+16"));
}

TEST(SegmentsPicture, TheSameInputGivesTheSameText) {
  const io::LineFile file = file_of(coastline(3000, 4));
  EXPECT_EQ(svg_of(file, "Twice"), svg_of(file, "Twice"));
}

}  // namespace
}  // namespace sunder::picture
