#include <sunder/base/interruption.h>
#include <sunder/polytope/hull/double_description_internal.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr std::size_t most_width = 7;

// Integers below 2^59: products, and sums of seven of these, fit in 128 bits.
struct Small {
  using Number = std::int64_t;
  __extension__ using Wide = __int128;

  template <class Any>
  static bool fits(const Any& x) {
    constexpr std::int64_t limit = std::int64_t{1} << 59;
    return -limit < x && x < limit;
  }
  static Wide common_factor(Wide x, Wide y) {
    while (y != 0 && !(fits(x) && fits(y))) x = std::exchange(y, x % y);
    if (y == 0) return x < 0 ? -x : x;
    return std::gcd(static_cast<Number>(x), static_cast<Number>(y));
  }
};

struct Large {
  using Number = Integer;
  using Wide = Integer;

  static bool fits(const Integer&) { return true; }
  static Wide common_factor(const Wide& x, const Wide& y) { return gcd(x, y); }
};

template <class Kind>
class Cone {
 public:
  using Number = typename Kind::Number;
  using Wide = typename Kind::Wide;
  using Vector = std::array<Number, most_width>;

  Cone(std::size_t width, std::span<const Dyadic> given) : width_(width), given_(given), rows_(given.size() / width) {}

  // False where a number is too large, or patience ends.
  bool solve() {
    std::vector<std::size_t> others;
    begin(others);
    for (const std::size_t row : others) {
      if (!lines_.empty() || !fits_ || is_out_of_patience()) break;
      cut(row);
    }
    return fits_ && !is_out_of_patience();
  }

