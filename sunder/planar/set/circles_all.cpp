#include <sunder/planar/set/circles_all.h>

namespace sunder::planar {

Cost visit_circle_contacts(const Circles& circles, const CirclesOptions& options, const CirclesContactVisitor& visit) {
  return visit_circle_contacts_by_grid(circles, options, visit);
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
