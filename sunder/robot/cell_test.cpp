#include <sunder/io/robot/joint_table.h>
#include <sunder/robot/cell.h>
#include <sunder/robot/rows.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
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
  cell.add_srdf(io::read_srdf(srdf_file), "arm.srdf", "", "--srdf");
  EXPECT_EQ(words_of(cell, cell.disabled(remarks)), (Names{"base upper Adjacent", "base lower Never"}));
  EXPECT_EQ(remarks, (Names{"arm.srdf allows 2 pairs: 1 Adjacent, 1 Never",
                            "arm.srdf: pairs of links without a shape are passed over: tool, finger",
                            "arm.srdf: pairs of links that the robot does not have are passed over: gone"}));

  Cell other(std::vector<CellFile>{{arm_file}}, {.leave_out = true});
  io::Srdf twice = io::parse_srdf(
      "<robot name='arm'><disable_collisions link1='base' link2='lower'/>"
      "<disable_collisions link1='lower' link2='base' reason='Never'/></robot>",
      "s");
  other.add_srdf(std::move(twice), "s", "", "--srdf");
  EXPECT_EQ(words_of(other, other.disabled(remarks)), (Names{"base lower without a reason"}));

  remarks.clear();
  cell.keep_groups(Names{"upper_arm"}, "--group", remarks);
  EXPECT_EQ(body_names(cell), (Names{"upper", "lower"}));
  EXPECT_EQ(remarks, (Names{"of the robot 2 of 3 links with shapes are asked about, those of --group upper_arm"}));
  EXPECT_EQ(cell.left_out().texts(), (Names{"1 ellipsoid of base", "1 shape of base"}));
  EXPECT_EQ(words_of(cell, cell.disabled(remarks)), Names{});
  EXPECT_EQ(words_of(cell, cell.adjacent("")), (Names{"upper lower adjacent"}));
  EXPECT_EQ(cell_error([&] { cell.keep_groups(Names{"hand"}, "--group", remarks); }),
            "--group: no link of the group has a shape, so there is nothing to ask about");
}

