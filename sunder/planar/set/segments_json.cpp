#include <sunder/planar/set/segments_json.h>
#include <sunder/planar/sweep/sweep_json.h>
#include <sunder/predicate/crossing.h>

#include <array>
#include <string_view>

namespace sunder::planar {

namespace {

void write_contact(ClaimsWriter& file, const Segments& segments, const SegmentsContact& found) {
  file.text("verdict", "some");
  file.index("i", found.i);
  file.index("j", found.j);
  file.text("kind", std::string(name_of(found.kind)));
  const ExactPoint2 p = common_point(segments[found.i], segments[found.j]);
  file.fractions("point", std::array{p.x, p.y}, p.denominator);
  file.begin_claims();
  file.begin_claim("contact");
  file.end_claim();
}

// The table, and the statement up to its verdict.
void begin_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, Groups groups) {
  file.begin_table("segments");
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    file.add_row(std::array{segments[i].a.x, segments[i].a.y, segments[i].b.x, segments[i].b.y});
  }
  file.end_table();
  file.begin_statement("segments");
  file.text("allowed", std::string(name_of(allowed)));
  if (!groups.empty()) file.indices("groups", groups);
}

}  // namespace

void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAnswer& answer,
                     Groups groups) {
  begin_statement(file, segments, allowed, groups);
  if (answer.meet()) {
    write_contact(file, segments, *answer.found);
  } else {
    file.text("verdict", "none");
    write_sweep(file, "none_counts", answer.transcript);
  }
  file.end_statement();
}

void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAllAnswer& answer,
                     Groups groups) {
  begin_statement(file, segments, allowed, groups);
  file.text("verdict", "these");
  file.begin_list("contacts");
  for (const SegmentsContact& c : answer.contacts) file.add_contact(c.i, c.j, name_of(c.kind));
  file.end_list();
  write_sweep(file, "these_count", answer.transcript);
  file.end_statement();
}

void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsCountAnswer& answer,
                     Groups groups) {
  begin_statement(file, segments, allowed, groups);
  file.text("verdict", "count");
  file.number("number", answer.count);
  write_sweep(file, "number_counts", answer.transcript);
  file.end_statement();
}

}  // namespace sunder::planar
