#include <sunder/planar/segments/contact_bundle.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <numeric>

namespace sunder::planar {

ContactBundle::ContactBundle(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit,
                             Cost& cost)
    : segments_(segments), options_(options), visit_(visit), cost_(cost), line_of_(segments.size()) {
  std::iota(line_of_.begin(), line_of_.end(), 0u);
}

void ContactBundle::set(std::span<const std::uint32_t> row, std::span<const std::uint32_t> begins,
                        std::span<const std::uint32_t> points, const Point2* p) {
  if (p != nullptr) point_ = *p;
  begins_.clear();
  ending_.clear();
  for (const std::uint32_t i : begins) begins_.push_back(member(i));
  for (const std::uint32_t i : points) ending_.push_back(member(i));
  read_row(row, p);
  put_in_order_after();
  ending_.insert(ending_.end(), begins_.begin(), begins_.end());
}

void ContactBundle::read_row(std::span<const std::uint32_t> row, const Point2* p) {
  row_.clear();
  passing_.clear();
  lines_ = 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Segment& s = segments_[row[k]];
    if (k > 0 && !on_one_line(row[k - 1], row[k])) ++lines_;
    row_.push_back(member(row[k]));
    row_.back().back = lines_;
    (p != nullptr && s.b == *p ? ending_ : passing_).push_back(row_.back());
  }
  in_row_ = passing_.size();
  if (lines_ == 0) return;
  // The lines change their order at the point; those on one line do not.
  std::reverse(passing_.begin(), passing_.end());
  for (std::size_t begin = 0, end; begin < passing_.size(); begin = end) {
    for (end = begin + 1; end < passing_.size() && passing_[end].back == passing_[begin].back;) ++end;
    std::reverse(passing_.begin() + static_cast<std::ptrdiff_t>(begin),
                 passing_.begin() + static_cast<std::ptrdiff_t>(end));
  }
}

void ContactBundle::put_in_order_after() {
  std::sort(begins_.begin(), begins_.end(),
            [&](const Member& x, const Member& y) { return is_lower(x.segment, y.segment); });
  after_.clear();
  const Member* last = nullptr;
  std::size_t run = 0;  // where the last line begins in after_
  const auto append = [&](Member& next) {
    if (last != nullptr) {
      const bool both_pass = last->back != nowhere && next.back != nowhere;
      const bool one_line = both_pass
                                ? last->back == next.back
                                : turn(point_, segments_[last->segment].b, segments_[next.segment].b) == Sign::zero;
      lines_ += one_line ? 0 : 1;
      if (!one_line) run = after_.size();
      if (one_line && !both_pass) join(*last, next, run);
    }
    next.on = lines_;
    after_.push_back(next.segment);
    last = &next;
  };
  ++lines_;
  auto passing = passing_.begin();
  for (Member& m : begins_) {
    const auto above = std::partition_point(passing, passing_.end(),
                                            [&](const Member& other) { return is_lower(other.segment, m.segment); });
    for (; passing != above; ++passing) append(*passing);
    append(m);
  }
  for (; passing != passing_.end(); ++passing) append(*passing);
}

// One of the two begins: those of the run that do are on the line of the other one.
void ContactBundle::join(const Member& last, const Member& next, std::size_t run) {
  if (next.back == nowhere) {
    line_of_[next.segment] = line_of_[last.segment];
    return;
  }
  for (std::size_t k = run; k < after_.size(); ++k) line_of_[after_[k]] = line_of_[next.segment];
}

void ContactBundle::add_aside(std::span<const std::uint32_t> segments) {
  const Segment& s = segments_[segments[0]];
  // Where it is on a line of others that go back, or begin.
  const auto before = std::partition_point(row_.begin(), row_.end(), [&](const Member& m) {
    return turn(point_, s.a, segments_[m.segment].a) == Sign::positive;
  });
  const auto after = std::partition_point(begins_.begin(), begins_.end(), [&](const Member& m) {
    return turn(point_, segments_[m.segment].b, s.b) == Sign::positive;
  });
  const bool goes_back_with = before != row_.end() && turn(point_, s.a, segments_[before->segment].a) == Sign::zero;
  const bool goes_on_with = after != begins_.end() && turn(point_, s.b, segments_[after->segment].b) == Sign::zero;
  if (goes_on_with) {
    for (auto m = after; m != begins_.end() && m->on == after->on; ++m) line_of_[m->segment] = line_of_[segments[0]];
  }
  ++lines_;
  for (const std::uint32_t i : segments) {
    passing_.push_back(member(i));
    passing_.back().back = goes_back_with ? before->back : lines_;
    passing_.back().on = goes_on_with ? after->on : lines_;
  }
}

bool ContactBundle::visit() {
  if (!give_crossings()) return false;
  if (ending_.empty()) return true;
  const auto by_group = [](const Member& x, const Member& y) { return x.group < y.group; };
  const bool touches = counts(ContactKind::touch, options_.allowed);
  const bool shared_ends = counts(ContactKind::shared_endpoint, options_.allowed);
  if (touches) {
    if (!options_.groups.empty()) std::sort(passing_.begin(), passing_.end(), by_group);
    if (!give_between(ending_, passing_)) return false;
  }
  if (shared_ends) {
    if (!options_.groups.empty()) std::sort(ending_.begin(), ending_.end(), by_group);
    if (!give_within(ending_)) return false;
  }
  return (touches && shared_ends) || give_overlaps(!touches, !shared_ends);
}

