// 3MF: what is read and refused of models and of packages. See zip_test.cpp for archives, mesh_files_test.cpp for files.
#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh_formats.h>
#include <sunder/io/mesh/mesh_parse_test.h>
#include <sunder/io/text/zip_make_test.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {
namespace {

constexpr std::string_view core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view production = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

// <vertices> and <triangles> of the tetrahedron of the origin and the unit vectors, times a number.
std::string tetrahedron_times(const std::string& n) {
  return "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"" + n +
         "\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"" + n + "\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"" + n +
         "\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
         "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh>";
}

std::string object_made(int id, const std::string& content, const std::string& more = "") {
  return "<object id=\"" + std::to_string(id) + "\" " + more + ">" + content + "</object>\n";
}

std::string item_made(int id, const std::string& transform = "") {
  return "<item objectid=\"" + std::to_string(id) + "\"" +
         (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
}

std::string model_made(const std::string& resources, const std::string& items, const std::string& attributes = "") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model xmlns=\"" + std::string(core) + "\" " + attributes +
         ">\n<resources>" + resources + "</resources>\n<build>" + items + "</build></model>";
}

Mesh mesh_of_model(const std::string& model) { return checked_mesh(package_made(model), MeshFormat::three_mf); }
std::string error_of_model(const std::string& model) { return mesh_error(package_made(model), MeshFormat::three_mf); }

bool says(const std::string& text, std::string_view part) {
  if (text.find(part) != std::string::npos) return true;
  ADD_FAILURE() << "expected: " << part << "\nmessage: " << text;
  return false;
}

const std::string unit_object = object_made(1, tetrahedron_times("1"), "name=\"unit\"");

using CornersOf3mf = std::vector<std::uint32_t>;

TEST(Mesh3mf, ReadsNumbersAsTheyStand) {
  const Mesh mesh =
      mesh_of_model(model_made(object_made(7, tetrahedron_times(" +0.1 "), "type=\"surface\""), item_made(7)));
  EXPECT_EQ(mesh.vertices, (std::vector<Point3>{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}}));
  EXPECT_EQ(mesh.polygon_vertices, (CornersOf3mf{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
  EXPECT_EQ(mesh.format, "3MF (millimetres)");
  EXPECT_TRUE(mesh.remarks.empty());
  EXPECT_TRUE(mesh.left_out.empty());
  // By a few last bits: 4.2e-18, and -2.5e-18.
  const Mesh least = mesh_of_model(model_made(object_made(7, tetrahedron_times("4.9e-324")), item_made(7)));
  EXPECT_EQ(least.vertices[1].x, 4.9406564584124654e-324);
}

// Rows times matrices: x y z 1 times the four rows of three.
TEST(Mesh3mf, MovesRows) {
  const Mesh mesh = mesh_of_model(model_made(unit_object, item_made(1, "0 1 0  -1 0 0  0 0 2  10 20 30")));
  EXPECT_EQ(mesh.vertices, (std::vector<Point3>{{10, 20, 30}, {10, 21, 30}, {9, 20, 30}, {10, 20, 32}}));
  EXPECT_EQ(mesh.polygon_vertices, (CornersOf3mf{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
  EXPECT_TRUE(mesh.remarks.empty());
}

TEST(Mesh3mf, AFileIsAllOfItsItemsWithTheirComponents) {
  const std::string pair = object_made(5,
                                       "<components><component objectid=\"1\"/><component objectid=\"2\" transform=\"1 "
                                       "0 0 0 1 0 0 0 1 5 0 0\"/></components>",
                                       "name=\"pair\"");
  const Mesh mesh = mesh_of_model(
      model_made(unit_object + object_made(2, tetrahedron_times("2")) + pair + object_made(9, tetrahedron_times("3")),
                 item_made(5, "2 0 0 0 2 0 0 0 2 100 0 0") + item_made(1)));
  ASSERT_EQ(mesh.parts.size(), 3u);
  EXPECT_EQ(mesh.parts[0].name, "unit");
  EXPECT_EQ(mesh.parts[1].name, "pair") << "where a mesh has no name, that of the object above it";
  EXPECT_EQ(mesh.parts[2].name, "unit");
  EXPECT_EQ(mesh.vertices[1], (Point3{102, 0, 0}));
  EXPECT_EQ(mesh.vertices[4], (Point3{110, 0, 0})) << "the component's transform first, then the item's";
  EXPECT_EQ(mesh.vertices[5], (Point3{114, 0, 0}));
  EXPECT_EQ(mesh.vertices[9], (Point3{1, 0, 0}));
  EXPECT_EQ(mesh.vertices.size(), 12u) << "the object that no item names is not read";
}

TEST(Mesh3mf, WhatMirrorsIsTurnedBack) {
  const std::string mirror = "-1 0 0 0 1 0 0 0 1 0 0 0";
  const CornersOf3mf as_given{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, turned{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
  EXPECT_EQ(mesh_of_model(model_made(unit_object, item_made(1, mirror))).polygon_vertices, turned);
  const std::string twice =
      object_made(2, "<components><component objectid=\"1\" transform=\"" + mirror + "\"/></components>");
  EXPECT_EQ(mesh_of_model(model_made(unit_object + twice, item_made(2, mirror))).polygon_vertices, as_given);
  // By a few last bits: 4.2e-18, and -2.5e-18.
  const Mesh least = mesh_of_model(
      model_made(unit_object, item_made(1, "0.1 0.2 0.3  0.4 0.5 0.6  0.7 0.8 0.9000000000000002  0 0 0")));
  EXPECT_EQ(least.polygon_vertices, turned);
  const Mesh more =
      mesh_of_model(model_made(unit_object, item_made(1, "0.1 0.2 0.3  0.4 0.5 0.6  0.7 0.8 0.9  0 0 0")));
  EXPECT_EQ(more.polygon_vertices, as_given);
}

// Doubles would round at each step.
TEST(Mesh3mf, TransformsRoundOnce) {
  const Mesh mesh = mesh_of_model(model_made(unit_object, item_made(1, "1e16 0 0 0 1 0 0 0 1 -1e16 0 0.1")));
  EXPECT_EQ(mesh.vertices[1], (Point3{0, 0, 0.1}));
  EXPECT_EQ(mesh.vertices[3], (Point3{-1e16, 0, 1.1}));
  ASSERT_EQ(mesh.remarks.size(), 1u) << "1 and the double 0.1 are 1.1 but for what is rounded";
  EXPECT_EQ(mesh.remarks[0], "1 of 12 coordinates is rounded, to the nearest double, by its transforms or its unit");
  const std::string chain =
      object_made(2, "<components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 1e-20 0 0\"/></components>");
  const Mesh back = mesh_of_model(model_made(unit_object + chain, item_made(2, "1e20 0 0 0 1 0 0 0 1 -1e20 0 0")));
  EXPECT_EQ(back.vertices[1].x, 1e20 * 1e-20) << "1 + 1e-20 is rounded nowhere between";
  const Mesh many = mesh_of_model(model_made(unit_object, item_made(1, "1 0 0 0 1 0 0 0 1 0.1 0.1 0.1")));
  EXPECT_EQ(many.remarks[0], "3 of 12 coordinates are rounded, to the nearest doubles, by its transforms or its unit");
}

TEST(Mesh3mf, UnitsAreMillimetres) {
  struct Case {
    const char *unit, *told;
    double of_tenth;
  };
  // 0.1 is a little more than a tenth; the values are the doubles nearest to that, times the fraction.
  for (const auto& [unit, told, of_tenth] :
       {Case{"micron", "1 unit is 0.001 mm", 1e-4}, Case{"millimeter", "millimetres", 0.1},
        Case{"centimeter", "1 unit is 10 mm", 1}, Case{"inch", "1 unit is 25.4 mm", 2.54},
        Case{"foot", "1 unit is 304.8 mm", 30.48}, Case{"meter", "1 unit is 1000 mm", 100}}) {
    const Mesh mesh = mesh_of_model(
        model_made(object_made(1, tetrahedron_times("0.1")), item_made(1), "unit=\"" + std::string(unit) + "\""));
    EXPECT_EQ(mesh.vertices[1].x, of_tenth) << unit;
    EXPECT_EQ(mesh.format, "3MF (" + std::string(told) + ")");
  }
  EXPECT_TRUE(
      says(error_of_model(model_made(unit_object, item_made(1), "unit=\"mile\"")), "the unit is 'mile'; known are"));
}

TEST(Mesh3mf, FollowsModelsOfTheProductionExtension) {
  const std::string names = "xmlns:p=\"" + std::string(production) + "\" requiredextensions=\"p\"";
  const std::string root =
      model_made(object_made(1,
                             "<components><component p:path=\"/3D/Other.model\" objectid=\"1\" transform=\"1 0 0 0 1 0 "
                             "0 0 1 5 0 0\"/></components>"),
                 item_made(1) + "<item objectid=\"2\" p:path=\"/3D/other.model\" p:UUID=\"x\"/>", names);
  const auto package = [&](const std::string& other) { return package_made(root, {{"3D/other.model", other, true}}); };
  const std::string other = model_made(unit_object + object_made(2, tetrahedron_times("2")), "");
  const Mesh mesh = checked_mesh(package(other), MeshFormat::three_mf);
  ASSERT_EQ(mesh.parts.size(), 2u);
  EXPECT_EQ(mesh.vertices[1], (Point3{6, 0, 0}));
  EXPECT_EQ(mesh.vertices[5], (Point3{2, 0, 0}));

  const auto error = [&](const std::string& bytes) { return mesh_error(bytes, MeshFormat::three_mf); };
  EXPECT_TRUE(says(error(package_made(root)), "names the model '3D/Other.model', which is not in it"));
  EXPECT_TRUE(
      says(error(package(model_made(unit_object, "", "unit=\"inch\""))), "its unit is not that of the root model"));
  EXPECT_TRUE(says(error(package(model_made(unit_object, ""))), "test: 3D/3dmodel.model:5: <item> names the object 2"));
  EXPECT_TRUE(says(error(package(model_made("<object id=\"1\"><mesh/></object>", ""))),
                   "test: 3D/Other.model:3: <mesh> has no"));
  const std::string deeper =
      model_made(object_made(1, "<components><component p:path=\"/3D/a\" objectid=\"1\"/></components>"), "", names);
  EXPECT_TRUE(says(error(package(deeper)), "names another model, which only the root may"));
  const std::string unknown = model_made(unit_object, "<item objectid=\"1\" q:path=\"/3D/a\"/>");
  EXPECT_TRUE(says(error(package_made(unknown)), "<item> has 'q:path', which is of no extension that is read"));
}

TEST(Mesh3mf, TellsWhatItDoesNotRead) {
  const std::string names =
      "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" "
      "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
      "xmlns:t=\"http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07\" xmlns:v=\"http://vendor\"";
  std::string latticed = tetrahedron_times("1");
  latticed.insert(latticed.find("</mesh>"), "<b:beamlattice/><t:trianglesets/>");
  const Mesh mesh = mesh_of_model(
      model_made("<basematerials id=\"8\"/><m:colorgroup id=\"9\"/><v:thing/>" + object_made(1, latticed) +
                     object_made(2, tetrahedron_times("2"), "type=\"support\"") +
                     object_made(3, tetrahedron_times("2"), "type=\"solidsupport\""),
                 item_made(1) + item_made(2) + item_made(3), names + " requiredextensions=\"m t\""));
  EXPECT_EQ(mesh.polygon_count(), 4u);
  EXPECT_EQ(mesh.remarks,
            (std::vector<std::string>{"materials, colours and textures are not read; no shape depends on them"}));
  std::vector<std::string> kinds;
  for (const LeftOut& item : mesh.left_out) kinds.push_back(std::to_string(item.count) + " " + item.kind);
  EXPECT_EQ(kinds, (std::vector<std::string>{"1 v:thing", "1 beam lattice", "2 support"}));

  EXPECT_TRUE(says(error_of_model(model_made(unit_object, item_made(1), names + " requiredextensions=\"m b\"")),
                   "needs the extension 'b' (beamlattice/2017/02), which is not read"));
  const Mesh other =
      mesh_of_model(model_made(object_made(1, tetrahedron_times("1")), item_made(1) + "<other xmlns=\"http://x\"/>"));
  ASSERT_EQ(other.left_out.size(), 1u);
  EXPECT_EQ(other.left_out[0].kind, "other");
}

TEST(Mesh3mf, VerticesThatNoTriangleNamesAreAStore) {
  std::string more = tetrahedron_times("1");
  more.insert(more.find("<vertex "), "<vertex x=\"9\" y=\"9\" z=\"9\"/>");
  for (const char* corner : {"3", "2", "1", "0"}) {
    const std::string old = "\"" + std::string(corner) + "\"",
                      next = "\"" + std::to_string(std::stoi(corner) + 1) + "\"";
    for (std::size_t at = more.find("<triangles>"); (at = more.find(old, at)) != std::string::npos;)
      more.replace(at, 3, next);
  }
  const Mesh mesh = mesh_of_model(model_made(object_made(1, more), item_made(1)));
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.polygon_vertices, (CornersOf3mf{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
  EXPECT_TRUE(mesh.left_out.empty());
}

TEST(Mesh3mf, RefusesWhatIsWrong) {
  const auto with = [&](std::string_view from, const std::string& to) {
    std::string text = model_made(unit_object, item_made(1));
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("no " + std::string(from));
    return error_of_model(text.replace(at, from.size(), to));
  };
  EXPECT_TRUE(
      says(with("v3=\"1\"", "v3=\"4\""), "test: 3D/3dmodel.model:3: this triangle names vertex 4, but there are 4"));
  EXPECT_TRUE(says(with("v3=\"1\"", "v3=\"-1\""), "v3 of <triangle>: '-1' is no number from 0 to 2^31"));
  EXPECT_TRUE(says(with("v3=\"1\"", ""), "<triangle> has no v3"));
  EXPECT_TRUE(says(with("y=\"0\"", "y=\"nan\""), "y of <vertex>: 'nan' is NaN"));
  EXPECT_TRUE(says(with("y=\"0\"", "y=\"1e999\""), "y of <vertex>: '1e999' is too large"));
  EXPECT_TRUE(says(with("y=\"0\"", "y=\"0,5\""), "y of <vertex>: '0,5' is not a number"));
  EXPECT_TRUE(says(with("y=\"0\"", ""), "<vertex> has no y"));
  EXPECT_TRUE(says(with("<item objectid=\"1\"/>", item_made(2)), "<item> names the object 2, which is not there"));
  EXPECT_TRUE(says(with("<item objectid=\"1\"/>", ""), "<build> has no <item>"));
  EXPECT_TRUE(
      says(with("<item objectid=\"1\"/>", item_made(1, "1 0 0 0 1 0 0 0 1 0 0")), "the transform has 11 numbers"));
  EXPECT_TRUE(says(with("<item objectid=\"1\"/>", item_made(1, "1 0 0 0 1 0 1 1 0 0 0 0")), "makes the object flat"));
  EXPECT_TRUE(
      says(with("<item objectid=\"1\"/>", item_made(1, "1e308 0 0 0 1 0 0 0 1 1e308 0 0")), "beyond the doubles"));
  EXPECT_TRUE(says(with("<item objectid=\"1\"/>", item_made(1, "1 0 0 0 1 0 0 0 inf 0 0 0")), "'inf' is infinite"));
  EXPECT_TRUE(says(with("<object id=\"1\" name=\"unit\"", "<object id=\"1\" type=\"other\""),
                   "of type 'other' is to be built"));
  EXPECT_TRUE(says(with("</resources>", unit_object + "</resources>"), "the id 1 stands twice"));
  EXPECT_TRUE(says(with("</resources>", ""), "is not well-formed XML"));
  EXPECT_TRUE(says(with("core/2015/02", "core/2030/01"), "is not of 3MF's core of 2015/02"));
  EXPECT_TRUE(
      says(error_of_model(model_made(object_made(1, ""), item_made(1))), "has neither <mesh> nor <components>"));
  EXPECT_TRUE(says(
      error_of_model(model_made(object_made(1, "<components><component objectid=\"1\"/></components>"), item_made(1))),
      "nested more than 64 deep, or in a circle"));
  std::string doubling = unit_object;
  for (int id = 2; id < 40; ++id) {
    const std::string half = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    doubling += object_made(id, "<components>" + half + half + "</components>");
  }
  EXPECT_TRUE(says(error_of_model(model_made(doubling, item_made(39))), "its instances make more than 32"));
}

TEST(Mesh3mf, RefusesPackagesWithoutAModel) {
  const auto error = [](const std::vector<ZipMade>& files) {
    return mesh_error(zip_made(files), MeshFormat::three_mf);
  };
  EXPECT_TRUE(says(error({{"3D/3dmodel.model", "x"}}), "without _rels/.rels, so it is no 3MF"));
  EXPECT_TRUE(says(error({{"_rels/.rels", "<Relationships/>"}}), "names no 3D model"));
  const std::string start =
      "<Relationship Target=\"/a.model\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>";
  EXPECT_TRUE(says(error({{"_rels/.rels", "<Relationships>" + start + "</Relationships>"}}),
                   "names the model 'a.model', which is not in it"));
  EXPECT_TRUE(says(error({{"_rels/.rels", "<Relationships>" + start + start + "</Relationships>"}}),
                   "_rels/.rels:1: names a second 3D model"));
  EXPECT_TRUE(says(mesh_error("no archive", MeshFormat::three_mf), "is no whole ZIP archive"));
}

TEST(Mesh3mf, IsToldByItsContent) {
  const std::string package = package_made(model_made(unit_object, item_made(1)));
  EXPECT_EQ(mesh_format(package, "x.stl"), MeshFormat::three_mf);
  EXPECT_EQ(mesh_format(zip_made({{"a.txt", "x"}}), "x.3MF"), MeshFormat::three_mf)
      << "its reader tells what is missing";
  EXPECT_THROW((void)mesh_format(zip_made({{"a.txt", "x"}}), "x.stl"), Error);
  EXPECT_THROW((void)mesh_format("\x89PNG\r\n", "x.3mf"), Error);
  EXPECT_THROW((void)mesh_format_of_name("hull.3mf"), Error) << "only read";
}

TEST(Mesh3mf, ReadsArchivesOf64Bits) {
  const std::string package = package_made(model_made(unit_object, item_made(1)), {}, true);
  EXPECT_EQ(checked_mesh(package, MeshFormat::three_mf).polygon_count(), 4u);
}

}  // namespace
}  // namespace sunder::io
