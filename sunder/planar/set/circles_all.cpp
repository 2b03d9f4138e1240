#include <sunder/planar/set/circle_boxes.h>
#include <sunder/planar/set/circles_all.h>

namespace sunder::planar {

Cost visit_circle_contacts(const Circles& circles, const CirclesOptions& options, const CirclesContactVisitor& visit) {
  return visit_circle_contacts_by_grid(circles, options, visit);
}

Cost visit_circle_contacts_of_block(const Circles& circles, const CirclesOptions& options, const Block& block,
                                    CirclesContactMethod* by, const CirclesContactVisitor& visit) {
  if (block.size() == circles.size()) return by(circles, options, visit);
  if (!is_narrow(block, circles.size())) {
    return by(circles, options, [&](const CirclesContact& c) { return !block.holds(c.i) || visit(c); });
  }
  Cost cost;
  for_each_near_pair_of(block, box_diagonals(circles), [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++cost.probes;
    const DiscContact kind = circle_circle(circles[i], circles[j]);
    return !counts(kind, options.allowed) || visit({i, j, kind});
  });
  return cost;
}

CirclesAllAnswer circles_all(const Circles& circles, const CirclesOptions& options) {
  CirclesAllAnswer answer;
  answer.cost = visit_circle_contacts(circles, options, [&](const CirclesContact& contact) {
    answer.contacts.push_back(contact);
    return true;
  });
  return answer;
}

CirclesCountAnswer circles_count(const Circles& circles, const CirclesOptions& options) {
  CirclesCountAnswer answer;
  answer.cost = visit_circle_contacts(circles, options, [&](const CirclesContact&) {
    ++answer.count;
    return true;
  });
  return answer;
}

}  // namespace sunder::planar
