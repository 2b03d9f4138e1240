#include <sunder/ask/packages_option.h>

namespace sunder::ask {

Option package_option(std::vector<std::string>& named) {
  return {"--package", &named,
          "the folder of the ROS package NAME, for meshes named package://NAME/...; also searched: ROS_PACKAGE_PATH",
          "NAME=FOLDER"};
}

io::Packages packages_of(const Talk& talk, const std::vector<std::string>& named) {
  return io::parse_packages(named, talk.sinks().package_paths);
}

}  // namespace sunder::ask
