#include <sunder/planar/polygons/polygon_mend.h>

#include <sunder/number/sign.h>
#include <sunder/planar/object/segments.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>

namespace sunder::planar {

namespace {

// Does the way from a by b to c turn back at b? Requires that neighbours differ.
bool turns_back(const Point2& a, const Point2& b, const Point2& c) {
  return orient_2d(a, b, c) == Sign::zero && lexicographically_less(a, b) == lexicographically_less(c, b);
}

// The last vertex, where it repeats the one before or is between two others that turn back there.
bool drop_last(std::vector<Point2>& ring, std::size_t first, const Point2& before, const Point2& last,
               const Point2& after, MendedRings& mended) {
  if (ring.size() - first >= 2 && last == after) {
    ++mended.repeated;
    return true;
  }
  if (ring.size() - first < 3 || !turns_back(before, last, after)) return false;
  ++mended.spikes;
  return true;
}

// Cuts spikes off a ring whose last vertex does not repeat the first; fewer than three vertices may be left.
void cut_spikes(std::vector<Point2>& ring, MendedRings& mended) {
  std::vector<Point2> kept;
  for (const Point2& p : ring) {
    while (kept.size() >= 2 && kept.back() != p && turns_back(kept[kept.size() - 2], kept.back(), p)) {
      kept.pop_back();
      ++mended.spikes;
    }
    if (kept.empty() || kept.back() != p) {
      kept.push_back(p);
    } else {
      ++mended.repeated;
    }
  }
  // Where the end meets the beginning.
  std::size_t first = 0;
  for (bool changed = true; changed;) {
    changed = false;
    const std::size_t n = kept.size();
    if (n - first < 2) break;
    if (drop_last(kept, first, kept[n - 2], kept[n - 1], kept[first], mended)) {
      kept.pop_back();
      changed = true;
    } else if (n - first >= 3 && turns_back(kept[n - 1], kept[first], kept[first + 1])) {
      ++first;
      ++mended.spikes;
      changed = true;
    }
  }
  ring.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

}  // namespace

MendedRings& MendedRings::operator+=(const MendedRings& other) {
  closed += other.closed;
  spikes += other.spikes;
  repeated += other.repeated;
  left_out += other.left_out;
  return *this;
}

void leave_out_repeated(std::vector<Point2>& ring) {
  const bool closed = ring.size() > 1 && ring.front() == ring.back();
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (!closed && ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

MendedRings mend(PolygonRings& rings) {
  MendedRings mended;
  PolygonRings kept;
  for (std::vector<Point2>& ring : rings) {
    if (ring.size() > 1 && ring.front() == ring.back()) {
      ring.pop_back();
    } else {
      ++mended.closed;
    }
    cut_spikes(ring, mended);
    if (ring.size() >= 3) {
      ring.push_back(ring.front());
      kept.push_back(std::move(ring));
    } else if (&ring == &rings.front()) {
      mended.left_out += rings.size();
      kept.clear();
      break;
    } else {
      ++mended.left_out;
    }
  }
  rings = std::move(kept);
  return mended;
}

}  // namespace sunder::planar
