#include <sunder/picture/painter.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace sunder::picture {

namespace {

constexpr std::size_t too_many = 20000;

struct Plane {
  double x = 0, y = 0, depth = 0, offset = 0;

  double height(const Seen& p) const { return x * p.x + y * p.y + depth * p.depth - offset; }
};

// The plane of a piece; its normal, of length one, points towards the viewer. Zero for a line.
Plane plane_of(const std::vector<Seen>& c) {
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

// A piece, with what is asked of it again and again.
struct Item {
  Piece piece;
  Plane plane;
  double left = 0, right = 0, top = 0, bottom = 0, middle = 0;

  explicit Item(Piece p) : piece(std::move(p)), plane(plane_of(piece.corners)) {
    const Seen& first = piece.corners.front();
    left = right = first.x;
    top = bottom = first.y;
    for (const Seen& c : piece.corners) {
      left = std::min(left, c.x);
      right = std::max(right, c.x);
      top = std::min(top, c.y);
      bottom = std::max(bottom, c.y);
      middle += c.depth / static_cast<double>(piece.corners.size());
    }
  }

  bool is_line() const { return piece.corners.size() < 3; }
};

enum class Order { none, first_behind, second_behind, cross };

class Painter {
 public:
  explicit Painter(double tolerance) : tolerance_(tolerance) {}

  std::vector<Piece> order(std::vector<Piece> pieces) {
    cut_where_crossing(std::move(pieces));
    return sorted();
  }

 private:
  // Every piece is compared with those that are in order already, and cut by the plane of one that it crosses.
  void cut_where_crossing(std::vector<Piece> todo) {
    while (!todo.empty()) {
      const Item item(std::move(todo.back()));
      todo.pop_back();
      const auto crossed = std::find_if(items_.begin(), items_.end(),
                                        [&](const Item& other) { return compare(item, other) == Order::cross; });
      if (crossed == items_.end()) {
        items_.push_back(item);
      } else {
        todo.push_back(half(item.piece, crossed->plane, -1));
        todo.push_back(half(item.piece, crossed->plane, 1));
      }
    }
  }

  // Farther ones first where the order is free, or runs in a circle.
  std::vector<Piece> sorted() {
    const std::size_t n = items_.size();
    std::vector<std::vector<std::size_t>> hidden_by(n);
    std::vector<std::size_t> waiting_for(n, 0), by_depth(n);
    for (std::size_t i = 0; i < n; ++i) {
      by_depth[i] = i;
      for (std::size_t j = 0; j < i; ++j) {
        const Order order = compare(items_[i], items_[j]);
        if (order == Order::none) continue;
        const bool i_behind = order == Order::first_behind;
        hidden_by[i_behind ? i : j].push_back(i_behind ? j : i);
        ++waiting_for[i_behind ? j : i];
      }
    }
    const auto nearer = [&](std::size_t i, std::size_t j) {
      return items_[i].middle != items_[j].middle ? items_[i].middle > items_[j].middle : i > j;
    };
    std::sort(by_depth.begin(), by_depth.end(), nearer);
    std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(nearer)> free(nearer);
    for (std::size_t i = 0; i < n; ++i) {
      if (waiting_for[i] == 0) free.push(i);
    }
    std::vector<Piece> out;
    std::vector<bool> done(n, false);
    while (out.size() < n) {
      std::size_t next = 0;
      if (!free.empty()) {
        next = free.top();
        free.pop();
      } else {
        while (done[by_depth.back()]) by_depth.pop_back();
        next = by_depth.back();
      }
      if (done[next]) continue;
      done[next] = true;
      for (const std::size_t j : hidden_by[next]) {
        if (--waiting_for[j] == 0) free.push(j);
      }
      out.push_back(std::move(items_[next].piece));
    }
    return out;
  }

  Order compare(const Item& a, const Item& b) const {
    if (a.piece.part == b.piece.part || a.right < b.left + tolerance_ || b.right < a.left + tolerance_ ||
        a.bottom < b.top + tolerance_ || b.bottom < a.top + tolerance_) {
      return Order::none;
    }
    if (parted(a.piece.corners, b.piece.corners) || parted(b.piece.corners, a.piece.corners)) return Order::none;
    if (a.is_line() || b.is_line()) return a.middle < b.middle ? Order::first_behind : Order::second_behind;
    if (is_on_side(a, b.plane, -1) || is_on_side(b, a.plane, 1)) return Order::first_behind;
    if (is_on_side(a, b.plane, 1) || is_on_side(b, a.plane, -1)) return Order::second_behind;
    return Order::cross;
  }

  // Are the two apart on the picture, along the normal of one of the first one's edges?
  bool parted(const std::vector<Seen>& a, const std::vector<Seen>& b) const {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Seen &p = a[i], &q = a[(i + 1) % a.size()];
      const double nx = p.y - q.y, ny = q.x - p.x, length = std::sqrt(nx * nx + ny * ny);
      if (length == 0) continue;
      const auto range = [&](const std::vector<Seen>& corners) {
        double low = 0, high = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const double h = ((corners[k].x - p.x) * nx + (corners[k].y - p.y) * ny) / length;
          low = k == 0 ? h : std::min(low, h);
          high = k == 0 ? h : std::max(high, h);
        }
        return std::pair(low, high);
      };
      const auto [low_a, high_a] = range(a);
      const auto [low_b, high_b] = range(b);
      if (high_a < low_b + tolerance_ || high_b < low_a + tolerance_) return true;
    }
    return false;
  }

  bool is_on_side(const Item& item, const Plane& plane, double side) const {
    return std::all_of(item.piece.corners.begin(), item.piece.corners.end(),
                       [&](const Seen& p) { return side * plane.height(p) > -tolerance_; });
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
  std::vector<Item> items_;  // no two of them cross
};

}  // namespace

std::vector<Piece> in_painters_order(std::vector<Piece> pieces) {
  double size = 0;
  for (const Piece& piece : pieces) {
    for (const Seen& p : piece.corners) size = std::max({size, std::fabs(p.x), std::fabs(p.y), std::fabs(p.depth)});
  }
  if (pieces.size() <= too_many && std::isfinite(size)) return Painter(1e-6 * size).order(std::move(pieces));
  std::vector<std::pair<double, std::size_t>> by_depth;
  for (std::size_t i = 0; i < pieces.size(); ++i) by_depth.emplace_back(Item(pieces[i]).middle, i);
  std::sort(by_depth.begin(), by_depth.end());
  std::vector<Piece> sorted;
  for (const auto& [depth, i] : by_depth) sorted.push_back(std::move(pieces[i]));
  return sorted;
}

}  // namespace sunder::picture
