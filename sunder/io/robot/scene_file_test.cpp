#include <sunder/io/robot/scene_file.h>

#include <sunder/base/error.h>
#include <sunder/io/text/file.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace sunder::io {

namespace {

// A scene of one body `a`, of one part with these members.
std::string scene_of(const std::string& part, const std::string& more = "") {
  return R"({"bodies": [{"name": "a", "parts": [{)" + part + "}]}]" + more + "}";
}

std::string scene_refusal(const std::string& text) {
  try {
    (void)parse_scene_file(text, "s.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file) << text;
    const std::string said = error.what();
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    EXPECT_TRUE(said.starts_with("s.json: ")) << said;
    return said;
  }
  ADD_FAILURE() << "is taken: " << text;
  return "";
}

TEST(SceneFile, Workcell) {
  const auto path = std::filesystem::path(tests::cases_folder() + "/scene/workcell.json");
  const SceneFile scene = read_scene_file(path);
  EXPECT_EQ(scene.unit, "m");
  ASSERT_EQ(scene.bodies.size(), 4u);
  EXPECT_EQ(scene.bodies[0].name, "table");
  EXPECT_EQ(scene.allowed, (std::vector<std::array<std::uint32_t, 2>>{{2, 3}}));
  // 500 of a mesh in mm are half a metre.
  EXPECT_EQ(scene.bodies[1].parts[0].pose.affine().linear, (std::array<double, 9>{0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5}));
  EXPECT_EQ(scene.bodies[1].parts[0].pose.affine().translation, (std::array<double, 3>{0.5, 0, 1.25}));
  // A row of the matrix is a row of the pose.
  EXPECT_EQ(scene.bodies[3].parts[0].pose.affine().linear, (std::array<double, 9>{0, -1, 0, 1, 0, 0, 0, 0, 1}));

  LeftOutList left_out(false);
  InputFiles inputs;
  std::vector<std::filesystem::path> meshes;
  const auto parts = read_scene_parts(scene, path, false, left_out, &inputs, &meshes);
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(inputs.size(), 1u);
  EXPECT_EQ(meshes.size(), 1u);
  EXPECT_FALSE(parts[0][0].round.has_value());
  EXPECT_EQ(parts[0][0].body.hull.vertices().size(), 8u);
  ASSERT_TRUE(parts[0][1].round.has_value());
  EXPECT_EQ(parts[0][1].round->kind(), RoundKind::cylinder);
  EXPECT_EQ(parts[1][0].name, "0");  // the file says none
  EXPECT_EQ(parts[2][0].round->kind(), RoundKind::cone);
  EXPECT_EQ(parts[2][1].round->points().size(), 2u);
  EXPECT_EQ(parts[2][2].round->points().size(), 1u);
  EXPECT_EQ(parts[3][0].round->radius(), 0.03125);
  EXPECT_EQ(parts[3][0].round->points().size(), 3u);
  EXPECT_EQ(parts[3][1].round->kind(), RoundKind::ellipsoid);
  EXPECT_EQ(parts[3][2].body.shape, BodyShape::points);
}

TEST(SceneFile, PosesOfBodyAndPart) {
  const std::string ball = R"("ball": {"center": [0, 0, 0], "radius": 1})";
  const auto pose_of = [&](const std::string& body, const std::string& part) {
    const SceneFile scene = parse_scene_file(
        R"({"bodies": [{"name": "a", "pose": )" + body + R"(, "parts": [{"pose": )" + part + ", " + ball + "}]}]}",
        "s.json");
    return scene.bodies[0].parts[0].pose.affine();
  };
  // A quarter of a turn about z, then 1 along x; of what is 2 along x.
  const std::string turn = R"({"translation": [1, 0, 0], "quaternion": [1, 0, 0, 1]})";
  EXPECT_EQ(pose_of(turn, R"({"translation": [2, 0, 0]})").translation, (std::array<double, 3>{1, 2, 0}));
  EXPECT_EQ(pose_of(R"({"translation": [2, 0, 0]})", turn).translation, (std::array<double, 3>{3, 0, 0}));
  EXPECT_EQ(pose_of(turn, R"({"translation": [0, 0, 0]})").linear, (std::array<double, 9>{0, -1, 0, 1, 0, 0, 0, 0, 1}));
  // Exactly these numbers, where one of the two is the identity.
  const std::string odd = R"({"matrix": [[1, 0, 0, 0.1], [0, 1, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]]})";
  EXPECT_EQ(pose_of(odd, R"({"translation": [0, 0, 0]})").translation, (std::array<double, 3>{0.1, 0.2, 0.3}));
}

TEST(SceneFile, UnitsOfMeshes) {
  const auto scale = [](const std::string& scene_unit, const std::string& mesh) {
    return parse_scene_file(
               scene_of(R"("mesh": {"file": "x.stl", )" + mesh + "}", R"(, "unit": ")" + scene_unit + "\""), "s.json")
        .bodies[0]
        .parts[0]
        .mesh->scale;
  };
  using Three = std::array<double, 3>;
  EXPECT_EQ(scale("m", R"("unit": "mm")"), (Three{0.001, 0.001, 0.001}));
  EXPECT_EQ(scale("m", R"("unit": "in")"), (Three{0.0254, 0.0254, 0.0254}));
  EXPECT_EQ(scale("mm", R"("unit": "m", "scale": [1, 2, -1])"), (Three{1000, 2000, -1000}));
  EXPECT_EQ(scale("in", R"("unit": "ft")"), (Three{12, 12, 12}));
  EXPECT_EQ(scale("cm", R"("scale": 3)"), (Three{3, 3, 3}));
}

struct Row {
  std::string text, said;
};

TEST(SceneFile, RefusesInOneLineWithThePlace) {
  const std::string ball = R"("ball": {"center": [0, 0, 0], "radius": 1})";
  const std::string two =
      R"({"bodies": [{"name": "a", "parts": [{)" + ball + R"(}]}, {"name": "b", "parts": [{)" + ball + "}]}]";
  const Row rows[] = {
      {"", "is not JSON that can be read"},
      {"[]", "is no scene"},
      {R"({"type": "FeatureCollection"})", "is no scene"},
      {R"({"bodies": []})", "bodies: is empty"},
      {R"({"bodies": {}})", "bodies: is no list"},
      {R"({"bodies": [{"name": "a"}]})", "bodies[0]: has no \"parts\""},
      {R"({"bodies": [{"name": "a", "parts": []}]})", "bodies[0].parts: is empty"},
      {R"({"bodies": [{"name": "", "parts": []}]})", "bodies[0].name: is empty"},
      {R"({"bodies": [{"name": 1, "parts": []}]})", "bodies[0].name: is no text"},
      {scene_of(ball, R"(, "bodeis": 1)"), "the scene: the key 'bodeis' is not known"},
      {scene_of(ball, R"(, "unit": "km")"), "unit: 'km' is no unit"},
      {scene_of(ball, R"(, "unit": "m", "unit": "m")"), "the key 'unit' stands twice"},
      {scene_of(""), "bodies[0].parts[0]: has no shape"},
      {scene_of(ball + R"(, "points": [[0, 0, 0]])"), "has 2 shapes, points and ball"},
      {scene_of(ball + R"(, "mass": 1)"), "the key 'mass' is not known"},
      {scene_of(R"("ball": {"center": [0, 0, 0], "radius": -1})"), "bodies[0].parts[0].ball: "},
      {scene_of(R"("ball": {"center": [0, 0, NaN], "radius": 1})"), "at line 1"},
      {scene_of(R"("ball": {"center": [0, 0, 1e999], "radius": 1})"), "number overflow"},
      {scene_of(R"("ball": {"center": [0, 0], "radius": 1})"), "ball.center: is no list [x, y, z] of 3 numbers"},
      {scene_of(R"("ball": {"center": [0, 0, "1"], "radius": 1})"), "ball.center: '\"1\"' is not a number"},
      {scene_of(R"("cylinder": {"ends": [[0, 0, 0], [0, 0, 0]], "radius": 1})"), "bodies[0].parts[0].cylinder: "},
      {scene_of(R"("rounded": {"points": [], "radius": 1})"), "rounded.points: is empty"},
      {scene_of(R"("points": [])"), "points: is empty"},
      {scene_of(R"("points": [[0, 0, 0], [1, 2]])"), "points[1]: is no list"},
      {scene_of(R"("box": {"size": [1, -1, 1]})"), "box.size: -1 is below zero"},
      {scene_of(R"("box": {"size": 1})"), "box.size: is no list"},
      {scene_of(R"("mesh": 7)"), "mesh: is no object with the keys file, scale, unit"},
      {scene_of(R"("mesh": "")"), "mesh: is no name of a file"},
      {scene_of(R"("mesh": {"file": "a.stl", "scale": 0})"), "mesh.scale: is zero"},
      {scene_of(R"("mesh": {"file": "a.stl", "scale": [1, 0, 1]})"), "mesh.scale: is zero"},
      {scene_of(R"("mesh": {"file": "a.stl", "unit": "mm"})"), "mesh.unit: the scene has none"},
      {scene_of(ball + R"(, "pose": {})"), "bodies[0].parts[0].pose: is empty"},
      {scene_of(ball + R"(, "pose": {"matrix": [[1, 0, 0, 0]]})"), "pose.matrix: is no list of 3 or 4 rows"},
      {scene_of(ball + R"(, "pose": {"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]]})"),
       "[0].pose: the matrix is singular"},
      {scene_of(ball + R"(, "pose": {"matrix": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]})"), "parts[0].pose: "},
      {scene_of(ball + R"(, "pose": {"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]], "translation": [0, 0, 0]})"),
       "has a matrix and more"},
      {scene_of(ball + R"(, "pose": {"quaternion": [0, 0, 0, 0]})"), "bodies[0].parts[0].pose: "},
      {two + R"(, "allowed": [["a", "c"]]})", "allowed[0][1]: no body is named 'c'; bodies are a, b"},
      {two + R"(, "allowed": [["a", "a"]]})", "allowed[0]: names one body twice"},
      {two + R"(, "allowed": [["a"]]})", "allowed[0]: is no pair"},
      {two + R"(, "allowed": {}})", "allowed: is no list"},
      {R"({"bodies": [{"name": "a", "parts": [{)" + ball + R"(}]}, {"name": "a", "parts": [{)" + ball + "}]}]}",
       "bodies[1].name: 'a' is the name of bodies[0], too"},
      {R"({"bodies": [{"name": "a", "parts": [{"name": "p", )" + ball + R"(}, {"name": "p", )" + ball + "}]}]}",
       "bodies[0].parts[1].name: two parts of the body are named 'p'"},
  };
  for (const Row& row : rows) {
    EXPECT_NE(scene_refusal(row.text).find(row.said), std::string::npos) << row.text << "\n" << scene_refusal(row.text);
  }
  EXPECT_EQ(parse_scene_file(two + R"(, "allowed": [["b", "a"], ["a", "b"]]})", "s.json").allowed.size(), 1u);  // C3
}

}  // namespace

}  // namespace sunder::io