  ConeRays result() const {
    ConeRays result;
    result.has_lines = !lines_.empty();
    result.signs = signs_;
    result.looks = looks_;
    if (result.has_lines) return result;
    std::vector<std::uint32_t> number(rays_.size());
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      if (rays_[k].on.empty()) continue;
      number[k] = static_cast<std::uint32_t>(result.rays.size());
      result.rays.emplace_back(rays_[k].way.begin(), rays_[k].way.begin() + static_cast<std::ptrdiff_t>(width_));
      result.on.push_back(rays_[k].on);
      result.next.push_back(rays_[k].next);
    }
    for (auto& next : result.next) {
      for (std::uint32_t& k : next) k = number[k];
    }
    return result;
  }

 private:
  struct Ray {
    Vector way{};
    Bits on;                          // the rows on whose boundary it is, so far; empty where the ray is gone
    std::vector<std::uint32_t> next;  // its neighbours
  };

  // A sign takes as long as some 64 looks. Simplices take some four times as long a dimension.
  bool is_out_of_patience() const {
    return 64 * signs_ + looks_ > (std::uint64_t{1024} << (2 * width_)) + 8192 * extra_;
  }

  // The row as integers without a common factor: times a positive number.
  void load(std::size_t row) {
    const auto given = given_.subspan(row * width_, width_);
    std::optional<std::int64_t> unit;
    for (const Dyadic& x : given) {
      if (x.sign() != Sign::zero) unit = unit ? std::min(*unit, x.exponent()) : x.exponent();
    }
    std::array<Integer, most_width> integers;
    Integer factor = 0;
    for (std::size_t c = 0; c < width_; ++c) {
      if (given[c].sign() == Sign::zero) continue;
      integers[c] = mantissa_of(given[c]) << static_cast<unsigned long>(given[c].exponent() - *unit);
      if (factor != 1) factor = gcd(factor, integers[c]);
    }
    for (std::size_t c = 0; c < width_; ++c) {
      if (factor > 1) integers[c] /= factor;
      fits_ = fits_ && Kind::fits(integers[c]);
      if (fits_) rows_[row][c] = static_cast<Number>(integers[c]);
    }
  }

  Wide product(std::size_t row, const Vector& x) const {
    Wide sum = 0;
    for (std::size_t c = 0; c < width_; ++c) sum += Wide(rows_[row][c]) * x[c];
    return sum;
  }

  // Of the numbers a > 0 and b, a x - b y, less common factors.
  Vector combined(Wide a, const Vector& x, Wide b, const Vector& y) {
    const Wide common = Kind::common_factor(a, b);
    a /= common;
    b /= common;
    fits_ = fits_ && Kind::fits(a) && Kind::fits(b);
    Vector result{};
    if (!fits_) return result;
    std::array<Wide, most_width> numbers{};
    Wide factor = 0;
    for (std::size_t c = 0; c < width_; ++c) {
      numbers[c] = a * x[c] - b * y[c];
      if (factor != 1) factor = Kind::common_factor(factor, numbers[c]);
    }
    for (std::size_t c = 0; c < width_; ++c) {
      if (factor != 1) numbers[c] /= factor;
      fits_ = fits_ && Kind::fits(numbers[c]);
      if (fits_) result[c] = static_cast<Number>(numbers[c]);
    }
    return result;
  }

  // From all of space to a cone of as many rays as numbers: each row that cuts a line makes it a ray, and moves all
  // that there is along it into its boundary.
  void begin(std::vector<std::size_t>& others) {
    for (std::size_t c = 0; c < width_; ++c) lines_.emplace_back()[c] = 1;
    Bits used = no_bits(rows_.size());
    for (std::size_t row = 0; row < rows_.size() && fits_; ++row) {
      if (!lines_.empty()) load(row);
      const auto cut = std::find_if(lines_.begin(), lines_.end(), [&](const auto& x) { return product(row, x) != 0; });
      if (cut == lines_.end()) {
        others.push_back(row);
        continue;
      }
      Vector line = *cut;
      lines_.erase(cut);
      if (product(row, line) < 0) {
        for (Number& x : line) x = -x;
      }
      const Wide by = product(row, line);
      for (Vector& other : lines_) other = combined(by, other, product(row, other), line);
      for (Ray& ray : rays_) {
        ray.way = combined(by, ray.way, product(row, ray.way), line);
        add(ray.on, row);
      }
      rays_.push_back({line, used, {}});
      add(used, row);
    }
    for (std::uint32_t k = 0; k < rays_.size(); ++k) {
      for (std::uint32_t other = 0; other < rays_.size(); ++other) {
        if (other != k) rays_[k].next.push_back(other);
      }
    }
  }

  void cut(std::size_t row) {
    load(row);
    if (!fits_) return;
    may_be_interrupted(static_cast<std::uint32_t>(rays_.size()));
    values_.assign(rays_.size(), 0);
    broken_.clear();
    bound_.clear();
    for (std::uint32_t k = 0; k < rays_.size(); ++k) {
      if (rays_[k].on.empty()) continue;
      ++signs_;
      values_[k] = product(row, rays_[k].way);
      if (values_[k] < 0) broken_.push_back(k);
      if (values_[k] != 0) continue;
      bound_.push_back(k);
      add(rays_[k].on, row);
      ++extra_;
    }
    if (broken_.empty()) return;
    for (const std::uint32_t k : bound_) {
      std::erase_if(rays_[k].next, [&](std::uint32_t other) { return values_[other] <= 0; });
    }
    for (const std::uint32_t k : broken_) {
      for (std::size_t i = 0; i < rays_[k].next.size(); ++i) {
        const std::uint32_t other = rays_[k].next[i];
        if (values_[other] > 0) bound_.push_back(new_ray(row, k, other));
      }
    }
    for (const std::uint32_t k : broken_) {
      rays_[k] = {};
      free_.push_back(k);
    }
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      may_be_interrupted(static_cast<std::uint32_t>(1 + i));
      for (std::size_t j = 0; j < i; ++j) {
        if (!are_neighbours(bound_[i], bound_[j])) continue;
        rays_[bound_[i]].next.push_back(bound_[j]);
        rays_[bound_[j]].next.push_back(bound_[i]);
      }
    }
  }

  // Where the way from a broken ray to a neighbour that is not meets the boundary of the row.
  std::uint32_t new_ray(std::size_t row, std::uint32_t broken, std::uint32_t kept) {
    Ray ray{combined(values_[kept], rays_[broken].way, values_[broken], rays_[kept].way), rays_[kept].on, {kept}};
    keep_common(ray.on, rays_[broken].on);
    add(ray.on, row);
    std::uint32_t k = static_cast<std::uint32_t>(rays_.size());
    if (free_.empty()) {
      rays_.emplace_back();
    } else {
      k = free_.back();
      free_.pop_back();
    }
    rays_[k] = std::move(ray);
    std::replace(rays_[kept].next.begin(), rays_[kept].next.end(), broken, k);
    return k;
  }

  // Of two rays on the boundary of the last row: is no third one on all half-spaces that both are on?
  bool are_neighbours(std::uint32_t k, std::uint32_t other) {
    ++looks_;
    common_ = rays_[k].on;
    keep_common(common_, rays_[other].on);
    if (size_of(common_) + 2 < width_) return false;
    looks_ += bound_.size();
    return std::none_of(bound_.begin(), bound_.end(), [&](std::uint32_t third) {
      return third != k && third != other && is_within(common_, rays_[third].on);
    });
  }

  std::size_t width_;
  std::span<const Dyadic> given_;
  std::vector<Vector> rows_;
  bool fits_ = true;
  std::vector<Vector> lines_;
  std::vector<Ray> rays_;
  std::vector<std::uint32_t> free_;  // rays that are gone
  std::vector<Wide> values_;         // of the rays, at the last row
  std::vector<std::uint32_t> broken_, bound_;
  Bits common_;
  std::uint64_t signs_ = 0, looks_ = 0, extra_ = 0;
};

template <class Kind>
std::optional<ConeRays> rays_of(std::size_t width, std::span<const Dyadic> rows) {
  Cone<Kind> cone(width, rows);
  return cone.solve() ? std::optional(cone.result()) : std::nullopt;
}

}  // namespace

std::optional<ConeRays> double_description(std::size_t width, std::span<const Dyadic> rows, IntegerKind kind) {
  return kind == IntegerKind::words ? rays_of<Small>(width, rows) : rays_of<Large>(width, rows);
}

}  // namespace sunder::polytope
