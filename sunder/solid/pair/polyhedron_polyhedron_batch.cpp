// The bound of the error of what is asked of all at once. Let u = 2^-53, `size` be the reach of a body (Placed), and e
// a direction of components of at most 1 (1 + 2 u). f = L^T e, rounded, times a coordinate of the body's own box, whose
// middle is within its coordinates and whose half is at most twice them: three products of three factors each, 9 size
// and 18 size, within 8 roundings each; e t: 3 size, within 5; the sum of all, within 5 of 60 size. That is less than
// 1024 u size for each of the two bodies. What underflows, where images are tame, loses less than 2^-800 of a size that
// is zero, and then all is, or at least 2^-250.
#include <sunder/base/contract.h>
#include <sunder/base/threads.h>
#include <sunder/solid/pair/kept_partings.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_batch.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/sure_support.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

constexpr std::size_t chain_length = 64, most_kept = 6;

// Numbers of the bodies of a chain side by side, so that the processor works on several of them at once.
using Column = std::array<double, chain_length>;

struct Side {
  std::array<Column, 9> linear;
  std::array<Column, 3> translation, middle, half;
  Column error;  // infinite where nothing is sure
  std::array<const SearchGraph*, chain_length> graph;
  std::array<bool, chain_length> is_rotated;  // no entry of its linear part is greater than those of a rotation

  void take(std::size_t k, const ConvexPolyhedron& body, const Pose& pose) {
    const Placed placed(body, pose);
    for (std::size_t i = 0; i < 9; ++i) linear[i][k] = placed.pose.linear[i];
    const Point3 &low = placed.graph.low, &high = placed.graph.high;
    for (std::size_t j = 0; j < 3; ++j) {
      const double m = 0.5 * low[j] + 0.5 * high[j];
      translation[j][k] = placed.pose.translation[j];
      middle[j][k] = m;
      half[j][k] = std::max(high[j] - m, m - low[j]) * (1 + 0x1p-51);
    }
    graph[k] = &placed.graph;
    is_rotated[k] = pose.linear_range().greatest <= 1 + 0x1p-20;
    error[k] = placed.tame ? 1024 * 0x1p-53 * placed.size : std::numeric_limits<double>::infinity();
  }

  double image_of_middle(std::size_t i, std::size_t k) const {
    return linear[3 * i][k] * middle[0][k] + linear[3 * i + 1][k] * middle[1][k] + linear[3 * i + 2][k] * middle[2][k] +
           translation[i][k];
  }
  // Of e in the body's frame.
  double pulled(std::size_t j, double x, double y, double z, std::size_t k) const {
    return linear[j][k] * x + linear[3 + j][k] * y + linear[6 + j][k] * z;
  }
};

// Of a chain, which pairs are surely parted by the direction between the middles of their boxes.
class BetweenMiddles {
 public:
  BetweenMiddles(const Side& a, const Side& b, std::size_t count) : a_(a), b_(b) {
    Column gap;
    for (std::size_t k = 0; k < count; ++k) {
      const double x = b.image_of_middle(0, k) - a.image_of_middle(0, k);
      const double y = b.image_of_middle(1, k) - a.image_of_middle(1, k);
      const double z = b.image_of_middle(2, k) - a.image_of_middle(2, k);
      const double greatest = std::max(std::fabs(x), std::max(std::fabs(y), std::fabs(z)));
      const double ex = x / greatest, ey = y / greatest, ez = z / greatest;  // not numbers, where all are zero
      const double way = ex * (b.translation[0][k] - a.translation[0][k]) +
                         ey * (b.translation[1][k] - a.translation[1][k]) +
                         ez * (b.translation[2][k] - a.translation[2][k]);
      double along = way, beside = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        const double of_a = a.pulled(j, ex, ey, ez, k), of_b = b.pulled(j, ex, ey, ez, k);
        of_a_[j][k] = of_a;
        of_b_[j][k] = of_b;
        along += of_b * b.middle[j][k] - of_a * a.middle[j][k];
        beside += std::fabs(of_b) * b.half[j][k] + std::fabs(of_a) * a.half[j][k];
      }
      way_[k] = way;
      gap[k] = along - beside - (a.error[k] + b.error[k]);
    }
    for (std::size_t k = 0; k < count; ++k) parts_boxes_[k] = gap[k] > 0;
  }

  // By the boxes; else by the vertices.
  bool part(std::size_t k) const { return parts_boxes_[k] || part_vertices(k); }

 private:
  bool part_vertices(std::size_t k) const {
    if (!a_.is_rotated[k] || !b_.is_rotated[k]) return false;
    const SearchGraph &p = *a_.graph[k], &q = *b_.graph[k];
    const Point3 f{-of_a_[0][k], -of_a_[1][k], -of_a_[2][k]}, g{of_b_[0][k], of_b_[1][k], of_b_[2][k]};
    std::uint32_t near_p = start(p, f), near_q = start(q, g);
    const double least = a_.error[k] + b_.error[k] - way_[k];
    // Other vertices only come nearer.
    if (!(dot(f, p.vertices[near_p]) + dot(g, q.vertices[near_q]) > least)) return false;
    return surely_least_along(p, f, near_p) + surely_least_along(q, g, near_q) > least;
  }

  static std::uint32_t start(const SearchGraph& graph, const Point3& f) {
    if (graph.padded != 0 || graph.is_slow) return 0;
    return graph.block(table_start(graph, negated(f))).vertex();
  }

  const Side &a_, &b_;
  std::array<Column, 3> of_a_, of_b_;  // the direction as the bodies see it
  Column way_;                         // along it, between the frames
  std::array<bool, chain_length> parts_boxes_{};
};

