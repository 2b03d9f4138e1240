// Where the meshes of robots are: packages by name, as ROS has them.
#pragma once

#include <sunder/base/error.h>

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sunder::io {

struct Packages {
  std::vector<std::pair<std::string, std::filesystem::path>> named;  // name, folder; each name once
  std::vector<std::filesystem::path> search;                         // folders that hold packages
};

// named: "NAME=FOLDER" each. search: folders with ':' between them, as ROS_PACKAGE_PATH has them; may be empty.
// Throws Error bad_call, with the place --package: no '=', a name that is empty or comes twice, what is no folder.
Packages parse_packages(std::span<const std::string> named, const std::string& search);

// The file that a mesh's name in a robot's file means.
// - package://NAME/rest and model://NAME/rest: where NAME is in packages.named, in that folder and nowhere else. Else
//   in the folders that are the package: above the robot's file, or beside one of these folders, or in packages.search,
//   with NAME as their own or as the name in their package.xml. Else, where no folder above the robot's file has a
//   package.xml (a robot copied out of its package), or for model://: rest, then rest without its first folder, first
//   two folders, ..., down to the bare name, in the robot's folder.
// - a relative name: in the robot's folder; an absolute one and file://NAME: as it is, and nothing else.
// Throws Error bad_file that lists what was tried, or says that there is no such package and whose file the robot's is;
// and says so for http:// and the like, which are not fetched.
std::filesystem::path resolve_mesh(const std::string& written, const std::filesystem::path& robot_folder,
                                   const Packages& packages = {});

}  // namespace sunder::io
