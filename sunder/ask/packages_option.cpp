#include <sunder/ask/packages_option.h>

#include <cstdlib>

namespace sunder::ask {

Option package_option(std::vector<std::string>& named) {
  return {"--package", &named, "where a package of meshes is; also in ROS_PACKAGE_PATH", "NAME=FOLDER"};
}

io::Packages packages_of(const std::vector<std::string>& named) {
  const char* search = std::getenv("ROS_PACKAGE_PATH");
  return io::parse_packages(named, search == nullptr ? "" : search);
}

}  // namespace sunder::ask
