#include <sunder/base/error.h>
#include <sunder/io/robot/packages.h>
#include <sunder/io/text/file.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <fstream>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

using tests::cases;

template <class Action>
std::string package_error(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// A folder with packages: src/right (package.xml says so), src/other_folder (package.xml says "other"), lone (none).
class PackagesOnDisk : public testing::Test {
 protected:
  PackagesOnDisk() {
    put("src/right/package.xml", "<package format=\"2\"><name> right </name></package>");
    put("src/right/meshes/a.stl");
    put("src/right/urdf/robot.urdf");
    put("src/other_folder/package.xml", "<package><name>other</name></package>");
    put("src/other_folder/meshes/b.stl");
    put("src/plain/c.stl");
    put("lone/meshes/d.stl");
  }
  ~PackagesOnDisk() override {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  PackagesOnDisk(const PackagesOnDisk&) = delete;
  PackagesOnDisk& operator=(const PackagesOnDisk&) = delete;

  void put(const fs::path& name, const std::string& text = "x") const {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }

  const fs::path root_ = fs::temp_directory_path() / (std::string("sunder_packages_") +
                                                      testing::UnitTest::GetInstance()->current_test_info()->name());
  const fs::path urdf_ = root_ / "src/right/urdf";
};

TEST_F(PackagesOnDisk, AreFoundByTheNameInPackageXml) {
  EXPECT_EQ(resolve_mesh("package://right/meshes/a.stl", urdf_), root_ / "src/right/meshes/a.stl");
  EXPECT_EQ(resolve_mesh("package:///right/meshes/a.stl", urdf_), root_ / "src/right/meshes/a.stl");
  EXPECT_EQ(resolve_mesh("package://plain/c.stl", urdf_), root_ / "src/plain/c.stl") << "beside the robot's package";
}

TEST_F(PackagesOnDisk, AWrongNameIsNotAnsweredFromAnotherPackage) {
  const std::string text = package_error([&] { resolve_mesh("package://wrong/meshes/a.stl", urdf_); });
  EXPECT_EQ(text, "package://wrong/meshes/a.stl: there is no package 'wrong'; the robot's file is of 'right', by " +
                      (root_ / "src/right/package.xml").string() +
                      "; name the package's folder: --package wrong=FOLDER");
  EXPECT_NE(
      package_error([&] { resolve_mesh("package://right/meshes/none.stl", urdf_); }).find("no such mesh; tried: "),
      std::string::npos);
}

TEST_F(PackagesOnDisk, NamedAndSearched) {
  const std::string other = "package://other/meshes/b.stl";
  EXPECT_NE(package_error([&] { resolve_mesh(other, urdf_); }).find("there is no package 'other'"), std::string::npos);
  const std::string src = (root_ / "src").string();
  const Packages searched = parse_packages({}, ":/nowhere::" + src);
  EXPECT_EQ(searched.search.size(), 2u);
  EXPECT_EQ(resolve_mesh(other, urdf_, searched), root_ / "src/other_folder/meshes/b.stl");

  const std::vector<std::string> words{"other=" + src + "/other_folder", "right=" + src + "/plain"};
  const Packages named = parse_packages(words, "");
  EXPECT_EQ(resolve_mesh(other, urdf_, named), root_ / "src/other_folder/meshes/b.stl");
  EXPECT_EQ(resolve_mesh("package://right/c.stl", urdf_, named), root_ / "src/plain/c.stl");
  EXPECT_NE(package_error([&] {
              resolve_mesh("package://right/meshes/a.stl", urdf_, named);
            }).find("correct --package right"),
            std::string::npos)
      << "a named package is nowhere else";
}

TEST_F(PackagesOnDisk, ARobotOutsideOfAnyPackageHasItsMeshesInItsFolder) {
  EXPECT_EQ(resolve_mesh("package://any/x/meshes/d.stl", root_ / "lone"), root_ / "lone/meshes/d.stl");
  EXPECT_EQ(resolve_mesh("model://any/a.stl", root_ / "src/right/meshes"), root_ / "src/right/meshes/a.stl");
}

TEST(Packages, FindsMeshesWithoutAPackage) {
  const fs::path folder = cases / "mesh";
  const fs::path panda = cases / "panda";
  const std::string link0 = "package://example-robot-data/robots/panda_description/meshes/collision/link0.stl";
  EXPECT_EQ(resolve_mesh(link0, panda), panda / "meshes" / "collision" / "link0.stl");
  EXPECT_EQ(resolve_mesh("cube.off", folder), folder / "cube.off");
  EXPECT_EQ(resolve_mesh("../mesh/cube.off", folder), folder / "../mesh/cube.off");
  EXPECT_EQ(resolve_mesh((folder / "cube.off").string(), "/nowhere"), folder / "cube.off");
  EXPECT_EQ(resolve_mesh("file://" + (folder / "cube.off").string(), "/nowhere"), folder / "cube.off");
  // A folder above the robot's that has the name of the package.
  EXPECT_EQ(resolve_mesh("package://cases/mesh/cube.off", panda / "meshes"), cases / "mesh" / "cube.off");
}

TEST(Packages, ListWhatWasTried) {
  EXPECT_EQ(package_error([] { resolve_mesh("package://p/q/m.stl", "/two"); }),
            "package://p/q/m.stl: no such mesh; tried: /two/q/m.stl, /two/m.stl; name the package's folder: --package "
            "p=FOLDER");
  EXPECT_EQ(package_error([] { resolve_mesh("m.stl", "/two"); }),
            "m.stl: no such mesh; tried: /two/m.stl; correct the name, or put the file there");
  EXPECT_NE(package_error([] { resolve_mesh("https://x/m.stl", ""); }).find("not fetched"), std::string::npos);
  EXPECT_NE(package_error([] { resolve_mesh("package://", ""); }).find("tried: nothing"), std::string::npos);
  EXPECT_NE(package_error([] { resolve_mesh("package://p/none.stl", ""); }).find("no such mesh"), std::string::npos);
}

TEST(Packages, RefusesCallsWithoutSense) {
  for (const auto& [words, part] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"name"}, "'name' is not of the form NAME=FOLDER"},
           {{"=/tmp"}, "is not of the form NAME=FOLDER"},
           {{"a=/no/such/folder"}, "'/no/such/folder' is no folder"},
           {{"a=/", "a=/"}, "the package 'a' comes twice"}}) {
    const std::string text = package_error([&] { static_cast<void>(parse_packages(words, "")); });
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_TRUE(text.starts_with("--package: ")) << text;
  }
}

}  // namespace
}  // namespace sunder::io
