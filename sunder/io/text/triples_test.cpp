#include <sunder/base/error.h>
#include <sunder/io/text/triples.h>

#include <gtest/gtest.h>

#include <string>

namespace sunder::io {
namespace {

std::string triples_refusal(std::string_view text, const TripleKind& kind = circle_rows) {
  try {
    parse_triples(text, "f.csv", kind);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.what();
  }
  return "accepted";
}

TEST(TriplesTest, RowsNamesAndLines) {
  const TripleFile file = parse_triples("x,y,r,name\n1,2,3,Copernicus\n\n-1e-3, +2 ,0\r\n", "f.csv", circle_rows);
  ASSERT_EQ(file.rows.size(), 2u);
  EXPECT_EQ(file.rows[0], (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ(file.rows[1], (std::array{-1e-3, 2.0, 0.0}));
  EXPECT_EQ(file.name, (std::vector<std::string>{"Copernicus", "2"}));
  EXPECT_EQ(file.line, (std::vector<std::uint32_t>{2, 4}));
}

TEST(TriplesTest, Semicolons) {
  const TripleFile file = parse_triples("1;2;3;\"a, b\"\n", "f.csv", half_plane_rows);
  EXPECT_EQ(file.name[0], "a, b");
  EXPECT_EQ(file.rows[0], (std::array{1.0, 2.0, 3.0}));
}

TEST(TriplesTest, NumbersAreRoundedOnce) {
  const TripleFile file = parse_triples("0.1,1e-400,1.7976931348623157e308", "f.csv", half_plane_rows);
  EXPECT_EQ(file.rows[0], (std::array{0.1, 0.0, 1.7976931348623157e308}));
}

TEST(TriplesTest, Groups) {
  const TripleFile file = parse_triples("x,y,r,net,layer,name\n1,2,3,GND,top,a\n4,5,6,VCC,top,\n7,8,9,GND,bottom,c\n",
                                        "f.csv", circle_rows, {.group = "net"});
  EXPECT_EQ(file.groups, (std::vector<std::string>{"GND", "VCC"}));
  EXPECT_EQ(file.group, (std::vector<std::uint32_t>{0, 1, 0}));
  EXPECT_EQ(file.name, (std::vector<std::string>{"a", "2", "c"}));
  EXPECT_EQ(parse_triples("x,y,r,net\n1,2,3,GND\n", "f.csv", circle_rows, {.group = "net"}).name[0], "GND");
  EXPECT_TRUE(parse_triples("1,2,3,a\n", "f.csv", circle_rows).group.empty());
}

TEST(TriplesTest, Properties) {
  const std::string text = "name,x,y,r,owner,power\na,1,2,3,city,12\nb,1,2,3,,\n";
  const TripleFile file = parse_triples(text, "f.csv", circle_rows, {.properties = {"power", "name", "owner"}});
  ASSERT_EQ(file.properties.size(), 2u);
  EXPECT_EQ(file.properties[0], (PropertyValues{{"12", true}, {"a", true}, {"city", true}}));
  EXPECT_EQ(file.properties[1], (PropertyValues{{}, {"b", true}, {}}));
  EXPECT_EQ(file.name, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(parse_triples(text, "f.csv", circle_rows).properties.empty());
  try {
    parse_triples(text, "f.csv", circle_rows, {.properties = {"owner", "colour"}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), std::string("f.csv: there is no column 'colour' to tell of; there are name, owner, power"));
  }
}

TEST(TriplesTest, RefusalsOfGroups) {
  const auto refused = [](const std::string& text) {
    try {
      parse_triples(text, "f.csv", circle_rows, {.group = "net"});
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refused("x,y,r,layer,name\n1,2,3,4,5\n"),
            "f.csv: there is no column 'net' to group by; there are layer, name");
  EXPECT_EQ(refused("1,2,3,GND\n"),
            "f.csv: there is no column 'net' to group by; a first line has to name the columns after x,y,r");
  EXPECT_EQ(refused("x,y,r,net,net\n1,2,3,4,5\n"), "f.csv:1: two columns are named 'net'; rename one");
  EXPECT_EQ(refused("x,y,r,net\n1,2,3\n"), "f.csv:2: has 3 fields, but the line of names has 4; give the same number");
  EXPECT_EQ(refused("x,y,r,net\n1,2,3,\n"), "f.csv:2: has no value in the column 'net'; give one");
}

// Discs are not half-planes, and spheres are not circles.
TEST(TriplesTest, ColumnsByName) {
  const TripleFile file = parse_triples("name,R,y,x\n\"a, b\",3,2,1\n", "f.csv", circle_rows);
  EXPECT_EQ(file.rows[0], (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ(file.name[0], "a, b");
  EXPECT_EQ(parse_triples("x,y,r,net,of\n1,2,3,GND,b\n", "f.csv", circle_rows, {.name = "of"}).name[0], "b");
  EXPECT_EQ(
      triples_refusal("x,y,r,name\n1,2,3,a\n", half_plane_rows),
      "f.csv:1: the columns are named x,y,r,name, but half-planes have a,b,c; name them so, or give the file to the "
      "verb for what it holds");
  EXPECT_NE(triples_refusal("a,b,c\n1,2,3\n").find("but circles have x,y,r"), std::string::npos);
  EXPECT_NE(triples_refusal("x,y,z,r\n1,2,3,4\n").find("but circles have x,y,r"), std::string::npos);
  EXPECT_NE(triples_refusal("a,b,c,d\n1,2,3,4\n", half_plane_rows).find("but half-planes have a,b,c"),
            std::string::npos);
}

TEST(TriplesTest, Refusals) {
  EXPECT_EQ(triples_refusal(""), "f.csv: has no circles; give lines x,y,r");
  EXPECT_EQ(triples_refusal("a,b,c\n", half_plane_rows), "f.csv: has no half-planes; give lines a,b,c");
  EXPECT_NE(triples_refusal("1,2\n").find("f.csv:1: has 2 fields; give x,y,r and, if you like, a name"),
            std::string::npos);
  EXPECT_NE(triples_refusal("1,2,3\n1,2,3,4,5\n").find("f.csv:2: has 5 fields; give x,y,r and, if you like, a name"),
            std::string::npos);
  EXPECT_NE(triples_refusal("1,2,nan\n").find("f.csv:1: 'nan' is NaN"), std::string::npos);
  EXPECT_NE(triples_refusal("1,2,1e999\n").find("f.csv:1: '1e999' is too large"), std::string::npos);
  EXPECT_NE(triples_refusal("1,2,3\nx,y,r\n").find("f.csv:2: 'x' is not a number"), std::string::npos);
  EXPECT_NE(triples_refusal("1,2,3,a\"b\n").find("has a quote within"), std::string::npos);
}

}  // namespace
}  // namespace sunder::io
