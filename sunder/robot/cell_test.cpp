#include <sunder/io/robot/joint_table.h>
#include <sunder/robot/cell.h>
#include <sunder/robot/rows.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace sunder::robot {
namespace {

namespace fs = std::filesystem;
using tests::cases;
using Names = std::vector<std::string>;

const std::string arm_file = (cases / "mesh" / "arm.urdf").string();
const std::string srdf_file = (cases / "scene" / "arm.srdf").string();

fs::path write_file(const std::string& name, const std::string& text) {
  const fs::path path = fs::path(testing::TempDir()) / name;
  std::ofstream(path) << text;
  return path;
}

std::string scene_of(const std::string& unit, const std::string& name) {
  return R"({"unit": ")" + unit + R"(", "bodies": [{"name": ")" + name +
         R"(", "parts": [{"box": {"size": [9, 9, 1]}}]}, {"name": "post", "parts": [{"ball": {"center": [0, 0, 9],)" +
         R"( "radius": 1}}]}], "allowed": [["post", ")" + name + R"("]]})";
}

Names body_names(const Cell& cell) {
  Names names;
  for (const CellBody& body : cell.bodies()) names.push_back(body.name);
  return names;
}

Names words_of(const Cell& cell, const std::vector<AllowedPair>& pairs) {
  Names words;
  for (const AllowedPair& pair : pairs) {
    words.push_back(cell.bodies()[pair.bodies[0]].name + " " + cell.bodies()[pair.bodies[1]].name + " " + pair.reason);
  }
  return words;
}

template <class Action>
std::string cell_error(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Cell, HasWhatItsFilesHave) {
  const fs::path scene = write_file("cell_floor.json", scene_of("m", "lower"));
  Names remarks;
  InputFiles inputs;
  const std::vector<CellFile> files{
      {(cases / "mesh" / "cube.obj").string(), "base"},
      {arm_file, "arm"},
      {scene.string(), "", solid::Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, -7})}};
  const Cell cell(files, {.leave_out = true}, &inputs, &remarks);
  EXPECT_EQ(body_names(cell), (Names{"base", "base#2", "upper", "lower", "lower#2", "post"}));
  EXPECT_EQ(cell.unit(), "m");
  EXPECT_EQ(cell.robot("").name, "arm");
  EXPECT_EQ(cell.left_out().texts(), (Names{"1 ellipsoid of base"}));
  EXPECT_EQ(cell.meshes_read().size(), 2u);
  EXPECT_EQ(inputs.size(), 5u) << "three files, and two meshes that the robot names";
  EXPECT_EQ(words_of(cell, cell.allowed_by_files()), (Names{"lower#2 post " + scene.string()}));
  EXPECT_EQ(words_of(cell, cell.adjacent("")), (Names{"base#2 upper adjacent", "upper lower adjacent"}));
  EXPECT_TRUE(remarks.empty());
  EXPECT_EQ(cell.body_named("post", ""), 5u);
  EXPECT_TRUE(cell_error([&] {
                (void)cell.body_named("none", "--allow");
              }).starts_with("--allow: no body is named 'none'; bodies are base, base#2"));
}

TEST(Cell, TellsWhatAnSrdfAllows) {
  Names remarks;
  Cell cell(std::vector<CellFile>{{arm_file}}, {.leave_out = true});
  const io::Srdf srdf = io::read_srdf(srdf_file);
  EXPECT_EQ(words_of(cell, cell.disabled(srdf, "arm.srdf", "--srdf", remarks)),
            (Names{"base upper Adjacent", "base lower Never"}));
  EXPECT_EQ(remarks, (Names{"arm.srdf allows 2 pairs: 1 Adjacent, 1 Never",
                            "arm.srdf: pairs of links without a shape are passed over: tool, finger",
                            "arm.srdf: pairs of links that the robot does not have are passed over: gone"}));

  const io::Srdf twice = io::parse_srdf(
      "<robot name='arm'><disable_collisions link1='base' link2='lower'/>"
      "<disable_collisions link1='lower' link2='base' reason='Never'/></robot>",
      "s");
  EXPECT_EQ(words_of(cell, cell.disabled(twice, "s", "--srdf", remarks)), (Names{"base lower without a reason"}));

  remarks.clear();
  cell.keep_groups(srdf, Names{"upper_arm"}, "--group", remarks);
  EXPECT_EQ(body_names(cell), (Names{"upper", "lower"}));
  EXPECT_EQ(remarks, (Names{"of the robot 2 of 3 links with shapes are asked about, those of --group upper_arm"}));
  EXPECT_EQ(cell.left_out().texts(), (Names{"1 ellipsoid of base", "1 shape of base"}));
  EXPECT_EQ(words_of(cell, cell.disabled(srdf, "arm.srdf", "--srdf", remarks)), Names{});
  EXPECT_EQ(words_of(cell, cell.adjacent("")), (Names{"upper lower adjacent"}));
  EXPECT_EQ(cell_error([&] { cell.keep_groups(srdf, Names{"hand"}, "--group", remarks); }),
            "--group: no link of the group has a shape, so there is nothing to ask about");
}

