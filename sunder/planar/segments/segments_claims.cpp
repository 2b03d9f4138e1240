#include <sunder/near/set_statement.h>
#include <sunder/planar/segments/segments_claims.h>
#include <sunder/planar/sweep/sweep_claims.h>
#include <sunder/predicate/line/crossing.h>

#include <algorithm>
#include <array>

namespace sunder::planar {

void write_row(ClaimsWriter& file, const Segment& s) { file.add_row(std::array{s.a.x, s.a.y, s.b.x, s.b.y}); }

void write_point(ClaimsWriter& file, const Segment& s, const Segment& t) {
  const ExactPoint2 p = common_point(s, t);
  file.fractions("point", std::array{p.x, p.y}, p.denominator);
}

void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAnswer& answer,
                     const SweepEvents& events, Groups groups) {
  begin_set_statement(file, "segments", segments, allowed, groups, answer.meet() ? "some" : "none");
  if (answer.meet()) return end_some_statement(file, segments, *answer.found);
  write_sweep(file, "none_counts", events);
  file.end_statement();
}

void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAllAnswer& answer,
                     const SweepEvents& events, Groups groups) {
  begin_set_statement(file, "segments", segments, allowed, groups, "these");
  write_contacts<SegmentsContact>(
      file, [&](const auto& take) { std::for_each(answer.found.begin(), answer.found.end(), take); });
  write_sweep(file, "these_count", events);
  file.end_statement();
}

void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const CountAnswer<>& answer,
                     const SweepEvents& events, Groups groups) {
  begin_set_statement(file, "segments", segments, allowed, groups, "count");
  file.number("number", answer.count);
  write_sweep(file, "number_counts", events);
  file.end_statement();
}

}  // namespace sunder::planar
