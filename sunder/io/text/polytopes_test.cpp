#include <sunder/io/text/polytopes.h>

#include <gtest/gtest.h>

#include <string>

namespace sunder::io {
namespace {

std::string polytope_error(std::string_view text) {
  try {
    static_cast<void>(parse_polytope(text, "f.csv"));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.what();
  }
  return "none";
}

TEST(Polytopes, PointsWithAndWithoutNames) {
  const auto named = parse_polytope("X1;x2;x3;x4\n1;2;3;4\n\n5;6;7;8e-1\n", "");
  EXPECT_TRUE(named.is_of_points());
  EXPECT_EQ(named.dimension(), 4u);
  EXPECT_EQ(named.size(), 2u);
  EXPECT_EQ(named.row(1)[3], 0.8);
  EXPECT_EQ(parse_polytope("1,2,3,4,5\n", "").dimension(), 5u);
}

TEST(Polytopes, HalfSpaces) {
  const auto given = parse_polytope("a1,a2,a3,b\n1,0,0,0.5\n", "");
  EXPECT_FALSE(given.is_of_points());
  EXPECT_EQ(given.dimension(), 3u);
  EXPECT_EQ(given.row(0)[3], 0.5);
  EXPECT_EQ(parse_polytope("a1,a2,b\n", "").size(), 0u);  // everything
}

// As numpy.save() writes them.
std::string npy(const std::string& kind, const std::string& fortran, const std::string& shape, std::string_view data) {
  std::string header = "{'descr': '" + kind + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
  header.resize(117, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += '\1';
  bytes += '\0';
  bytes += static_cast<char>(header.size());
  bytes += '\0';
  return bytes.append(header).append(data);
}

TEST(Polytopes, OfNpy) {
  const std::string_view rows = {"\1\2\3\4\5\xff", 6};  // -1 where they have signs
  const auto points = parse_polytope(npy("|i1", "False", "(2, 3)", rows), "");
  EXPECT_TRUE(points.is_of_points());
  EXPECT_EQ(points.dimension(), 3u);
  EXPECT_EQ(points.row(1)[0], 4);
  EXPECT_EQ(points.row(1)[2], -1);
  const auto turned = parse_polytope(npy("|u1", "True", "(2, 3)", rows), "");  // column by column
  EXPECT_EQ(turned.row(1)[0], 2);
  EXPECT_EQ(turned.row(0)[2], 5);
  EXPECT_EQ(turned.row(1)[2], 255);
  const auto half_spaces = parse_polytope(npy("|i1", "False", "(2, 3)", rows), "", polytope::Form::half_spaces);
  EXPECT_FALSE(half_spaces.is_of_points());
  EXPECT_EQ(half_spaces.dimension(), 2u);
  EXPECT_EQ(half_spaces.size(), 2u);
  EXPECT_EQ(half_spaces.row(1)[2], -1);
  EXPECT_EQ(parse_polytope(npy(">i2", "False", "(1, 3)", rows), "").row(0)[1], 0x304);
  EXPECT_EQ(parse_polytope(npy("<u2", "False", "(1, 3)", rows), "").row(0)[1], 0x403);
}

TEST(Polytopes, RefusesOtherNpy) {
  EXPECT_EQ(polytope_error(npy("|i1", "False", "(1, 7)", "1234567")),
            "f.csv: a row is a point of dimension 7; give points of dimension 2 to 6");
  EXPECT_EQ(polytope_error(npy("|i1", "False", "(2, 1)", "12")),
            "f.csv: a row is a point of dimension 1; give points of dimension 2 to 6");
  EXPECT_NE(polytope_error(npy("|b1", "False", "(1, 2)", "12")).find("its numbers are of kind"), std::string::npos);
  EXPECT_EQ(polytope_error(npy("<f4", "False", "(1, 2)", {"\0\0\0\0\0\0\xc0\x7f", 8})),
            "f.csv: row 0: column 1 is not finite; give a finite number");
  EXPECT_EQ(polytope_error(npy("<i8", "False", "(1, 2)", {"\1\0\0\0\0\0\x20\0\0\0\0\0\0\0\x20\0", 16})),
            "f.csv: row 0: column 0 is no double; give float64");
}

TEST(Polytopes, UnnamedHalfSpaces) {
  EXPECT_EQ(parse_polytope("1,0,1\n", "", polytope::Form::half_spaces).dimension(), 2u);
  EXPECT_EQ(parse_polytope("a1,a2,b\n1,0,1\n", "", polytope::Form::half_spaces).size(), 1u);
  EXPECT_THROW(parse_polytope("1,0\n", "", polytope::Form::half_spaces), Error);
  EXPECT_THROW(parse_polytope("x1,x2\n1,0\n", "", polytope::Form::half_spaces), Error);
}

TEST(Polytopes, RefusesWhatIsNone) {
  EXPECT_EQ(polytope_error("1,2,3,4\n1,2,3\n"), "f.csv:2: has 3 numbers, others have 4; give rows of one dimension");
  EXPECT_EQ(polytope_error("1\n"), "f.csv:1: is a point of dimension 1; give points of dimension 2 to 6");
  EXPECT_EQ(polytope_error("1,2,3,4,5,6,7\n"), "f.csv:1: is a point of dimension 7; give points of dimension 2 to 6");
  EXPECT_EQ(polytope_error("x1,x3\n1,2\n"),
            "f.csv:1: has names that are neither x1,..,xd nor a1,..,ad,b; name the columns so, for a d from 2 to 6");
  EXPECT_EQ(polytope_error("x1,x2\n"),
            "f.csv: has no points; give lines x1,..,xd, or name the columns of half-spaces a1,..,ad,b");
  EXPECT_NE(polytope_error("1,2\n1,nan\n").find("f.csv:2: 'nan' is NaN"), std::string::npos);
  EXPECT_NE(polytope_error("1,2\n1,\n").find("f.csv:2: "), std::string::npos);
}

}  // namespace
}  // namespace sunder::io
