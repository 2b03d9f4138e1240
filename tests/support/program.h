// What the tests of the program share: files with known answers, a folder of its own for each test, running the
// program, and what every verb must do.
#pragma once

#include <tests/support/places.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace sunder::tests {

namespace fs = std::filesystem;
using nlohmann::json;

inline const std::string cases = cases_folder();
inline const std::string cube = cases + "/mesh/cube.obj";
inline const std::string tetrahedron = cases + "/mesh/tetrahedron.stl";
inline const std::string panda = cases + "/panda/panda.urdf";
inline const std::string ready = " --joints-file " + cases + "/scene/ready.joints";
inline const std::string folded = " --joints-file " + cases + "/scene/folded.joints";

std::string read_text(const fs::path& path);
void write_text(const fs::path& path, const std::string& text);
std::vector<std::string> lines_of(const std::string& text);

// A folder of its own for each test, removed at the end.
class Program : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override { fs::remove_all(folder_); }

  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t files_in_folder() const;

  struct Run {
    int code = -1;  // of exit; -1: it did not exit by itself
    std::string out, err;
  };

  // The arguments as a shell reads them.
  Run run(const std::string& arguments) const;

  // Code 2, nothing on standard output, one line on standard error that holds `part`, no file left behind.
  void expect_bad(const std::string& arguments, const std::string& part) const;

  // The report, with the keys that all verbs have.
  json report(const std::string& arguments, int code) const;

  // Does the Python verifier accept the file?
  static bool python_accepts(const std::string& file);

  fs::path folder_;
};

}  // namespace sunder::tests
