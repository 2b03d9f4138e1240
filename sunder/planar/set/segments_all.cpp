#include <sunder/planar/set/segments_all.h>

#include <algorithm>

namespace sunder::planar {

Cost visit_contacts(const Segments& segments, const SegmentsOptions& options, const ContactVisitor& visit) {
  return visit_contacts_by_grid(segments, options, visit);
}

Cost visit_contacts_of_block(const Segments& segments, const SegmentsOptions& options, const Block& block,
                             ContactMethod* by, const ContactVisitor& visit) {
  if (block.size() == segments.size()) return by(segments, options, visit);
  if (!is_narrow(block, segments.size())) {
    return by(segments, options, [&](const SegmentsContact& c) { return !block.holds(c.i) || visit(c); });
  }
  Cost cost;
  for_each_near_pair_of(block, segments.all(), [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++cost.probes;
    const ContactKind kind = segment_segment(segments[i], segments[j]);
    return !counts(kind, options.allowed) || visit({i, j, kind});
  });
  return cost;
}

namespace {

Cost visit_all(const Segments& segments, const SegmentsOptions& options, const ContactVisitor& visit,
               SweepEvents& transcript) {
  return options.transcript ? visit_contacts_with_transcript(segments, options, visit, transcript)
                            : visit_contacts(segments, options, visit);
}

}  // namespace

SegmentsAllAnswer segments_all(const Segments& segments, const SegmentsOptions& options) {
  SegmentsAllAnswer answer;
  const auto add = [&](const SegmentsContact& contact) {
    answer.contacts.push_back(contact);
    return true;
  };
  answer.cost = visit_all(segments, options, add, answer.transcript);
  if (options.transcript) std::sort(answer.contacts.begin(), answer.contacts.end());
  return answer;
}

SegmentsCountAnswer segments_count(const Segments& segments, const SegmentsOptions& options) {
  SegmentsCountAnswer answer;
  const auto add = [&](const SegmentsContact&) {
    ++answer.count;
    return true;
  };
  answer.cost = visit_all(segments, options, add, answer.transcript);
  return answer;
}

}  // namespace sunder::planar