// The questions about two bodies that follow each other, from one placement to the next.
class Run {
 public:
  Run(const ConvexPolyhedron& a, const ConvexPolyhedron& b) : a_(a), b_(b), at_a_(a), at_b_(b) {}

  bool is_of(const PlacedPair& pair) const { return pair.a == &a_ && pair.b == &b_; }

  // False where they are surely apart; else by the answer.
  bool meet(const PlacedPair& pair, PairAnswer* evidence) {
    at_a_.place(*pair.pose_a);
    at_b_.place(*pair.pose_b);
    // Where bodies jump, what parted them is of no use: then fewer are tried.
    const bool is_parted = part_again(at_a_, at_b_, std::span(kept_).first(tried_));
    tried_ = is_parted ? std::min(tried_ + 1, most_kept) : std::max(tried_ - 1, std::size_t{1});
    if (is_parted) return false;
    PairAnswer answer = polyhedron_polyhedron_warm(a_, *pair.pose_a, b_, *pair.pose_b, last_);
    if (answer.meet()) {
      if (evidence != nullptr) *evidence = std::move(answer);
      return true;
    }
    if (last_.partings_count == 0) return false;
    const auto& [direction, extreme_a, extreme_b] = last_.partings[0];
    if (keep_parting(a_, direction, extreme_a, extreme_b, kept_)) last_.partings_count = 0;
    return false;
  }

 private:
  const ConvexPolyhedron &a_, &b_;
  RigidlyPlaced at_a_, at_b_;
  WarmStart last_;
  std::array<KeptParting, most_kept> kept_{};
  std::size_t tried_ = 2;
};

void ask_chain(std::span<const PlacedPair> pairs, std::span<std::uint8_t> meet, std::span<PairAnswer> of_meeting) {
  Side a, b;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    a.take(k, *pairs[k].a, *pairs[k].pose_a);
    b.take(k, *pairs[k].b, *pairs[k].pose_b);
  }
  const BetweenMiddles between_middles(a, b, pairs.size());
  std::optional<Run> run;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    meet[k] = 0;
    if (between_middles.part(k)) continue;
    const PlacedPair& pair = pairs[k];
    PairAnswer* const evidence = of_meeting.empty() ? nullptr : &of_meeting[k];
    if (!run || !run->is_of(pair)) {
      run.reset();
      const bool goes_on = k + 1 < pairs.size() && pairs[k + 1].a == pair.a && pairs[k + 1].b == pair.b;
      if (goes_on) run.emplace(*pair.a, *pair.b);
    }
    if (run) {
      meet[k] = run->meet(pair, evidence);
      continue;
    }
    PairAnswer answer = polyhedron_polyhedron(*pair.a, *pair.pose_a, *pair.b, *pair.pose_b);
    meet[k] = answer.meet();
    if (meet[k] != 0 && evidence != nullptr) *evidence = std::move(answer);
  }
}

// Each thread takes the next chain that none has taken; what one throws is thrown at the end.
class Chains {
 public:
  Chains(std::span<const PlacedPair> pairs, std::span<std::uint8_t> meet, std::span<PairAnswer> of_meeting)
      : pairs_(pairs), meet_(meet), of_meeting_(of_meeting) {}

  std::size_t count() const { return (pairs_.size() + chain_length - 1) / chain_length; }

  void work() {
    try {
      for (std::size_t chain = next_++; chain < count(); chain = next_++) {
        const std::size_t begin = chain * chain_length, length = std::min(chain_length, pairs_.size() - begin);
        ask_chain(pairs_.subspan(begin, length), meet_.subspan(begin, length),
                  of_meeting_.empty() ? of_meeting_ : of_meeting_.subspan(begin, length));
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const std::span<const PlacedPair> pairs_;
  const std::span<std::uint8_t> meet_;
  const std::span<PairAnswer> of_meeting_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr thrown_;
};

}  // namespace

void polyhedron_polyhedron_batch(std::span<const PlacedPair> pairs, std::span<std::uint8_t> meet,
                                 const BatchOptions& options) {
  SUNDER_REQUIRE(meet.size() == pairs.size());
  SUNDER_REQUIRE(options.of_meeting.empty() || options.of_meeting.size() == pairs.size());
  Chains chains(pairs, meet, options.of_meeting);
  on_threads(std::min(options.threads, chains.count()), [&] { chains.work(); });
  chains.rethrow();
}

}  // namespace sunder::solid
