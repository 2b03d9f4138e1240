#include <sunder/ask/packages_option.h>

#include <cstdlib>

namespace sunder::ask {

Option package_option(std::vector<std::string>& named) {
  return {"--package", &named,
          "the folder of the ROS package NAME, for meshes named package://NAME/...; also searched: ROS_PACKAGE_PATH",
          "NAME=FOLDER"};
}

io::Packages packages_of(const std::vector<std::string>& named) {
  const char* search = std::getenv("ROS_PACKAGE_PATH");
  return io::parse_packages(named, search == nullptr ? "" : search);
}

}  // namespace sunder::ask
