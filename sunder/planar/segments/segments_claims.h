// Certificates of answers about a set of segments (docs/claims.md, "segments").
//
// None throws, but for want of memory, or what the writer's sink throws.
// Cost: linear in the segments, the list and the events; exact arithmetic for one common point.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_any.h>

#include <algorithm>
#include <string>

namespace sunder::planar {

// An entry of the table, and for set_statement.h the common point of two.
void write_row(ClaimsWriter& file, const Segment& s);
void write_point(ClaimsWriter& file, const Segment& s, const Segment& t);

// The table and the statement. Requires an answer about these segments under this rule and with these groups. events:
// of these segments (sweep_events; or a transcript); not looked at where some meet. The certificate must be true: the
// common point is computed here.
void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAnswer& answer,
                     const SweepEvents& events, Groups groups = {});

// The same: exactly these meet, which requires contacts by i, then j; so many meet.
void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const SegmentsAllAnswer& answer,
                     const SweepEvents& events, Groups groups = {});
void write_statement(ClaimsWriter& file, const Segments& segments, Allowed allowed, const CountAnswer<>& answer,
                     const SweepEvents& events, Groups groups = {});

// The whole file. answer: one of the three; contacts in any order. origin: where the segments come from.
// Cost: also that of sweep_events, but where some meet.
template <class Answer>
std::string certificate_text(const Segments& segments, Allowed allowed, Answer answer, Groups groups = {},
                             const Origin& origin = {}) {
  bool needs_events = true;
  if constexpr (requires { answer.meet(); }) needs_events = !answer.meet();
  if constexpr (requires { answer.found.begin(); }) std::sort(answer.found.begin(), answer.found.end());
  const SweepEvents events = needs_events ? *sweep_events(segments) : SweepEvents();
  return claims_text(origin,
                     [&](ClaimsWriter& file) { write_statement(file, segments, allowed, answer, events, groups); });
}

}  // namespace sunder::planar