// Bodies of files stay, and have other numbers then.
TEST(Cell, GroupsKeepWhatFilesAllow) {
  const fs::path scene = write_file("cell_kept.json", scene_of("m", "floor"));
  Names remarks;
  Cell cell(std::vector<CellFile>{{arm_file}, {scene.string()}}, {.leave_out = true});
  const Names allowed{"floor post " + scene.string()};
  EXPECT_EQ(words_of(cell, cell.allowed_by_files()), allowed);
  cell.add_srdf(io::read_srdf(srdf_file), srdf_file, "", "--srdf");
  cell.keep_groups(Names{"upper_arm"}, "--group", remarks);
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

// Two of one kind, and a third one: what several have is named after its robot, in whatever order they come.
TEST(Cell, HasSeveralRobots) {
  const fs::path tool = write_file("tool.urdf",
                                   "<robot name='tool'><link name='lower'><collision><geometry><sphere radius='1'/>"
                                   "</geometry></collision></link><link name='jaw'/><joint name='grasp' "
                                   "type='continuous'><parent link='lower'/><child link='jaw'/></joint></robot>");
  Names remarks;
  const solid::Pose aside = solid::Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {50, 0, 0});
  Cell cell(std::vector<CellFile>{{arm_file, "left"}, {arm_file, "right", aside}, {tool.string()}},
            {.leave_out = true});
  EXPECT_EQ(body_names(cell),
            (Names{"left/base", "left/upper", "left/lower", "right/base", "right/upper", "right/lower", "tool/lower"}));
  EXPECT_EQ(cell.left_out().texts(), Names{"2 ellipsoids of base"});
  const Names joints = io::movable_joints(cell.robot(""));
  EXPECT_EQ(std::set<std::string>(joints.begin(), joints.end()),
            (std::set<std::string>{"left/shoulder", "left/elbow", "left/slide", "right/shoulder", "right/elbow",
                                   "right/slide", "grasp"}));
  EXPECT_EQ(words_of(cell, cell.adjacent("")),
            (Names{"left/base left/upper adjacent", "left/upper left/lower adjacent", "right/base right/upper adjacent",
                   "right/upper right/lower adjacent"}));

  // Each moves by its own values, as it does alone.
  Cell alone(std::vector<CellFile>{{arm_file, "arm", aside}}, {.leave_out = true});
  const std::vector<scene::Body> both = cell.place({{"left/elbow", -2}, {"right/elbow", -1.5}, {"right/slide", 1}}),
                                 one = alone.place({{"elbow", -1.5}, {"slide", 1}});
  for (std::size_t b = 0; b < one.size(); ++b) {
    EXPECT_EQ(both[3 + b].parts[0].pose.affine(), one[b].parts[0].pose.affine());
  }
  EXPECT_NE(both[2].parts[0].pose.affine().linear, both[5].parts[0].pose.affine().linear);
  EXPECT_EQ(cell_error([&] { (void)cell.place({{"elbow", -2}}); }),
            "joint 'elbow': the robots have no joint of this name, but left/elbow and right/elbow; give one of these");
  EXPECT_EQ(cell_error([&] { (void)cell.body_named("upper", "--allow"); }),
            "--allow: no body is named 'upper', but left/upper and right/upper; give one of these");

  // An SRDF is about the robots that it names, or about the one that the call names.
  cell.add_srdf(io::read_srdf(srdf_file), "arm.srdf", "", "--srdf");
  EXPECT_EQ(words_of(cell, cell.disabled(remarks)),
            (Names{"left/base left/upper Adjacent", "left/base left/lower Never", "right/base right/upper Adjacent",
                   "right/base right/lower Never"}));
  EXPECT_EQ(remarks[0], "arm.srdf allows 4 pairs: 2 Adjacent, 2 Never");
  using Values = std::map<std::string, double>;
  EXPECT_EQ(cell.state("right/up", "--state", remarks).values, (Values{{"right/elbow", -1.5}, {"right/shoulder", 1}}));
  EXPECT_EQ(cell.state("up, left/hand/open", "--state", remarks).values, (Values{{"left/elbow", -1.5},
                                                                                 {"left/shoulder", 1},
                                                                                 {"left/slide", 1.5},
                                                                                 {"right/elbow", -1.5},
                                                                                 {"right/shoulder", 1}}));
  EXPECT_TRUE(cell_error([&] {
                (void)cell.state("tool/up", "--state", remarks);
              }).starts_with("--state: no SRDF is given that could have 'tool/up'"));
  EXPECT_TRUE(cell_error([&] { (void)cell.state("down", "--state", remarks); }).starts_with("--state: there is no st"));
  io::Srdf crane;
  crane.name = "crane";
  EXPECT_EQ(cell_error([&] { cell.add_srdf(crane, "c.srdf", "", "--srdf"); }),
            "--srdf: c.srdf is about the robot 'crane', and no URDF file has this name; give NAME=c.srdf, where names "
            "are left, right, tool");
  EXPECT_EQ(cell_error([&] { cell.add_srdf(crane, "c.srdf", "up", "--srdf"); }),
            "--srdf: no robot is named 'up'; robots are left, right, tool");
  remarks.clear();
  cell.keep_groups(Names{"right/upper_arm"}, "--group", remarks);
  EXPECT_EQ(body_names(cell),
            (Names{"left/base", "left/upper", "left/lower", "right/upper", "right/lower", "tool/lower"}));
  EXPECT_EQ(remarks, (Names{"of right 2 of 3 links with shapes are asked about, those of --group right/upper_arm"}));

  const Cell unnamed(std::vector<CellFile>{{arm_file}, {arm_file}}, {.leave_out = true});
  EXPECT_EQ(unnamed.robots()[1].name, "arm#2");
}

