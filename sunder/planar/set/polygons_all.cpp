#include <sunder/planar/set/edge_contact_lists.h>
#include <sunder/planar/set/polygon_pairs.h>
#include <sunder/planar/set/polygons_all.h>

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace {

// Of what was found of each pair, what tells most: overlapping before touching, and of the latter the greatest kind.
// Then the lowest edges, so that the order in which it was found does not matter.
std::vector<PolygonsContact> one_of_each(std::vector<PolygonsContact> found, Allowed allowed) {
  const auto key = [](const PolygonsContact& c) {
    const int tells_less = c.contact == Contact::overlapping ? 0 : 8 - static_cast<int>(c.kind);
    return std::tuple(c.i, c.j, tells_less, c.of_i, c.of_j);
  };
  std::sort(found.begin(), found.end(),
            [&](const PolygonsContact& a, const PolygonsContact& b) { return key(a) < key(b); });
  std::vector<PolygonsContact> contacts;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool is_first = k == 0 || found[k].i != found[k - 1].i || found[k].j != found[k - 1].j;
    if (is_first && counts(found[k], allowed)) contacts.push_back(found[k]);
  }
  return contacts;
}

// The contacts by this number, which is below `count`; those with the same one keep their order. Without comparisons,
// whose outcome nobody can predict.
std::vector<PolygonsContact> in_order_of(std::uint32_t PolygonsContact::* number, std::vector<PolygonsContact> contacts,
                                         std::uint32_t count) {
  std::vector<std::size_t> place(count);  // of the next one with this number
  for (const PolygonsContact& c : contacts) ++place[c.*number];
  std::size_t before = 0;
  for (std::size_t& p : place) before += std::exchange(p, before);
  std::vector<PolygonsContact> ordered(contacts.size());
  for (const PolygonsContact& c : contacts) ordered[place[c.*number]++] = c;
  return ordered;
}

using Take = bool(const PolygonEdges&, const WantedContacts&, PolygonMeetings&);

PolygonsAllAnswer all_by(Take* take, std::span<const Polygon> polygons, const PolygonsOptions& options) {
  PolygonEdges edges(pointers_to(polygons));
  std::vector<PolygonsContact> found;
  PolygonMeetings meetings(edges, options.groups, [&](const PolygonsContact& c) {
    // Contacts along a border follow each other.
    const bool again = !found.empty() && found.back().i == c.i && found.back().j == c.j &&
                       found.back().contact == c.contact && found.back().kind == c.kind;
    if (!again) found.push_back(c);
    return true;
  });
  take(edges, {options.groups, true, options.progress}, meetings);
  meetings.look_around_points();
  meetings.look_inside();
  return {one_of_each(std::move(found), options.allowed), meetings.cost};
}

}  // namespace

PolygonsAllAnswer polygons_all(std::span<const Polygon> polygons, const PolygonsOptions& options) {
  return polygons_all_by_boxes(polygons, options);
}

PolygonsCountAnswer polygons_count(std::span<const Polygon> polygons, const PolygonsOptions& options) {
  const PolygonsAllAnswer all = polygons_all(polygons, options);
  PolygonsCountAnswer answer;
  answer.cost = all.cost;
  for (const PolygonsContact& c : all.contacts)
    ++(c.contact == Contact::touching ? answer.touching : answer.overlapping);
  return answer;
}

PolygonsAllAnswer polygons_all_by_boxes(std::span<const Polygon> polygons, const PolygonsOptions& options) {
  PolygonsAllAnswer answer;
  const auto add = [&](const PolygonsContact& c) {
    if (counts(c, options.allowed)) answer.contacts.push_back(c);
    return true;
  };
  Cost cost;
  if (for_each_meeting_pair(polygons, options, cost, add)) {
    const std::uint32_t count = static_cast<std::uint32_t>(polygons.size());
    answer.contacts = in_order_of(&PolygonsContact::j, std::move(answer.contacts), count);
    answer.contacts = in_order_of(&PolygonsContact::i, std::move(answer.contacts), count);
  } else {
    answer = polygons_all_by_grid(polygons, options);
  }
  answer.cost.probes += cost.probes;
  return answer;
}

PolygonsAllAnswer polygons_all_by_grid(std::span<const Polygon> polygons, const PolygonsOptions& options) {
  return all_by(take_contacts_by_grid, polygons, options);
}

PolygonsAllAnswer polygons_all_by_sweep(std::span<const Polygon> polygons, const PolygonsOptions& options) {
  return all_by(take_contacts_by_sweep, polygons, options);
}

}  // namespace sunder::planar
