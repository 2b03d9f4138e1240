// Certificates of answers about a set of segments (docs/claims.md, "segments").
//
// None throws, but for want of memory, or what the writer's sink throws.
// Cost: linear in the segments, the list and the transcript; exact arithmetic for one common point.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_any.h>

#include <string>

namespace sunder::planar {

// An entry of the table, and for set_statement.h the common point of two.
void write_row(ClaimsWriter& file, const Segment& s);
void write_point(ClaimsWriter& file, const Segment& s, const Segment& t);

// The table and the statement. Requires an answer about these segments under this rule and with these groups; one of
// `none` with its transcript. The certificate must be true: the common point is computed here.
void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAnswer& answer,
                     Groups groups = {});

// The same: exactly these meet, so many meet. Requires an answer with its transcript.
void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAllAnswer& answer,
                     Groups groups = {});
void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsCountAnswer& answer,
                     Groups groups = {});

// The whole file. Answer: one of the three. origin: where the segments come from.
template <class Answer>
std::string certificate_text(const Segments& segments, Allowed allowed, const Answer& answer, Groups groups = {},
                             const Origin& origin = {}) {
  return claims_text(origin, [&](ClaimsWriter& file) { write_statement(file, segments, allowed, answer, groups); });
}

}  // namespace sunder::planar
