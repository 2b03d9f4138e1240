#include <sunder/picture/scene.h>

#include <gtest/gtest.h>

#include <iterator>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder::picture {
namespace {

// A row of boxes of which each overlaps the next one.
std::vector<scene::Body> row_of(std::size_t count) {
  std::vector<scene::Body> bodies;
  std::vector<Point3> corners;
  for (unsigned i = 0; i < 8; ++i) corners.push_back({1.25 * (i & 1u), 1.0 * (i >> 1u & 1u), 1.0 * (i >> 2u)});
  const solid::RoundBody box{solid::ConvexPolyhedron(corners)};
  for (std::size_t k = 0; k < count; ++k) {
    const auto pose = solid::Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {static_cast<double>(k), 0, 0});
    bodies.push_back({"box" + std::to_string(k), {{"0", box, pose}}});
  }
  return bodies;
}

std::string picture_of(const std::vector<scene::Body>& bodies) {
  const scene::Answer answer = scene::meeting_pairs(bodies);
  const ScenePanel panel{"", bodies, answer};
  return scene_svg(std::span(&panel, 1), "");
}

// Where the contacts are told in words.
std::vector<std::pair<std::string, std::string>> places_of(const std::string& svg) {
  static const std::regex line("<text x='([0-9.]+)' y='([0-9.]+)'[^>]*>[0-9]+\\. box");
  std::vector<std::pair<std::string, std::string>> places;
  for (std::sregex_iterator it(svg.begin(), svg.end(), line), end; it != end; ++it)
    places.emplace_back((*it)[1], (*it)[2]);
  return places;
}

TEST(ScenePicture, ManyContactsAreListedByNumber) {
  const std::string few = picture_of(row_of(5)), some = picture_of(row_of(30)), many = picture_of(row_of(61));
  EXPECT_EQ(places_of(few).size(), 4u);
  EXPECT_EQ(places_of(some).size(), 29u);
  EXPECT_EQ(some.find(" more<"), std::string::npos);
  EXPECT_NE(many.find("60 of 1830 pairs meet"), std::string::npos);
  EXPECT_NE(many.find(">1. box0 and box1 meet<"), std::string::npos);
  EXPECT_NE(many.find(">40. box39 and box40 meet<"), std::string::npos);
  EXPECT_NE(many.find(">and 20 more<"), std::string::npos);
  for (const std::string& svg : {few, some, many}) {
    const auto places = places_of(svg);
    EXPECT_EQ((std::set(places.begin(), places.end()).size()), places.size());  // none over another
    EXPECT_EQ(svg.find("nan"), std::string::npos);
  }
  std::set<std::string> columns;
  for (const auto& [x, y] : places_of(many)) columns.insert(x);
  EXPECT_EQ(columns.size(), 2u);
}

// What is said of hulls is said as that, and what the answer does not speak of stands below it.
TEST(ScenePicture, SaysWhatHullsAndNotesSay) {
  const std::vector<scene::Body> bodies = row_of(4);
  const scene::Answer answer = scene::meeting_pairs(bodies);
  ScenePanel panel{"", bodies, answer};
  EXPECT_EQ(scene_svg(std::span(&panel, 1), "").find("hulls"), std::string::npos);
  panel.is_hull = [](std::uint32_t body, std::uint32_t) { return body == 3; };
  panel.notes = {"allowed to meet, so not tested: 1 pair of bodies (1 Never)"};
  const std::string svg = scene_svg(std::span(&panel, 1), "");
  EXPECT_NE(svg.find(">1. box0 and box1 meet<"), std::string::npos);
  EXPECT_NE(svg.find(">3. box2 and box3 meet as hulls<"), std::string::npos);
  EXPECT_NE(svg.find("meshes that are not convex are asked about, and drawn, as their hulls"), std::string::npos);
  EXPECT_NE(svg.find(">" + panel.notes[0] + "<"), std::string::npos);
}

// A wedge with a dent: its faces that are turned to the viewer are drawn, not those of its hull.
scene::Part dented(bool is_open) {
  const std::vector<Point3> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0.5, 0.5, 0.5}};
  std::vector<std::uint32_t> begin{0, 3, 6, 9}, corners{0, 2, 1, 0, 1, 3, 0, 3, 2};
  for (const auto& [i, j] : {std::pair(1u, 2u), std::pair(2u, 3u), std::pair(3u, 1u)}) {
    if (is_open && i == 3) break;
    corners.insert(corners.end(), {i, j, 4});
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return {"0", solid::ConvexPolyhedron(points), solid::Pose(),
          std::make_shared<const solid::Mesh>(solid::MeshView{points, begin, corners})};
}

TEST(ScenePicture, DrawsMeshesAsTheyAre) {
  const auto faces = [](const scene::Part& part) {
    const std::vector<scene::Body> bodies{{"dented", {part}}};
    const scene::Answer answer = scene::meeting_pairs(bodies);
    ScenePanel panel{"", bodies, answer, [](std::uint32_t, std::uint32_t) { return true; }};
    const std::string svg = scene_svg(std::span(&panel, 1), "");
    EXPECT_EQ(svg.find("and drawn, as their hulls") == std::string::npos, part.mesh != nullptr);
    static const std::regex path("<path d='[^']*' fill='[^']*' stroke='");
    return std::distance(std::sregex_iterator(svg.begin(), svg.end(), path), std::sregex_iterator());
  };
  scene::Part hull = dented(false);
  hull.mesh = nullptr;
  const auto of_hull = faces(hull), closed = faces(dented(false)), open = faces(dented(true));
  EXPECT_LE(of_hull, 3);
  EXPECT_GE(closed, 3);
  EXPECT_EQ(open, 5);  // one sees into it
}

}  // namespace
}  // namespace sunder::picture
