#include <cli/scene_picture.h>
namespace sunder::cli {
std::string scene_picture(const SceneReport&, const std::string&) { return ""; }
}