// Bodies of files stay, and have other numbers then.
TEST(Cell, GroupsKeepWhatFilesAllow) {
  const fs::path scene = write_file("cell_kept.json", scene_of("m", "floor"));
  Names remarks;
  Cell cell(std::vector<CellFile>{{arm_file}, {scene.string()}}, {.leave_out = true});
  const Names allowed{"floor post " + scene.string()};
  EXPECT_EQ(words_of(cell, cell.allowed_by_files()), allowed);
  cell.keep_groups(io::read_srdf(srdf_file), Names{"upper_arm"}, "--group", remarks);
  EXPECT_EQ(body_names(cell), (Names{"upper", "lower", "floor", "post"}));
  EXPECT_EQ(words_of(cell, cell.allowed_by_files()), allowed);
}

TEST(Cell, ReadsPairsOfNames) {
  Names remarks;
  const Cell cell(std::vector<CellFile>{{arm_file}}, {.leave_out = true});
  const fs::path pairs = write_file("cell_pairs.txt", "base lower\ntool, upper  # no shape\n");
  EXPECT_EQ(words_of(cell, cell.pairs_in(pairs.string(), nullptr, remarks)), (Names{"base lower " + pairs.string()}));
  EXPECT_EQ(remarks, (Names{pairs.string() + ": lines about links without a shape are passed over: tool"}));
  std::ofstream(pairs) << "base gone\n";
  EXPECT_TRUE(cell_error([&] {
                (void)cell.pairs_in(pairs.string(), nullptr, remarks);
              }).starts_with(pairs.string() + ":1: no body is named 'gone'"));
}

TEST(Cell, OfAPairTheFirstReasonHolds) {
  std::vector<AllowedPair> list{{{1, 0}, "first"}};
  add_allowed(std::vector<AllowedPair>{{{0, 1}, "again"}, {{2, 2}, "itself"}, {{0, 2}, "other"}}, list);
  EXPECT_EQ(reason_of_each(list), (Names{"first", "other"}));
  EXPECT_EQ(bodies_of(list), (std::vector<std::array<std::uint32_t, 2>>{{1, 0}, {0, 2}}));
}

// A row places what values by name do, whatever else stands in the cell.
TEST(Cell, PlacesRowsAsValuesByName) {
  const fs::path scene = write_file("cell_row.json", scene_of("m", "floor"));
  Names remarks;
  Cell cell(std::vector<CellFile>{{scene.string()}, {arm_file, "arm"}}, {.leave_out = true});
  cell.file_named("arm", "--pose").pose = solid::Pose::from_quaternion(1, 2, 3, 4, {5, 6, 7});
  const io::JointTable table = io::parse_joint_table("elbow,shoulder\n-2,0.5\n-1.5,3\n", "t.csv");
  const Rows rows(cell, table);
  ASSERT_EQ(rows.size(), 2u);
  RowBodies placed(rows, cell.place());
  for (const std::size_t row : {1u, 0u}) {
    const std::span<const scene::Body> found = placed.at(row);
    const std::vector<scene::Body> named = cell.place({{"elbow", rows[row][0]}, {"shoulder", rows[row][1]}});
    ASSERT_EQ(found.size(), named.size());
    for (std::size_t b = 0; b < named.size(); ++b) {
      ASSERT_EQ(found[b].parts.size(), named[b].parts.size());
      for (std::size_t p = 0; p < named[b].parts.size(); ++p) {
        ASSERT_EQ(found[b].parts[p].pose.affine(), named[b].parts[p].pose.affine()) << named[b].name;
      }
    }
  }
  EXPECT_EQ(rows.name(1), "t.csv:3");
  EXPECT_TRUE(cell_error([&] {
                const io::JointTable wrong = io::parse_joint_table("knee\n1\n", "t.csv");
                Rows(cell, wrong).size();
              }).starts_with("joint 'knee': the robot has no joint of this name"));
  EXPECT_TRUE(
      cell_error([&] { (void)cell.file_named("leg", "--pose"); }).starts_with("--pose: nothing is named 'leg'"));
}

TEST(Cell, RefusesWhatCannotBeOne) {
  Names remarks;
  const auto error = [&](const std::vector<CellFile>& files, const CellOptions& options = {}) {
    return cell_error([&] { Cell(files, options, nullptr, &remarks); });
  };
  const std::string feet = write_file("cell_feet.json", scene_of("ft", "floor")).string();
  const std::string crane = (cases / "scene" / "primitives.urdf").string();
  EXPECT_EQ(error({{crane}, {feet}}), feet + ": is in ft, but '" + crane + "' is in m; scale one of them");
  EXPECT_EQ(error({{crane}, {crane}}), crane + ": a second robot; give one URDF file in a call");
  EXPECT_NE(error({{arm_file}}).find("--leave-out"), std::string::npos);
  const std::string bare = write_file("cell_bare.urdf", "<robot name='r'><link name='a'/></robot>").string();
  EXPECT_TRUE(error({{bare}}).starts_with(bare + ": no link has a shape"));
  EXPECT_TRUE(remarks.empty());
  EXPECT_EQ(error({{bare}}, {.leave_out = true}), "no error");
  EXPECT_EQ(remarks, (Names{"no link of " + bare + " has a collision shape, so nothing can meet"}));

  const Cell still(std::vector<CellFile>{{feet}});
  EXPECT_EQ(still.place().size(), 2u);
  for (const std::string& text :
       {cell_error([&] { (void)still.place({{"j", 0}}); }), cell_error([&] { (void)still.adjacent("joints"); }),
        cell_error([&] { (void)still.disabled({}, "", "joints", remarks); })}) {
    EXPECT_TRUE(text.starts_with("joints: there is no robot")) << text;
  }
}

}  // namespace
}  // namespace sunder::robot
