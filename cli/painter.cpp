#include <cli/painter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder::cli {

namespace {

constexpr std::size_t too_many = 20000;
constexpr std::size_t candidates = 24;

struct Plane {
  double x = 0, y = 0, depth = 0, offset = 0;

  double height(const Seen& p) const { return x * p.x + y * p.y + depth * p.depth - offset; }
};

// The plane of a piece of at least three corners; its normal, of length one, points towards the viewer.
Plane plane_of(const Piece& piece) {
  const std::vector<Seen>& c = piece.corners;
  Plane n;
  for (std::size_t i = 1; i + 1 < c.size(); ++i) {
    const Seen u{c[i].x - c[0].x, c[i].y - c[0].y, c[i].depth - c[0].depth};
    const Seen v{c[i + 1].x - c[0].x, c[i + 1].y - c[0].y, c[i + 1].depth - c[0].depth};
    n.x += u.y * v.depth - u.depth * v.y;
    n.y += u.depth * v.x - u.x * v.depth;
    n.depth += u.x * v.y - u.y * v.x;
  }
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.depth * n.depth);
  const double scale = length > 0 ? (n.depth < 0 ? -1 : 1) / length : 0;
  n = {n.x * scale, n.y * scale, n.depth * scale, 0};
  n.offset = n.height(c[0]);
  return n;
}

double middle_depth(const Piece& piece) {
  double sum = 0;
  for (const Seen& p : piece.corners) sum += p.depth;
  return sum / static_cast<double>(piece.corners.size());
}

enum class Where { behind, on, before, across };

class Painter {
 public:
  explicit Painter(double tolerance) : tolerance_(tolerance) {}

  std::vector<Piece> order(std::vector<Piece> all) {
    todo_.push_back({std::move(all), false});
    while (!todo_.empty()) {
      Group group = std::move(todo_.back());
      todo_.pop_back();
      if (group.ordered || is_one_part(group.pieces)) {
        std::move(group.pieces.begin(), group.pieces.end(), std::back_inserter(done_));
      } else {
        divide(std::move(group.pieces));
      }
    }
    return std::move(done_);
  }

 private:
  struct Group {
    std::vector<Piece> pieces;
    bool ordered;
  };

  static bool is_one_part(const std::vector<Piece>& pieces) {
    return std::all_of(pieces.begin(), pieces.end(), [&](const Piece& p) { return p.part == pieces.front().part; });
  }

  Where where(const Piece& piece, const Plane& plane) const {
    if (piece.corners.size() < 3) {  // not worth a cut
      double sum = 0;
      for (const Seen& p : piece.corners) sum += plane.height(p);
      return sum < 0 ? Where::behind : Where::before;
    }
    bool behind = false, before = false;
    for (const Seen& p : piece.corners) {
      const double h = plane.height(p);
      behind = behind || h < -tolerance_;
      before = before || h > tolerance_;
    }
    return behind ? (before ? Where::across : Where::behind) : before ? Where::before : Where::on;
  }

  // The piece whose plane cuts few others and leaves little on the larger side; the last one where only lines are left.
  std::size_t best_divider(const std::vector<Piece>& pieces) const {
    std::size_t best = pieces.size() - 1;
    double least = std::numeric_limits<double>::infinity();
    const std::size_t step = std::max<std::size_t>(1, pieces.size() / candidates);
    for (std::size_t i = 0; i < pieces.size(); i += step) {
      if (pieces[i].corners.size() < 3) continue;
      const Plane plane = plane_of(pieces[i]);
      std::size_t behind = 0, before = 0, across = 0;
      for (const Piece& piece : pieces) {
        const Where w = where(piece, plane);
        behind += w == Where::behind;
        before += w == Where::before;
        across += w == Where::across;
      }
      const double cost = 2 * static_cast<double>(across) + 0.25 * static_cast<double>(std::max(behind, before));
      if (cost < least) {
        least = cost;
        best = i;
      }
    }
    return best;
  }

  void divide(std::vector<Piece> pieces) {
    const std::size_t divider = best_divider(pieces);
    const Plane plane = plane_of(pieces[divider]);
    Group behind{{}, false}, on{{}, true}, before{{}, false};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      switch (i == divider ? Where::on : where(pieces[i], plane)) {
        case Where::behind: behind.pieces.push_back(std::move(pieces[i])); break;
        case Where::on: on.pieces.push_back(std::move(pieces[i])); break;
        case Where::before: before.pieces.push_back(std::move(pieces[i])); break;
        case Where::across:
          behind.pieces.push_back(half(pieces[i], plane, -1));
          before.pieces.push_back(half(pieces[i], plane, 1));
          break;
      }
    }
    for (Group* group : {&before, &on, &behind}) {  // the last is taken first
      if (!group->pieces.empty()) todo_.push_back(std::move(*group));
    }
  }

  // What is on one side (1: before, -1: behind) of a plane that the piece crosses.
  static Piece half(const Piece& piece, const Plane& plane, double side) {
    Piece out{piece.body, piece.part, piece.light, {}, {}};
    const std::size_t n = piece.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Seen &p = piece.corners[i], &q = piece.corners[(i + 1) % n];
      const double hp = side * plane.height(p), hq = side * plane.height(q);
      const double t = hp / (hp - hq);
      const Seen between{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.depth + t * (q.depth - p.depth)};
      if (hp >= 0) {
        out.corners.push_back(p);
        out.edges.push_back(piece.edges[i]);
        if (hq < 0) {
          out.corners.push_back(between);
          out.edges.push_back(Edge::cut);
        }
      } else if (hq > 0) {
        out.corners.push_back(between);
        out.edges.push_back(piece.edges[i]);
      }
    }
    return out;
  }

  double tolerance_;
  std::vector<Group> todo_;  // a stack, the farthest on top
  std::vector<Piece> done_;
};

}  // namespace

std::vector<Piece> in_painters_order(std::vector<Piece> pieces) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& p, const Piece& q) { return middle_depth(p) < middle_depth(q); });
  double size = 0;
  for (const Piece& piece : pieces) {
    for (const Seen& p : piece.corners) size = std::max({size, std::fabs(p.x), std::fabs(p.y), std::fabs(p.depth)});
  }
  if (pieces.size() > too_many || !std::isfinite(size)) return pieces;
  return Painter(1e-6 * size).order(std::move(pieces));
}

}  // namespace sunder::cli
