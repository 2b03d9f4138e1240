// Any bytes, read as a scene of JSON. Seeds: cases/scene, cases/space.
#include <fuzz/mesh_fuzz.h>
#include <sunder/io/robot/scene_file.h>
#include <sunder/scene/scene.h>

#include <cstdint>
#include <set>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using sunder::fuzz::require;
  constexpr std::string_view file = "fuzz";
  sunder::io::SceneFile scene;
  try {
    scene = sunder::io::parse_scene_file({reinterpret_cast<const char*>(data), size}, file);
  } catch (const sunder::Error& error) {
    sunder::fuzz::check_message(error, file);
    return 0;
  }
  std::set<std::string> names;
  std::vector<sunder::scene::Body> bodies;
  for (const auto& body : scene.bodies) {
    require(!body.name.empty() && names.insert(body.name).second && !body.parts.empty(), "C1");
    bodies.push_back({body.name, {}});
    for (const auto& part : body.parts) {
      require(part.mesh.has_value() != part.shape.has_value(), "a part's shape");
      if (part.shape) bodies.back().parts.push_back({part.name, *part.shape, part.pose});
    }
  }
  require(!bodies.empty(), "C1");
  for (const auto& [a, b] : scene.allowed) require(a < b && b < bodies.size(), "C3");
  if (bodies.size() > 20) return 0;
  sunder::scene::Question question;
  question.allowed = scene.allowed;
  const auto answer = sunder::scene::meeting_pairs(bodies, question);
  require(answer.counts.pairs == answer.counts.allowed + answer.counts.by_boxes + answer.counts.by_method, "the sums");
  return 0;
}
