// A bundle: the segments that hold one point of a sweep, and those of their pairs whose contact is given there. For use
// by the sweeps that list contacts.
//
// In the order of the sweep a member goes back from the point (it began before), on (it ends after it), both or
// neither. Two that go back along one line overlap, and so do two that go on along one line. Of any other two the point
// is the only one in common, and the kind of contact is told by how many of them begin or end there: both, one or none.
// So the lines are told apart, once a member, and no two members are compared. An overlap is given where the later of
// the two begins, all else here.
//
// Pairs that do not count are passed over by kind and by group, not one by one.
// Cost: O(m log m) for m members, and the pairs given; of pairs that overlap, those of which one begins or ends here.
#pragma once

#include <sunder/planar/segments/segments_all.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

class ContactBundle {
 public:
  // Keeps references.
  ContactBundle(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit, Cost& cost);

  // Those at a point p. Requires that it was called, and where need be add_aside, for each place before at which one of
  // these began that was not alone there. row: alive just before, from below to above; begins: those that begin;
  // points: of length zero. p may be null where none begins or ends.
  void set(std::span<const std::uint32_t> row, std::span<const std::uint32_t> begins,
           std::span<const std::uint32_t> points, const Point2* p);

  // More that pass, all on one line, whose crossings with the row are given elsewhere.
  void add_aside(std::span<const std::uint32_t> segments);

  // Those of the row that pass, and those that begin, from below to above just after the point; of those on one line
  // the lower number first, if it is so in the row.
  const std::vector<std::uint32_t>& after() const { return after_; }

  // Gives the pairs that count. False: the visitor does not want more.
  bool visit();

  // Of two that the sweep line cuts at one time: are they on one line? It was told when the later one began, as long as
  // each bundle was set in which a segment begins that is not alone. No comparison.
  bool on_one_line(std::uint32_t i, std::uint32_t j) const { return line_of_[i] == line_of_[j]; }

 private:
  static constexpr std::uint32_t nowhere = no_segment;
  struct Member {
    std::uint32_t segment, group;
    std::uint32_t back = nowhere, on = nowhere;  // its lines before and after the point, numbered
  };
  using Members = std::span<const Member>;
  struct Key {  // of one that passes: its line and its group, or the other way round
    std::uint32_t major, minor, segment;
    friend auto operator<=>(const Key&, const Key&) = default;
  };

  Member member(std::uint32_t i) const { return {i, options_.groups.empty() ? i : options_.groups[i]}; }
  void read_row(std::span<const std::uint32_t> row, const Point2* p);
  void put_in_order_after();
  void join(const Member& last, const Member& next, std::size_t run);
  Sign turn(const Point2& p, const Point2& q, const Point2& r);
  bool is_lower(std::uint32_t i, std::uint32_t j);

  void set_keys();
  bool give_crossings();
  bool give_overlaps(bool with_passing, bool among_begins);
  bool give_within(Members in_groups);
  bool give_between(Members some, Members in_groups);
  bool give(const Member& x, const Member& y);

  const Segments& segments_;
  const SetOptions& options_;
  const SegmentsVisitor& visit_;
  Cost& cost_;
  Point2 point_{};
  std::vector<Member> row_;      // as given
  std::vector<Member> passing_;  // in order just after the point; then those aside
  std::vector<Member> begins_;   // in order just after the point
  std::vector<Member> ending_;   // all of which an end is the point: those too
  std::vector<std::uint32_t> after_;
  std::vector<std::uint32_t> line_of_;  // of each segment: the number of one that is on its line, itself at first
  std::size_t in_row_ = 0;              // so many of passing_ are of the row
  std::uint32_t lines_ = 0;             // so many numbers are taken
  std::vector<Key> keys_, swapped_;
  std::vector<std::size_t> cells_;  // of keys_: where major or minor change; and the end
};

}  // namespace sunder::planar
