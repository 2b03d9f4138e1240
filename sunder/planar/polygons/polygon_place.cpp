#include <sunder/planar/polygons/polygon_place.h>

#include <algorithm>
#include <utility>

namespace sunder::planar {

bool PolygonPlace::report(Relation contact, std::uint32_t e, std::uint32_t f, ContactKind kind) {
  if (edges_.polygon_of(e) > edges_.polygon_of(f)) std::swap(e, f);
  return found_(
      {contact, kind, false, edges_.polygon_of(e), edges_.polygon_of(f), edges_.in_polygon(e), edges_.in_polygon(f)});
}

bool PolygonPlace::report_if_wanted(Relation contact, std::uint32_t e, std::uint32_t f) {
  ++probes;
  if (!is_wanted(edges_.polygon_of(e), edges_.polygon_of(f))) return true;
  return report(contact, e, f, segment_segment(edges_.edges()[e], edges_.edges()[f]));
}

bool PolygonPlace::look(std::span<const Leaving> leaving) {
  find_members(leaving);
  if (members_.empty() || members_.front().group == members_.back().group) return true;
  return look_at_touches(leaving) && look_at_sectors(leaving);
}

// Each polygon once, by an edge that passes where there is one: that meets others in the greatest way.
void PolygonPlace::find_members(std::span<const Leaving> leaving) {
  ++point_;
  members_.clear();
  for (const Leaving& l : leaving) {
    ++probes;
    const std::uint32_t polygon = edges_.polygon_of(l.edge);
    if (std::exchange(seen_[polygon], point_) != point_) {
      member_of_[polygon] = static_cast<std::uint32_t>(members_.size());
      members_.push_back({group_of(polygon), polygon, l.edge, l.passes});
    } else if (Member& member = members_[member_of_[polygon]]; l.passes && !member.passes) {
      member.edge = l.edge;
      member.passes = true;
    }
  }
  std::sort(members_.begin(), members_.end(), [this](const Member& a, const Member& b) {
    ++probes;
    return a.group != b.group ? a.group < b.group : a.polygon < b.polygon;
  });
  for (std::uint32_t m = 0; m < members_.size(); ++m) member_of_[members_[m].polygon] = m;
}

// Pairs that touch, and may overlap, also where edges cross: one of edges that leave in one direction, where one
// begins, and one of any edges.
bool PolygonPlace::look_at_touches(std::span<const Leaving> leaving) {
  if (allowed_ == Allowed::touch) return true;
  for (std::size_t k = 0, end; k < leaving.size(); k = end) {
    along_.clear();
    for (end = k; end < leaving.size() && (end == k || !leaving[end].turns); ++end) {
      const std::uint32_t e = leaving[end].edge, polygon = edges_.polygon_of(e);
      along_.push_back({group_of(polygon), polygon, e, leaving[end].passes, !leaving[end].passes});
    }
    if (along_.size() < 2) continue;
    std::sort(along_.begin(), along_.end(), [this](const Member& a, const Member& b) {
      ++probes;
      return a.group != b.group ? a.group < b.group : a.edge < b.edge;
    });
    if (!touch_across_groups(along_)) return false;
  }
  for (Member& member : members_) member.chosen = allowed_ == Allowed::nothing || member.passes;
  return touch_across_groups(members_);
}

// Pairs of different groups of which one is chosen. They are in the order of their groups.
bool PolygonPlace::touch_across_groups(std::span<const Member> members) {
  for (std::size_t k = 0, begin = 0, end = 0; k < members.size(); ++k) {
    ++probes;
    if (k == end) {
      begin = k;
      while (end < members.size() && members[end].group == members[begin].group) ++end;
    }
    if (!members[k].chosen) continue;
    for (std::size_t l = 0; l < members.size(); ++l) {
      if (l == begin) {
        l = end - 1;
        continue;
      }
      if (l < k && members[l].chosen) continue;  // it was looked at
      if (!report_if_wanted(Relation::touching, members[k].edge, members[l].edge)) return false;
    }
  }
  return true;
}

// In each sector, the lists of open_ have those that fill it. The first one, before the first direction, is filled by
// those whose last direction opens.
bool PolygonPlace::look_at_sectors(std::span<const Leaving> leaving) {
  const std::uint32_t count = static_cast<std::uint32_t>(members_.size());
  open_.clear();
  open_groups_.clear();
  open_of_.resize(count);
  open_edge_.resize(count);
  open_list_.resize(count);
  place_in_list_.assign(count, closed);
  for (std::uint32_t m = 0; m < count; ++m) {
    if (m == 0 || members_[m].group != members_[m - 1].group) open_.push_back({m, 0, 0});
    open_of_[m] = static_cast<std::uint32_t>(open_.size() - 1);
    members_[m].chosen = true;  // its last direction is to be seen yet
  }
  for (std::size_t k = leaving.size(); k-- > 0;) {
    Member& member = members_[member_of_[edges_.polygon_of(leaving[k].edge)]];
    if (std::exchange(member.chosen, false) && leaving[k].opens && !enter(leaving[k].edge)) return false;
  }
  for (std::size_t k = 0, end; k < leaving.size(); k = end) {
    for (end = k; end < leaving.size() && (end == k || !leaving[end].turns); ++end) {
      if (!leaving[end].opens) leave(leaving[end].edge);
    }
    for (std::size_t l = k; l < end; ++l) {
      if (leaving[l].opens && !enter(leaving[l].edge)) return false;
    }
  }
  return true;
}

bool PolygonPlace::enter(std::uint32_t edge) {
  const std::uint32_t m = member_of_[edges_.polygon_of(edge)], group = open_of_[m];
  for (const std::uint32_t g : open_groups_) {
    if (g == group) continue;
    for (std::uint32_t k = open_[g].begin; k < open_[g].begin + open_[g].count; ++k) {
      if (!report_if_wanted(Relation::overlapping, open_edge_[open_list_[k]], edge)) return false;
    }
  }
  open_edge_[m] = edge;
  if (place_in_list_[m] != closed) return true;
  Open& open = open_[group];
  if (open.count == 0) {
    open.place = static_cast<std::uint32_t>(open_groups_.size());
    open_groups_.push_back(group);
  }
  place_in_list_[m] = open.begin + open.count++;
  open_list_[place_in_list_[m]] = m;
  return true;
}

void PolygonPlace::leave(std::uint32_t edge) {
  const std::uint32_t m = member_of_[edges_.polygon_of(edge)];
  if (place_in_list_[m] == closed) return;
  Open& open = open_[open_of_[m]];
  const std::uint32_t last = open_list_[open.begin + --open.count];
  const std::uint32_t place = std::exchange(place_in_list_[m], closed);
  if (last != m) {
    open_list_[place] = last;
    place_in_list_[last] = place;
  }
  if (open.count > 0) return;
  open_[open_groups_.back()].place = open.place;
  open_groups_[open.place] = open_groups_.back();
  open_groups_.pop_back();
}

}  // namespace sunder::planar
