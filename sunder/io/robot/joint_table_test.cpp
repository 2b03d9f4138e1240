#include <sunder/io/robot/joint_table.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace sunder::io {
namespace {

using namespace std::string_literals;
using Names = std::vector<std::string>;
using Values = std::vector<double>;

std::string table_error(const std::string& bytes) {
  try {
    (void)parse_joint_table(bytes, "t");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// As numpy.save() writes: header padded to 64 bytes.
std::string npy_of_table(const std::string& dictionary, const std::string& data, char version = 1) {
  std::string header = dictionary;
  const std::size_t before = version == 1 ? 10 : 12;
  while ((before + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string bytes = "\x93NUMPY"s + version + '\0';
  for (std::size_t k = 0; k < before - 8; ++k) bytes += static_cast<char>(header.size() >> (8 * k) & 0xff);
  return bytes + header + data;
}

template <class Bits, class Float>
std::string bytes_of(const std::vector<Float>& numbers) {
  std::string bytes;
  for (const Float x : numbers) {
    for (std::size_t k = 0; k < sizeof(Bits); ++k) {
      bytes += static_cast<char>(std::bit_cast<Bits>(x) >> (8 * k) & 0xff);
    }
  }
  return bytes;
}

const std::string doubles = bytes_of<std::uint64_t, double>({1, -0.1, 3, 4e300, 5, 6});
const std::string table_shape = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }";

TEST(JointTable, OfCsv) {
  const JointTable table = parse_joint_table("elbow, wrist\r\n0.1,-2\n\n\"3\",4e-1\n", "t");
  EXPECT_EQ(table.joints, (Names{"elbow", "wrist"}));
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.values, (Values{0.1, -2, 3, 0.4}));
  EXPECT_EQ(table.row(1)[1], 0.4);
  EXPECT_EQ(table.place(1), "t:4");
  EXPECT_EQ(parse_joint_table("\xef\xbb\xbf"
                              "elbow\n1\n",
                              "t")
                .joints,
            Names{"elbow"});  // a byte order mark
}

// A quote in the last row: then all rows are read one by one. The same numbers, on the same lines.
TEST(JointTable, IsTheSameHoweverItIsRead) {
  for (const std::string rows : {"1,2\n3,4\n", "1, 2\n\n\n\t3,  4e-400\n", "-1.5e3,.5\r\n\r\n0.1,7.\r\n", "1,2\n3,4",
                                 "1 ,2\n3,4 \n", "1,2\r3,4\r", "+1,2\n  \n3,4\n"}) {
    for (const char separator : {',', ';'}) {
      std::string text = "a,b\n" + rows;
      std::replace(text.begin(), text.end(), ',', separator);
      const std::string last = std::string(text.ends_with('\n') || text.ends_with('\r') ? "" : "\n") + "9" + separator;
      const JointTable at_once = parse_joint_table(text + last + "9\n", "t");
      const JointTable one_by_one = parse_joint_table(text + last + "\"9\"\n", "t");
      EXPECT_EQ(at_once.values, one_by_one.values) << text;
      EXPECT_EQ(at_once.lines, one_by_one.lines) << text;
      EXPECT_EQ(at_once.rows(), 3u) << text;
    }
  }
  for (const std::string rows : {"1,2\n3\n", "1,2,3\n", "1,2\n3,x\n", "1,inf\n", "1,1e400\n", "1;2\n"}) {
    EXPECT_NE(table_error("a,b\n" + rows), "no error") << rows;
  }
}

TEST(JointTable, OfNpy) {
  for (const char version : {'\1', '\2', '\3'}) {
    const JointTable table = parse_joint_table(npy_of_table(table_shape, doubles, version), "t");
    EXPECT_TRUE(table.joints.empty());
    EXPECT_EQ(table.columns, 3u);
    EXPECT_EQ(table.values, (Values{1, -0.1, 3, 4e300, 5, 6}));
    EXPECT_EQ(table.place(1), "t: row 1");
  }
  const std::string floats = bytes_of<std::uint32_t, float>({1.5f, -0.1f});
  const JointTable table =
      parse_joint_table(npy_of_table("{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2), }", floats), "t");
  EXPECT_EQ(table.values, (Values{1.5, static_cast<double>(-0.1f)}));
}

TEST(JointTable, SaysWhatIsWrong) {
  const auto of_kind = [](const std::string& what, const std::string& with, const std::string& data) {
    std::string text = table_shape;
    return table_error(npy_of_table(text.replace(text.find(what), what.size(), with), data));
  };
  const std::vector<std::pair<std::string, std::string>> expected{
      {table_error("a,b\n1,2\n1,x\n"), "t:3: joint 'b': 'x' is not a number"},
      {table_error("a,b\n1,2,3\n"), "t:2: 3 fields, but 2 columns"},
      {table_error("a,b\n1\n"), "t:2: 1 field, but 2 columns"},
      {table_error("a,a\n1,2\n"), "t:1: joint 'a' comes twice"},
      {table_error("1,2\n3,4\n"), "t:1: '1' is a number"},
      {table_error("a,\n3,4\n"), "t:1: a column has no name"},
      {table_error("a,b\n1,inf\n"), "t:2: joint 'b': 'inf' is infinite"},
      {table_error("a,b\n"), "t: there is no placement"},
      {table_error(npy_of_table(table_shape, doubles + "x")), "t: 49 bytes of numbers"},
      {table_error(npy_of_table(table_shape, doubles.substr(1))), "t: 47 bytes of numbers"},
      {table_error(npy_of_table(table_shape, doubles).substr(0, 40)), "t: the file is cut off"},
      {table_error(npy_of_table(table_shape, doubles).substr(0, 6)), "t: NPY version 0"},
      {of_kind("<f8", "<c8", doubles), "t: its numbers are of kind"},
      {of_kind("<f8", "<i8", doubles), "t: row 0: column 0 is no double"},
      {of_kind("False", "None", doubles), "t: its order is not told"},
      {of_kind("(2, 3)", "(6,)", doubles), "t: it has 1 dimension"},
      {of_kind("(2, 3)", "(1, 2, 3)", doubles), "t: it has 3 dimensions"},
      {of_kind("(2, 3)", "(0, 3)", ""), "t: it is empty"},
      {of_kind("(2, 3)", "(x, 3)", ""), "t: its shape is not of numbers"},
      {of_kind("(2, 3)", "(2305843009213693952, 4)", ""), "t: 0 bytes of numbers"},
      {of_kind("'shape'", "'form'", doubles), "t: its header has no 'shape'"},
      {table_error(npy_of_table(table_shape, bytes_of<std::uint64_t, double>({1, 2, 3, 4, HUGE_VAL, 6}))),
       "t: row 1: column 1 is not finite"},
  };
  for (const auto& [is, begins] : expected) EXPECT_TRUE(is.starts_with(begins)) << is << "\n" << begins;
}

// Memory is in proportion to the file: what so many lines of so many columns could hold would be 64 GB.
TEST(JointTable, AsksForNoMemoryForBlankLines) {
  std::string text = "j0", row = "0";
  for (int k = 1; k < 4000; ++k) {
    text += ",j" + std::to_string(k);
    row += ",1";
  }
  text += std::string(2000000, '\n') + row;
  const JointTable table = parse_joint_table(text, "t");
  EXPECT_EQ(table.rows(), 1u);
  EXPECT_EQ(table.lines.front(), 2000001u);
  EXPECT_LE(table.values.capacity() * sizeof(double), 8 * text.size());
}

// Long enough for several pieces, of lines of many lengths, some blank.
TEST(JointTable, SameOnAnyNumberOfThreads) {
  std::string text = "a,b\n";
  for (int k = 0; k < 60000; ++k) {
    text += std::to_string(k) + "," + (k % 3 == 0 ? "-0.1234567890123456" : "7") + (k % 5 == 0 ? "\r\n" : "\n");
    if (k % 7 == 0) text += "\n";
  }
  const auto expect_same = [&](const std::string& of, const std::string& name) {
    const JointTable one = parse_joint_table(of, "t");
    ASSERT_GE(one.rows(), 60000u) << name;
    for (const std::size_t threads : {2u, 3u, 7u}) {
      const JointTable several = parse_joint_table(of, "t", threads);
      EXPECT_EQ(several.values, one.values) << name << " on " << threads;
      EXPECT_EQ(several.lines, one.lines) << name << " on " << threads;
    }
  };
  expect_same(text, "plain");
  expect_same(text + "1,2", "the last line open");
  expect_same(text + "\"1\",2\n", "a quoted field, which is not plain");
  EXPECT_EQ(parse_joint_table(text, "t").lines[1], 4u);
  const auto error_on = [&](std::size_t threads) {
    try {
      (void)parse_joint_table(text + "1\n" + text.substr(4), "t", threads);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_on(3), error_on(1));
  EXPECT_TRUE(error_on(3).find("1 field") != std::string::npos) << error_on(3);
}

// Times are dropped, degrees become radians; what is neither stays, for RobotMotion to refuse.
TEST(JointTable, FitsARobot) {
  const Robot robot = parse_urdf(R"(<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>
    <joint name="turn" type="continuous"><parent link="a"/><child link="b"/></joint>
    <joint name="slide" type="prismatic"><parent link="b"/><child link="c"/><limit lower="0" upper="1"/></joint>
    <joint name="t" type="continuous"><parent link="c"/><child link="d"/></joint></robot>)",
                                 "r.urdf");
  std::vector<std::string> remarks;
  const auto fit = [&](const std::string& text) {
    remarks.clear();
    JointTable table = parse_joint_table(text, "t.csv");
    try {
      fit_joint_table(robot, table, remarks);
    } catch (const Error& error) {
      remarks = {error.what()};
    }
    return table;
  };
  const JointTable plain = fit("slide,turn\n1,2\n");
  EXPECT_EQ(plain.values, (std::vector<double>{1, 2}));
  EXPECT_TRUE(remarks.empty());

  const JointTable fitted = fit("Time [s],slide,turn (deg),t,stamp.sec\n0,1,180,3,9\n1,2,-90,4,9\n");
  EXPECT_EQ(fitted.joints, (std::vector<std::string>{"slide", "turn", "t"}));
  EXPECT_EQ(fitted.columns, 3u);
  ASSERT_EQ(fitted.rows(), 2u);
  const double half_turn = std::acos(-1.0);
  EXPECT_EQ(std::vector<double>(fitted.row(0).begin(), fitted.row(0).end()), (std::vector<double>{1, half_turn, 3}));
  EXPECT_EQ(std::vector<double>(fitted.row(1).begin(), fitted.row(1).end()),
            (std::vector<double>{2, -half_turn / 2, 4}));
  EXPECT_EQ(remarks, (std::vector<std::string>{"t.csv: column 'Time [s]' has times, and is left out",
                                               "t.csv: column 'turn (deg)' is in degrees; its values are rounded to "
                                               "radians",
                                               "t.csv: column 'stamp.sec' has times, and is left out"}));
  for (const char* name : {"turn_deg", "turn.degrees", "turn [deg]", "turn deg"}) {
    EXPECT_EQ(fit(std::string(name) + "\n1\n").joints, std::vector<std::string>{"turn"}) << name;
  }
  for (const char* name : {"turndeg", "deg", "_deg", "turn_rad", "timer", "knee_deg", "sim_time", "]"}) {
    EXPECT_EQ(fit(std::string(name) + "\n1\n").joints, std::vector<std::string>{name});
    EXPECT_TRUE(remarks.empty()) << name;
  }
  fit("slide_deg\n1\n");
  EXPECT_EQ(remarks, std::vector<std::string>{"joint 'slide': slides, so it takes metres, not degrees"});
  fit("turn,turn_deg\n1,1\n");
  EXPECT_EQ(remarks, std::vector<std::string>{"t.csv: joint 'turn' has two columns; keep one of them"});
  fit("time\n1\n");
  EXPECT_EQ(remarks, std::vector<std::string>{"t.csv: there is no column of a joint; give one"});
}

}  // namespace
}  // namespace sunder::io
