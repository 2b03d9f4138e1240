// Which of many boxes meet? The broad phase of a scene.
#pragma once

#include <sunder/scene/world_box.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::scene {

// All pairs {i, j}, i < j, of boxes that have a common point, in increasing order.
// Sorts the boxes along the axis on which their lower ends are spread most, and sweeps over it.
// Cost: n log n, one comparison for each pair that meets along that axis, and the sorting of the result.
std::vector<std::array<std::uint32_t, 2>> meeting_boxes(std::span<const WorldBox> boxes);

}  // namespace sunder::scene
