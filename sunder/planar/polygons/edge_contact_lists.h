// The contacts of edges of a set of polygons, listed for PolygonMeetings.
#pragma once

#include <sunder/planar/polygons/polygon_meetings.h>

#include <functional>
#include <optional>
#include <span>

namespace sunder::planar {

// Which contacts of edges are wanted: those of polygons that are not of one group, and, where `own` is set, those
// within a polygon too, save of edges that follow each other.
struct WantedContacts {
  Groups groups{};
  bool own = true;
  std::function<void(double)> progress = nullptr;
};

// By a grid, or not at all: nothing where that does not pay, or many edges crowd in a cell. Stops, and returns false,
// where `meetings` does.
std::optional<bool> take_contacts_by_grid(const PolygonEdges& edges, const WantedContacts& wanted,
                                          PolygonMeetings& meetings);

// Of some edges only; if they are few, each against each.
std::optional<bool> take_contacts_of(std::span<const std::uint32_t> some, const PolygonEdges& edges,
                                     const WantedContacts& wanted, PolygonMeetings& meetings);

}  // namespace sunder::planar
