#include <sunder/picture/painter.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace sunder::picture {

namespace {

constexpr std::size_t too_many = 20000;

// Its normal points towards the viewer. Zero for a line.
struct Plane {
  Seen normal;
  double offset;

  explicit Plane(const std::vector<Seen>& corners) : normal(normal_of(corners)), offset(0) {
    if (normal.z < 0) normal = {-normal.x, -normal.y, -normal.z};
    offset = height(corners[0]);
  }
  double height(const Seen& p) const { return dot(normal, p) - offset; }
};

// A piece, with what is asked of it again and again.
struct Item {
  Piece piece;
  Plane plane;
  Box2 box;           // on the picture, less a margin: boxes that only touch do not hide each other
  double middle = 0;  // its depth

  Item(Piece p, double margin) : piece(std::move(p)), plane(piece.corners) {
    box = at(piece.corners.front());
    for (const Seen& c : piece.corners) {
      box = hull(box, at(c));
      middle += c.z / static_cast<double>(piece.corners.size());
    }
    box = {{box.low.x + margin, box.low.y + margin}, {box.high.x - margin, box.high.y - margin}};
  }

  static Box2 at(const Seen& p) { return {{p.x, p.y}, {p.x, p.y}}; }
  bool is_line() const { return piece.corners.size() < 3; }
};

enum class Order { none, first_behind, second_behind, cross };

class Painter {
 public:
  // compares: else the order is that of the middles.
  Painter(double tolerance, bool compares) : tolerance_(tolerance), compares_(compares) {}

  std::vector<Piece> order(std::vector<Piece> pieces) {
    if (compares_) {
      cut_where_crossing(std::move(pieces));
    } else {
      for (Piece& piece : pieces) items_.emplace_back(std::move(piece), 0);
    }
    return sorted();
  }

 private:
  // Every piece is compared with those that are in order already, and cut by the plane of one that it crosses.
  void cut_where_crossing(std::vector<Piece> todo) {
    while (!todo.empty()) {
      const Item item(std::move(todo.back()), tolerance_ / 2);
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
    std::vector<std::vector<std::size_t>> behind(n);  // of each, those that it hides
    std::vector<std::size_t> by_depth(n);
    for (std::size_t i = 0; i < n; ++i) {
      by_depth[i] = i;
      for (std::size_t j = 0; j < i && compares_; ++j) {
        const Order order = compare(items_[i], items_[j]);
        if (order == Order::first_behind) behind[j].push_back(i);
        if (order == Order::second_behind) behind[i].push_back(j);
      }
    }
    std::sort(by_depth.begin(), by_depth.end(), [&](std::size_t i, std::size_t j) {
      return items_[i].middle != items_[j].middle ? items_[i].middle < items_[j].middle : i < j;
    });
    // Depth first: each after all that it hides.
    std::vector<Piece> out;
    std::vector<bool> begun(n, false), done(n, false);
    std::vector<std::size_t> path;
    for (const std::size_t first : by_depth) {
      for (path.push_back(first); !path.empty();) {
        const std::size_t k = path.back();
        if (begun[k]) {
          path.pop_back();
          if (!done[k]) out.push_back(std::move(items_[k].piece));
          done[k] = true;
          continue;
        }
        begun[k] = true;
        std::copy_if(behind[k].begin(), behind[k].end(), std::back_inserter(path), [&](auto j) { return !begun[j]; });
      }
    }
    return out;
  }

  Order compare(const Item& a, const Item& b) const {
    if (a.piece.part == b.piece.part || !meet(a.box, b.box)) return Order::none;
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
      const double length = std::hypot(p.y - q.y, q.x - p.x);
      if (length == 0) continue;
      const auto along = [&](const Seen& r) {
        return ((r.x - p.x) * (p.y - q.y) + (r.y - p.y) * (q.x - p.x)) / length;
      };
      const auto [low_a, high_a] = std::ranges::minmax(a, {}, along);
      const auto [low_b, high_b] = std::ranges::minmax(b, {}, along);
      if (along(high_a) < along(low_b) + tolerance_ || along(high_b) < along(low_a) + tolerance_) return true;
    }
    return false;
  }

  bool is_on_side(const Item& item, const Plane& plane, double side) const {
    return std::all_of(item.piece.corners.begin(), item.piece.corners.end(),
                       [&](const Seen& p) { return side * plane.height(p) > -tolerance_; });
  }

  // What is on one side (1: before, -1: behind) of a plane that the piece crosses.
  static Piece half(const Piece& piece, const Plane& plane, double side) {
    Piece out{piece.body, piece.part, piece.light, {}, {}, true};
    const auto push = [&](const Seen& corner, bool outline) {
      out.corners.push_back(corner);
      out.outline.push_back(outline);
    };
    const std::size_t n = piece.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Seen &p = piece.corners[i], &q = piece.corners[(i + 1) % n];
      const double hp = side * plane.height(p), hq = side * plane.height(q), t = hp / (hp - hq);
      const Seen between{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)};
      if (hp >= 0) push(p, piece.outline[i]);
      if (hp >= 0 && hq < 0) push(between, false);
      if (hp < 0 && hq > 0) push(between, piece.outline[i]);
    }
    return out;
  }

  double tolerance_;
  bool compares_;
  std::vector<Item> items_;  // no two of them cross
};

}  // namespace

Seen normal_of(const std::vector<Seen>& corners) {
  Seen sum{0, 0, 0};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Seen n = cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
  }
  const double length = std::sqrt(dot(sum, sum)), scale = length > 0 ? 1 / length : 0;
  return {sum.x * scale, sum.y * scale, sum.z * scale};
}

std::vector<Piece> in_painters_order(std::vector<Piece> pieces) {
  double size = 0;
  for (const Piece& piece : pieces) {
    for (const Seen& p : piece.corners) size = std::max({size, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  const bool compares = pieces.size() <= too_many && std::isfinite(size);
  return Painter(1e-6 * size, compares).order(std::move(pieces));
}

}  // namespace sunder::picture
