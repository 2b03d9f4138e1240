// What a certificate file of a scene says besides (certificate/said.h). Nothing of it is proved.
#pragma once

#include <sunder/certificate/said.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sunder::scene {

struct SaidOfScene {
  std::vector<std::vector<Said>> parts{};  // of each body, of each part, what it is made of; empty: nothing is said
  std::vector<std::string> reasons{};      // of each pair of Question::allowed, why it is; empty: nothing is said
  // By which joint values the bodies are placed; none: nothing is said.
  std::function<std::optional<SaidNote>(std::size_t placement)> joints{};

  std::vector<std::vector<Said>> meshes{};  // of each part, what it is made of as a mesh; empty: nothing is said

  Said of(std::size_t body, std::size_t part) const { return parts.empty() ? Said() : parts[body][part]; }
  Said as_mesh(std::size_t body, std::size_t part) const { return meshes.empty() ? Said() : meshes[body][part]; }
  std::optional<SaidNote> joints_of(std::size_t placement) const { return joints ? joints(placement) : std::nullopt; }
};

}  // namespace sunder::scene