// What is attached moves with its link, in every placement, and may meet what holds it.
TEST(Cell, AttachesToLinks) {
  const fs::path scene = write_file("cell_parts.json", scene_of("m", "lid"));
  const std::string cube = (cases / "mesh" / "cube.obj").string();
  const fs::path tool = write_file("cell_hand.urdf",
                                   "<robot name='tool'><link name='mount'/><link name='palm'><collision><geometry>"
                                   "<sphere radius='1'/></geometry></collision></link><joint name='turn' "
                                   "type='continuous'><parent link='mount'/><child link='palm'/></joint></robot>");
  const solid::Pose ahead = solid::Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 2});
  Cell cell(std::vector<CellFile>{{arm_file, "arm", solid::Pose::from_quaternion(1, 2, 3, 4, {5, 6, 7})},
                                  {cube, "cup", ahead},
                                  {scene.string(), "parts"},
                                  {tool.string(), "hand", ahead}},
            {.leave_out = true});
  cell.attach("cup", "lower", "--attach");
  cell.attach("hand", "tool", "--attach");
  cell.attach("lid", "palm", "--attach", ahead);
  EXPECT_EQ(words_of(cell, cell.attached()), (Names{"lower palm attached", "lower cup attached", "palm lid attached"}));
  EXPECT_EQ(words_of(cell, cell.adjacent("")), (Names{"base upper adjacent", "upper lower adjacent"}));

  const std::map<std::string, double> values{{"shoulder", 0.25}, {"elbow", -2}, {"slide", 1}, {"turn", 3}};
  const std::vector<scene::Body> placed = cell.place(values);
  std::vector<Affine3> links(cell.robot("").links.size());
  io::RobotMotion(cell.robot(""), Names{"shoulder", "elbow", "slide", "turn"})
      .place(std::vector<double>{0.25, -2, 1, 3}, links);
  const auto moved = [&](const char* link, const solid::Pose& by) {
    const auto& all = cell.robot("").links;
    const auto number = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == link; });
    const Affine3 frame = cell.link_frame(static_cast<std::uint32_t>(number - all.begin()), links);
    return compose(solid::Pose::from_matrix(frame.linear, frame.translation), by).affine();
  };
  EXPECT_EQ(placed[cell.body_named("cup", "")].parts[0].pose.affine(), moved("lower", ahead));
  EXPECT_EQ(moved("mount", {}), moved("tool", ahead));
  EXPECT_EQ(placed[cell.body_named("palm", "")].parts[0].pose.affine(), moved("palm", {}));
  EXPECT_EQ(placed[cell.body_named("lid", "")].parts[0].pose.affine(), moved("palm", ahead));
  EXPECT_EQ(placed[cell.body_named("post", "")].parts[0].pose.affine(), solid::Pose().affine()) << "it stands";

  const Names joints{"turn", "shoulder", "slide", "elbow"};
  const std::vector<double> row{3, 0.25, 1, -2};
  const Rows rows(cell, joints, row, 1);
  RowBodies by_row(rows, cell.place());
  for (std::size_t b = 0; b < placed.size(); ++b) {
    EXPECT_EQ(by_row.at(0)[b].parts[0].pose.affine(), placed[b].parts[0].pose.affine()) << placed[b].name;
  }

  const auto error = [&](const char* name, const char* link) {
    return cell_error([&] { cell.attach(name, link, "--attach"); });
  };
  EXPECT_EQ(error("cup", "base"), "--attach: 'cup' is attached to a link already; attach it to one");
  EXPECT_EQ(error("upper", "base"), "--attach: 'upper' is a link; attach a mesh, a body of a scene file, or a robot");
  EXPECT_EQ(error("arm", "palm"), "--attach: 'arm' would hang on itself; attach it to a link of another robot");
  EXPECT_EQ(error("hand", "palm"), "--attach: 'hand' would hang on itself; attach it to a link of another robot");
  EXPECT_TRUE(error("post", "wrist").starts_with("--attach: no link is named 'wrist'; links are base, upper,"));
  EXPECT_TRUE(error("pot", "base").starts_with("--attach: nothing is named 'pot'; names are arm, cup"));
}

TEST(Cell, RefusesWhatCannotBeOne) {
  Names remarks;
  const auto error = [&](const std::vector<CellFile>& files, const CellOptions& options = {}) {
    return cell_error([&] { Cell(files, options, nullptr, &remarks); });
  };
  const std::string feet = write_file("cell_feet.json", scene_of("ft", "floor")).string();
  const std::string crane = (cases / "scene" / "primitives.urdf").string();
  EXPECT_EQ(error({{crane}, {feet}}), feet + ": is in ft, but '" + crane + "' is in m; scale one of them");
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
        cell_error([&] { Cell(still).add_srdf({}, "", "", "joints"); })}) {
    EXPECT_TRUE(text.starts_with("joints: there is no robot")) << text;
  }
}

}  // namespace
}  // namespace sunder::robot