// All that passes crosses but on one line: line after line, or group after group, whichever are fewer.
void ContactBundle::set_keys() {
  const auto majors = [](const std::vector<Key>& keys) {
    std::size_t count = 1;
    for (std::size_t k = 1; k < keys.size(); ++k) count += keys[k - 1].major != keys[k].major;
    return count;
  };
  keys_.clear();
  swapped_.clear();
  for (std::size_t k = 0; k < in_row_; ++k) keys_.push_back({passing_[k].on, passing_[k].group, passing_[k].segment});
  std::sort(keys_.begin(), keys_.end());
  if (!options_.groups.empty()) {
    for (const Key& key : keys_) swapped_.push_back({key.minor, key.major, key.segment});
    std::sort(swapped_.begin(), swapped_.end());
    if (majors(swapped_) < majors(keys_)) keys_.swap(swapped_);
  }
  cells_.clear();
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    if (k == 0 || keys_[k - 1].major != keys_[k].major || keys_[k - 1].minor != keys_[k].minor) cells_.push_back(k);
  }
  cells_.push_back(keys_.size());
}

bool ContactBundle::give_crossings() {
  if (in_row_ < 2 || passing_[0].on == passing_[in_row_ - 1].on) return true;  // all on one line
  set_keys();
  const auto key = [&](std::size_t cell) -> const Key& { return keys_[cells_[cell]]; };
  std::size_t others = 0;  // cells of a lower major
  for (std::size_t c = 1; c + 1 < cells_.size(); ++c) {
    if (key(c - 1).major != key(c).major) others = c;
    for (std::size_t d = 0; d < others; ++d) {
      ++cost_.probes;
      if (key(c).minor == key(d).minor) continue;
      for (std::size_t k = cells_[c]; k < cells_[c + 1]; ++k) {
        for (std::size_t l = cells_[d]; l < cells_[d + 1]; ++l) {
          const auto [low, high] = std::minmax(keys_[k].segment, keys_[l].segment);
          if (!visit_({low, high, ContactKind::crossing})) return false;
        }
      }
    }
  }
  return true;
}

// Those on one line with one that begins.
bool ContactBundle::give_overlaps(bool with_passing, bool among_begins) {
  const auto by_line = [](const Member& x, const Member& y) { return x.on != y.on ? x.on < y.on : x.group < y.group; };
  std::sort(begins_.begin(), begins_.end(), by_line);
  if (with_passing) std::sort(passing_.begin(), passing_.end(), by_line);
  const auto by_line_alone = [](const Member& x, const Member& y) { return x.on < y.on; };
  for (auto begin = begins_.begin(); begin != begins_.end();) {
    const auto end = std::upper_bound(begin, begins_.end(), *begin, by_line_alone);
    const Members begins(begin, end);
    if (with_passing) {
      const auto [first, last] = std::equal_range(passing_.begin(), passing_.end(), *begin, by_line_alone);
      if (!give_between(begins, Members(first, last))) return false;
    }
    if (among_begins && !give_within(begins)) return false;
    begin = end;
  }
  return true;
}

bool ContactBundle::give_within(Members in_groups) {
  std::size_t others = 0;  // of a lower group
  for (std::size_t l = 1; l < in_groups.size(); ++l) {
    if (in_groups[l - 1].group != in_groups[l].group) others = l;
    for (std::size_t k = 0; k < others; ++k) {
      if (!give(in_groups[k], in_groups[l])) return false;
    }
  }
  return true;
}

bool ContactBundle::give_between(Members some, Members in_groups) {
  const auto by_group = [](const Member& x, const Member& y) { return x.group < y.group; };
  for (const Member& x : some) {
    if (options_.groups.empty()) {
      if (!std::all_of(in_groups.begin(), in_groups.end(), [&](const Member& y) { return give(x, y); })) return false;
      continue;
    }
    const auto own = std::equal_range(in_groups.begin(), in_groups.end(), x, by_group);
    for (auto y = in_groups.begin(); y != in_groups.end();) {
      if (y == own.first && own.first != own.second) {
        y = own.second;
        continue;
      }
      if (!give(x, *y)) return false;
      ++y;
    }
  }
  return true;
}

bool ContactBundle::give(const Member& x, const Member& y) {
  ++cost_.probes;
  if (x.back == y.back && x.back != nowhere) return true;  // an overlap given before
  const auto passes = [](const Member& m) { return m.back != nowhere && m.on != nowhere; };
  const ContactKind kind = x.on == y.on && x.on != nowhere ? ContactKind::overlap
                           : passes(x) || passes(y)        ? ContactKind::touch
                                                           : ContactKind::shared_endpoint;
  const auto [low, high] = std::minmax(x.segment, y.segment);
  return visit_({low, high, kind});
}

Sign ContactBundle::turn(const Point2& p, const Point2& q, const Point2& r) {
  ++cost_.probes;
  return orient_2d(p, q, r);
}

// Of two that go on.
bool ContactBundle::is_lower(std::uint32_t i, std::uint32_t j) {
  const Sign side = turn(point_, segments_[i].b, segments_[j].b);
  return side == Sign::positive || (side == Sign::zero && i < j);
}

}  // namespace sunder::planar
