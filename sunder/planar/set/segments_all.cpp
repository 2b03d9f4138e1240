#include <sunder/planar/set/segments_all.h>

namespace sunder::planar {

Cost visit_contacts(const Segments& segments, const SegmentsOptions& options, const ContactVisitor& visit) {
  return visit_contacts_by_grid(segments, options, visit);
}

SegmentsAllAnswer segments_all(const Segments& segments, const SegmentsOptions& options) {
  SegmentsAllAnswer answer;
  answer.cost = visit_contacts(segments, options, [&](const SegmentsContact& contact) {
    answer.contacts.push_back(contact);
    return true;
  });
  return answer;
}

SegmentsCountAnswer segments_count(const Segments& segments, const SegmentsOptions& options) {
  SegmentsCountAnswer answer;
  answer.cost = visit_contacts(segments, options, [&](const SegmentsContact&) {
    ++answer.count;
    return true;
  });
  return answer;
}

}  // namespace sunder::planar
