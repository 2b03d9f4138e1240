// Which coordinate systems files declare, which of them are one, and what is said where they differ.
#include <sunder/base/error.h>
#include <sunder/io/plane/coordinate_system.h>
#include <sunder/io/plane/lines.h>
#include <sunder/io/plane/planar_objects.h>
#include <sunder/io/plane/polygons.h>
#include <sunder/io/text/file.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {
namespace {

using Texts = std::vector<std::string>;

const std::filesystem::path system_cases = tests::cases_folder() / std::filesystem::path("coordinate-systems");

Texts ids(const LineFile& file) {
  Texts ids;
  for (const SystemOfFile& s : file.systems) ids.push_back(s.system.id);
  return ids;
}

Texts ids_of(const std::string& text, const std::string& place) { return ids(parse_lines(text, place)); }

std::string collection(const std::string& members, const std::string& features) {
  return R"({"type": "FeatureCollection", )" + members + R"("features": [)" + features + "]}";
}

std::string line(const std::string& members, const std::string& end = "[1, 1]") {
  return R"({"type": "Feature", )" + members + R"("geometry": {"type": "LineString", "coordinates": [[0, 0], )" + end +
         "]}}";
}

std::string crs(const std::string& name) {
  return R"("crs": {"type": "name", "properties": {"name": ")" + name + R"("}}, )";
}

TEST(CoordinateSystemTest, OneSystemHasManyNames) {
  for (const char* name :
       {"EPSG:4326", "epsg:4326", "urn:ogc:def:crs:EPSG::4326", "urn:ogc:def:crs:EPSG:9.2:4326", "CRS84", "OGC:CRS84",
        "urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84", "CRS:84", "[EPSG:4326]",
        "http://www.opengis.net/def/crs/EPSG/0/4326", "https://www.opengis.net/def/crs/OGC/1.3/CRS84",
        "http://www.opengis.net/gml/srs/epsg.xml#4326", "urn:x-ogc:def:crs:EPSG:4326"}) {
    EXPECT_EQ(system_by_name(name).id, "EPSG:4326") << name;
    EXPECT_EQ(system_by_name(name).urn, "urn:ogc:def:crs:OGC:1.3:CRS84") << name;
  }
  EXPECT_EQ(system_by_srid(4326).id, "EPSG:4326");
  EXPECT_EQ(system_by_srid(28992).urn, "urn:ogc:def:crs:EPSG::28992");
  EXPECT_FALSE(system_by_srid(0).declared());
  EXPECT_FALSE(system_by_srid(-1).declared());
  EXPECT_EQ(system_by_name("urn:ogc:def:crs:EPSG::28992").id, "EPSG:28992");
  EXPECT_EQ(system_by_name("ESRI:102100").id, "ESRI:102100");
  EXPECT_NE(system_by_name("ESRI:4326").id, "EPSG:4326");
  EXPECT_EQ(system_by_name("my site").id, "my site");
  EXPECT_EQ(system_by_name("a:b:c").id, "a:b:c");
  EXPECT_EQ(system_by_name("urn:ogc:def:crs:").id, "urn:ogc:def:crs:");
  EXPECT_FALSE(system_by_name("  ").declared());
}

TEST(CoordinateSystemTest, Prj) {
  const std::string inner = R"(GEOGCS["Amersfoort",DATUM["A",AUTHORITY["EPSG","6289"]],AUTHORITY["EPSG","4289"]])";
  const std::string esri = R"(PROJCS["RD_New",)" + inner + R"(,UNIT["Meter",1.0]])";
  EXPECT_EQ(system_by_prj(R"(PROJCS["RD",)" + inner + R"(,AUTHORITY["EPSG","28992"]])" + "\n").id, "EPSG:28992");
  EXPECT_EQ(system_by_prj(R"(PROJCRS["RD",BASEGEOGCRS["x",ID["EPSG",4289]], ID["EPSG", 28992]])").id, "EPSG:28992");
  EXPECT_EQ(system_by_prj("EPSG:28992\r\n").id, "EPSG:28992");
  EXPECT_EQ(system_by_prj(esri + "\r\n").id, esri);  // the codes inside are those of others
  EXPECT_EQ(system_by_prj(esri).id, system_by_prj("\n" + esri).id);
  EXPECT_EQ(system_by_prj(esri).name, "'RD_New', a .prj without a code");
  EXPECT_TRUE(system_by_prj(esri).urn.empty());
  EXPECT_FALSE(system_by_prj(" \n").declared());
  EXPECT_EQ(system_by_prj("[[[]]]]\"(").id, "[[[]]]]\"(");
}

TEST(CoordinateSystemTest, Wkt) {
  EXPECT_EQ(ids_of("SRID=28992;LINESTRING (0 0, 1 1)\nSRID=4326;LINESTRING (0 0, 1 1)\nLINESTRING (0 0, 1 1)", "a.wkt"),
            (Texts{"EPSG:28992", "EPSG:4326", ""}));
  EXPECT_EQ(ids_of("SRID=0;LINESTRING (0 0, 1 1)", "a.wkt"), Texts{""});
  const LineFile file = parse_lines("LINESTRING (0 0, 1 1)\nSRID=7;LINESTRING (0 0, 1 1)", "a.wkt");
  EXPECT_EQ(file.system, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(file.systems[0].first, "line 2");
  EXPECT_EQ(file.systems[1].first, "feature '1'");
}

TEST(CoordinateSystemTest, GeoJson) {
  EXPECT_EQ(ids_of(collection(crs("EPSG:28992"), line("") + "," + line("")), "a.json"), Texts{"EPSG:28992"});
  EXPECT_EQ(ids_of(collection(R"("crs": {"type": "EPSG", "properties": {"code": 28992}}, )", line("")), "a.json"),
            Texts{"EPSG:28992"});
  EXPECT_EQ(ids_of(collection("", line(crs("EPSG:28992")) + "," + line("")), "a.json"),
            (Texts{"EPSG:28992", "EPSG:4326"}));
  EXPECT_EQ(ids_of(collection(R"("coordRefSys": "http://www.opengis.net/def/crs/EPSG/0/28992", )", line("")), "a.json"),
            Texts{"EPSG:28992"});
  EXPECT_EQ(ids_of(collection(R"("coordRefSys": {"type": "Reference", "href": "EPSG:28992"}, )", line("")), "a.json"),
            Texts{"EPSG:28992"});
  // Without any it is CRS84, where it can be.
  const LineFile assumed = parse_lines(line("", "[180, -90]"), "a.json");
  EXPECT_EQ(ids(assumed), Texts{"EPSG:4326"});
  EXPECT_TRUE(assumed.systems[0].system.is_assumed);
  EXPECT_EQ(ids_of(line("", "[180.5, 1]"), "a.json"), Texts{""});
  EXPECT_EQ(ids_of(line("", "[1, -90.5]"), "a.json"), Texts{""});
  EXPECT_EQ(ids_of(collection(R"("crs": null, )", line("", "[1, 91]")), "a.json"), Texts{""});
  EXPECT_EQ(ids_of("[[[0, 0], [1, 0], [0, 1]]]", "a.json"), Texts{""});  // no GeoJSON
  EXPECT_THROW(parse_lines(collection(R"("crs": {"type": "name"}, )", line("")), "a.json"), Error);
  EXPECT_THROW(parse_lines(collection(R"("coordRefSys": 7, )", line("")), "a.json"), Error);
}

// What JSON-FG has as "place" is the geometry; "geometry" beside it is a copy for others, in CRS84.
TEST(CoordinateSystemTest, JsonFg) {
  const std::string place = R"("place": {"type": "LineString", "coordinates": [[500, 500], [600, 600]]}, )";
  const std::string reference = R"("coordRefSys": "EPSG:28992", )";
  const LineFile file = parse_lines(collection(reference, line(place)), "a.json");
  ASSERT_EQ(file.segments.size(), 1u);
  EXPECT_EQ(file.segments[0].a.x, 500);
  EXPECT_EQ(ids(file), Texts{"EPSG:28992"});
  EXPECT_EQ(file.remarks.size(), 1u);
  EXPECT_EQ(ids_of(collection(reference, line(place) + "," + line("")), "a.json"), (Texts{"EPSG:28992", ""}));
  const std::string null =
      R"({"type": "Feature", "geometry": null, "place": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}})";
  const LineFile mixed = parse_lines(collection("", line("") + "," + null), "a.json");
  EXPECT_EQ(mixed.segments.size(), 2u);
  EXPECT_EQ(ids(mixed), Texts{"EPSG:4326"});
  const std::string prism = R"({"type": "Feature", "geometry": null, "place": {"type": "Prism", "base": {}}})";
  EXPECT_THROW(parse_lines(collection("", line("") + "," + prism), "a.json"), Error);
  EXPECT_EQ(parse_lines(collection("", line("") + "," + prism), "a.json", {.leave_out = true}).left_out.size(), 1u);
  EXPECT_EQ(parse_lines(line(R"("place": "Utrecht", )"), "a.json").segments.size(), 1u);  // a word of its own
}

TEST(CoordinateSystemTest, BesideFiles) {
  EXPECT_EQ(ids(read_lines(system_cases / "canal.wkt")), Texts{"EPSG:28992"});
  EXPECT_EQ(ids(read_lines(system_cases / "fence.csv")).size(), 1u);
  EXPECT_TRUE(read_lines(system_cases / "fence.csv").systems[0].system.name.starts_with("'RD_New'"));
  EXPECT_EQ(read_planar_objects(system_cases / "canal.wkt").objects[0].system.id, "EPSG:28992");
  EXPECT_FALSE(system_beside("-").declared());
  EXPECT_FALSE(system_beside(system_cases / "nothing.wkt").declared());
  EXPECT_FALSE(system_beside(system_cases / "canal.prj").declared());
}

// What is read is told, once; what is not needed is not read; and files that are given are those that are there.
TEST(CoordinateSystemTest, BesideFilesAreInputs) {
  InputFiles inputs;
  const LineFile canal = read_lines(system_cases / "canal.wkt", {.inputs = &inputs});
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_EQ(inputs[1].name, (system_cases / "canal.prj").string());
  static_cast<void>(system_beside(system_cases / "canal.wkt", &inputs));
  static_cast<void>(read_planar_objects(system_cases / "canal.wkt", false, &inputs));
  EXPECT_EQ(inputs.size(), 2u);

  const std::string line = "LINESTRING (0 0, 1 1)", declared = "SRID=4326;" + line, prj = "EPSG:7";
  const GivenFiles given({{"a.wkt", &line}, {"a.prj", &prj}, {"b.wkt", &declared}, {"b.prj", &prj}, {"c.wkt", &line}});
  const auto read = [](const char* name, std::size_t files) {
    InputFiles of_lines, of_objects;
    const Texts systems = ids(read_lines(name, {.inputs = &of_lines}));
    EXPECT_EQ(systems.at(0), read_planar_objects(name, false, &of_objects).objects.at(0).system.id);
    EXPECT_EQ(of_lines.size(), files);
    EXPECT_EQ(of_objects, of_lines);
    return systems;
  };
  EXPECT_EQ(read("a.wkt", 2), Texts{"EPSG:7"});
  EXPECT_EQ(read("b.wkt", 1), Texts{"EPSG:4326"});
  EXPECT_EQ(read("c.wkt", 1), Texts{""});
  EXPECT_FALSE(system_beside(system_cases / "canal.wkt").declared());
}

TEST(CoordinateSystemTest, InWords) {
  const SystemOfFile one{system_by_srid(7), "line 1"}, none{{}, "feature '2'"}, other{system_by_srid(8), "line 3"};
  EXPECT_EQ(text_of(std::vector<SystemOfFile>{}), "");
  EXPECT_EQ(text_of(std::array{none}), "");
  EXPECT_EQ(text_of(std::array{one}), "EPSG:7");
  EXPECT_EQ(text_of(std::array{one, none, other}), "EPSG:7 from line 1, none from feature '2', EPSG:8 from line 3");
}

TEST(CoordinateSystemTest, Compared) {
  const auto of = [](const char* name) { return std::vector<SystemOfFile>{{system_by_name(name), "line 1"}}; };
  CoordinateSystems systems;
  systems.add("a.wkt", of("EPSG:4326"));
  systems.add("b.wkt", of("CRS84"));
  ASSERT_EQ(systems.declared().size(), 1u);
  EXPECT_EQ(systems.declared()[0].files, (Texts{"a.wkt", "b.wkt"}));
  EXPECT_TRUE(systems.remarks().empty());
  systems.add("c.wkt", of(""));
  EXPECT_EQ(systems.remarks(), Texts{"c.wkt declares no coordinate system: the numbers count as in EPSG:4326"});
  try {
    systems.add("d.wkt", of("EPSG:28992"));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_STREQ(error.what(),
                 "d.wkt: the coordinate system is EPSG:28992, and that of a.wkt is EPSG:4326; transform one (ogr2ogr "
                 "-t_srs), or compare the numbers as they are: --mixed-crs");
  }
  CoordinateSystems mixed(true);
  mixed.add("a.wkt", std::vector<SystemOfFile>{{system_by_srid(1), "line 1"}, {system_by_srid(2), "line 2"}});
  EXPECT_EQ(mixed.only(), nullptr);
  EXPECT_EQ(mixed.remarks(), Texts{"coordinate systems differ, and the numbers are compared as they are: EPSG:1 of "
                                   "a.wkt, EPSG:2 of a.wkt"});
}

}  // namespace
}  // namespace sunder::io
