#include <sunder/base/contract.h>
#include <sunder/base/error.h>
#include <sunder/base/interruption.h>
#include <sunder/base/random.h>
#include <sunder/polytope/represent/normal_fan.h>
#include <sunder/polytope/tree/face_tree.h>
#include <sunder/predicate/point/cone_weights.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace sunder::polytope {

namespace {

using Faces = std::vector<std::uint32_t>;

constexpr std::array<std::uint32_t, 7> faces_of_net{0, 0, 8, 40, 12, 5, 4}, least_faces_of_net{0, 0, 8, 10, 12, 5, 4};
constexpr std::array<std::uint32_t, 7> faces_of_leaf{0, 0, 24, 800, 1300, 300, 300};
constexpr std::array<double, 7> share_of_faces{0, 0, 0.5, 0.75, 0.65, 0.9, 0.95};
constexpr std::array<std::uint32_t, 7> levels_of_faces{0, 0, 16, 16, 2, 1, 1};  // lists are too long for more
constexpr double face_noise = 0x1p-32;                                          // makes the position of a net general
constexpr double cone_slack = 0x1p-20;  // of the greatest weight: a direction so little out of a cone is in it

struct FaceSplit {
  Faces net;  // vertices; the last one of the fan's points may be the origin
  std::vector<NormalFan::Cone> cones;
  std::vector<double> inverses;
  std::vector<Faces> lists;
  std::size_t longest = 0;
};

// Vertices of a node that are not of its net: their numbers, column by column, and which faces of the node each is of.
struct OtherVertices {
  std::size_t count = 0;
  std::vector<double> columns;
  std::vector<std::uint32_t> begin{0},
      faces{};  // those of vertex v from begin[v] on; by their place in the node's list
};

}  // namespace

class FaceTreeBuilder {
 public:
  FaceTreeBuilder(FaceTree& tree, const FaceSet& set, const FaceTreeOptions& options, const std::string& name)
      : tree_(tree), set_(set), options_(options), name_(name), random_(options.seed), d_(set.dimension) {
    net_ = options.net == 0 ? faces_of_net[d_] : options.net;
    least_net_ = options.net == 0 ? least_faces_of_net[d_] : options.net;
    leaf_ = options.leaf == 0 ? faces_of_leaf[d_] : options.leaf;
    if (options_.levels == 0) options_.levels = levels_of_faces[d_];
    share_ = options.share > 0 ? options.share : share_of_faces[d_];
    role_.resize(set.vertices.size() / d_);
    place_.resize(role_.size());
  }

  void build() {
    Faces all(set_.face_count());
    std::iota(all.begin(), all.end(), 0u);
    tree_.nodes_.emplace_back();
    grow(0, all, 0);
  }

 private:
  enum Role : std::uint8_t { unseen = 0, seen, of_net };

  void grow(std::uint32_t node, const Faces& faces, std::uint32_t depth) {
    tree_.depth_ = std::max(tree_.depth_, depth);
    tree_.nodes_[node].faces = static_cast<std::uint32_t>(faces.size());
    const Faces corners = vertices_of(faces);
    std::optional<FaceSplit> split;
    if (faces.size() > leaf_ && depth < options_.levels) {
      split = best_split(faces, corners);
      tree_.unverified_ += !split;
    }
    if (!split) {
      tree_.largest_leaf_ = std::max(tree_.largest_leaf_, static_cast<std::uint32_t>(corners.size()));
      name(node, corners);
      return;
    }
    name(node, split->net);
    const auto first = static_cast<std::uint32_t>(tree_.children_.size());
    const auto cones = static_cast<std::uint32_t>(split->cones.size());
    tree_.nodes_[node].first_cone = first;
    tree_.nodes_[node].cones = cones;
    for (const NormalFan::Cone& cone : split->cones) {
      tree_.apexes_.push_back(cone.apex);
      tree_.children_.push_back(static_cast<std::uint32_t>(tree_.nodes_.size()));
      tree_.nodes_.emplace_back();
    }
    tree_.inverses_.insert(tree_.inverses_.end(), split->inverses.begin(), split->inverses.end());
    if (depth == 0) {
      for (const Faces& list : split->lists) tree_.root_list_ += list.size();
      refuse_by_estimate(*split, faces.size());
    }
    if (tree_.memory() > options_.most_bytes) refuse("more than the " + mebibytes(options_.most_bytes));
    for (std::uint32_t k = 0; k < cones; ++k) {
      const Faces list = std::move(split->lists[k]);
      grow(tree_.children_[first + k], list, depth + 1);
    }
  }

  void name(std::uint32_t node, const Faces& vertices) {
    tree_.nodes_[node].first_vertex = static_cast<std::uint32_t>(tree_.names_.size());
    tree_.nodes_[node].vertices = static_cast<std::uint32_t>(vertices.size());
    tree_.names_.insert(tree_.names_.end(), vertices.begin(), vertices.end());
  }

  // Each once, and the common one.
  Faces vertices_of(const Faces& faces) {
    Faces result;
    const auto see = [&](std::uint32_t v) {
      if (role_[v] == unseen) result.push_back(v);
      role_[v] = seen;
    };
    if (set_.common != FaceSet::origin) see(set_.common);
    for (const std::uint32_t f : faces) {
      for (const std::uint32_t v : set_.face(f)) see(v);
    }
    for (const std::uint32_t v : result) role_[v] = unseen;
    return result;
  }

  std::optional<FaceSplit> best_split(const Faces& faces, const Faces& corners) {
    const auto most = static_cast<std::size_t>(share_ * static_cast<double>(faces.size()));
    // Nets of nodes above leaves need not be large: of one in space a child has some 2 / net of the faces in the mean.
    const auto enough = static_cast<std::uint32_t>(std::min<std::size_t>(5 * faces.size() / leaf_, net_));
    const std::uint32_t net = std::max(least_net_, enough);
    for (std::uint32_t k = 0; k < options_.samples; ++k) {
      std::optional<FaceSplit> split = split_by_net(sampled(faces, net + k * net / 8), faces, corners);
      if (!split) continue;
      if (split->longest <= most) return split;
      if (split->longest > most + (faces.size() - most) * 3 / 4) break;  // others are no better
    }
    return std::nullopt;
  }

  // At most d vertices of each face.
  Faces sampled(const Faces& faces, std::size_t count) {
    Faces some;
    for (std::size_t k = 0; k < count; ++k) {
      const std::span<const std::uint32_t> face = set_.face(faces[random_.below(faces.size())]);
      Faces corners(face.begin(), face.end());
      for (std::size_t i = 0; i < std::min(d_, corners.size()); ++i) {
        std::swap(corners[i], corners[i + random_.below(corners.size() - i)]);
        some.push_back(corners[i]);
      }
    }
    if (set_.common != FaceSet::origin) some.push_back(set_.common);
    std::sort(some.begin(), some.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
    return some;
  }

  std::optional<FaceSplit> split_by_net(Faces net, const Faces& faces, const Faces& corners) {
    // In units of the greatest number of each column.
    std::array<int, 6> unit{};
    for (std::size_t c = 0; c < d_; ++c) {
      double greatest = 0;
      for (const std::uint32_t v : net) greatest = std::max(greatest, std::fabs(set_.vertices[v * d_ + c]));
      if (!(greatest > 0) || !std::isfinite(greatest)) return std::nullopt;
      unit[c] = std::ilogb(greatest);
    }
    std::vector<double> points;
    for (std::size_t k = 0; k < net.size() + (set_.common == FaceSet::origin); ++k) {
      for (std::size_t c = 0; c < d_; ++c) {
        const double x = k < net.size() ? std::ldexp(set_.vertices[net[k] * d_ + c], -unit[c]) : 0;
        points.push_back(x + face_noise * (2 * random_.unit() - 1));
      }
    }
    std::uint64_t looks = 0;
    std::optional<NormalFan> fan = normal_fan(d_, points, looks);
    count_looks(looks);
    if (!fan) return std::nullopt;
    FaceSplit split;
    for (const std::uint32_t v : net) role_[v] = of_net;
    const OtherVertices others = others_of(faces, corners);
    for (const std::uint32_t v : net) role_[v] = unseen;
    out_.resize(others.count);
    reached_.assign(faces.size(), 0);
    turn_ = 0;
    for (const NormalFan::Cone& cone : fan->cones) {
      std::array<double, 36> generators{};
      for (std::size_t i = 0; i < d_; ++i) {
        for (std::size_t c = 0; c < d_; ++c) generators[i * d_ + c] = std::ldexp(fan->ray(cone.rays[i])[c], -unit[c]);
      }
      const std::span<const double> rays = std::span(generators).first(d_ * d_);
      std::array<double, 36> inverse{};
      cone_inverse(rays, d_, std::span(inverse).first(d_ * d_));
      split.inverses.insert(split.inverses.end(), inverse.begin(),
                            inverse.begin() + static_cast<std::ptrdiff_t>(d_ * d_));
      count_looks(others.count);
      const double* const apex = cone.apex < net.size() ? &set_.vertices[net[cone.apex] * d_] : nullptr;
      split.lists.push_back(list_of(rays, apex, others, faces));
      split.longest = std::max(split.longest, split.lists.back().size());
      count_looks(split.lists.back().size());
    }
    split.cones = std::move(fan->cones);
    split.net = std::move(net);
    return split;
  }

  OtherVertices others_of(const Faces& faces, const Faces& corners) {
    OtherVertices others;
    Faces those;
    for (const std::uint32_t v : corners) {
      if (role_[v] == of_net) continue;
      place_[v] = static_cast<std::uint32_t>(those.size());
      those.push_back(v);
    }
    others.count = those.size();
    for (std::size_t c = 0; c < d_; ++c) {
      for (const std::uint32_t v : those) others.columns.push_back(set_.vertices[v * d_ + c]);
    }
    others.begin.assign(others.count + 1, 0);
    const auto for_each_corner = [&](const auto& call) {
      for (std::uint32_t k = 0; k < faces.size(); ++k) {
        for (const std::uint32_t v : set_.face(faces[k])) {
          if (v != set_.common && role_[v] != of_net) call(k, place_[v]);
        }
      }
    };
    for_each_corner([&](std::uint32_t, std::uint32_t v) { ++others.begin[v + 1]; });
    std::partial_sum(others.begin.begin(), others.begin.end(), others.begin.begin());
    others.faces.resize(others.begin.back());
    Faces next(others.begin.begin(), others.begin.end() - 1);
    for_each_corner([&](std::uint32_t k, std::uint32_t v) { others.faces[next[v]++] = k; });
    return others;
  }

  // The faces with a vertex out of the shell-simplex.
  Faces list_of(std::span<const double> rays, const double* apex, const OtherVertices& others, const Faces& faces) {
    std::fill(out_.begin(), out_.end(), std::uint8_t{0});
    for (std::size_t i = 0; i < d_; ++i) {
      const double* const ray = &rays[i * d_];
      const double level = apex == nullptr ? 0 : std::inner_product(apex, apex + d_, ray, 0.0);
      sums_.assign(others.count, -level);
      for (std::size_t c = 0; c < d_; ++c) {
        const double* const column = others.columns.data() + c * others.count;
        for (std::size_t v = 0; v < others.count; ++v) sums_[v] += ray[c] * column[v];
      }
      for (std::size_t v = 0; v < others.count; ++v) out_[v] |= static_cast<std::uint8_t>(sums_[v] > 0);
    }
    ++turn_;
    Faces list;
    for (std::size_t v = 0; v < others.count; ++v) {
      if (out_[v] == 0) continue;
      for (std::uint32_t i = others.begin[v]; i < others.begin[v + 1]; ++i) {
        const std::uint32_t k = others.faces[i];
        if (reached_[k] == turn_) continue;
        reached_[k] = turn_;
        list.push_back(faces[k]);
      }
    }
    return list;
  }

  // The levels below the root's children are taken to be like the root.
  void refuse_by_estimate(const FaceSplit& split, std::size_t faces) const {
    const auto cones = static_cast<double>(split.cones.size()), all = static_cast<double>(faces);
    const double part = static_cast<double>(tree_.root_list_) / all / cones;
    const double corners = static_cast<double>(role_.size()) / all;  // vertices for each face
    const double cone_bytes = 8.0 * static_cast<double>(d_ * d_) + sizeof(FaceTree::Node) + 8;
    double bytes = cones * cone_bytes, looks = static_cast<double>(tree_.looks_);
    for (const Faces& list : split.lists) {
      double nodes = 1, size = static_cast<double>(list.size());
      for (std::uint32_t level = 1; size > leaf_ && level < options_.levels; ++level) {
        const double children =
            std::max(cones * std::min(1.0, 5 * size / leaf_ / net_), static_cast<double>(least_net_));
        looks += nodes * children * size * (1 + corners);
        nodes *= children;
        bytes += nodes * cone_bytes;
        size *= std::min(part * cones / children, share_);
      }
      bytes += 4 * nodes * size * std::min(1.0 + corners, static_cast<double>(d_));
    }
    if (bytes > static_cast<double>(options_.most_bytes)) {
      refuse("about " + mebibytes(static_cast<std::size_t>(std::min(bytes, 0x1p60))) + ", more than the " +
             mebibytes(options_.most_bytes));
    }
    if (looks > static_cast<double>(options_.most_looks)) {
      refuse("about " + std::to_string(static_cast<std::uint64_t>(std::min(looks / 1e6, 0x1p60))) +
             " million looks, more than the " + std::to_string(options_.most_looks / 1'000'000) + " million");
    }
  }

  static std::string mebibytes(std::size_t n) { return std::to_string((n + (1u << 20) - 1) >> 20) + " MiB"; }

  void count_looks(std::uint64_t count) {
    may_be_interrupted(static_cast<std::uint32_t>(std::min<std::uint64_t>(count, 1u << 30)));
    tree_.looks_ += count;
    if (tree_.looks_ <= options_.most_looks) return;
    refuse("more than the " + std::to_string(options_.most_looks / 1'000'000) + " million looks at cones and faces");
  }

  [[noreturn]] void refuse(const std::string& takes) const {
    throw Error(ErrorCode::bad_shape,
                name_ + " takes " + takes + " that it may; give fewer rows, or use another method");
  }

  FaceTree& tree_;
  const FaceSet& set_;
  FaceTreeOptions options_;
  const std::string& name_;
  Random random_;
  std::size_t d_;
  std::uint32_t net_ = 0, least_net_ = 0, leaf_ = 0;
  double share_ = 0;
  std::vector<std::uint8_t> role_;    // of vertices
  std::vector<std::uint32_t> place_;  // of vertices among the others of a node
  std::vector<std::uint8_t> out_;     // of these: out of the shell-simplex
  std::vector<double> sums_;
  std::vector<std::uint32_t> reached_;  // of faces of the node: the last turn that listed them
  std::uint32_t turn_ = 0;
};

FaceTree::FaceTree(std::size_t dimension, std::vector<double> vertices, std::vector<std::uint32_t> named)
    : d_(dimension), vertices_(std::move(vertices)), names_(std::move(named)) {
  largest_leaf_ = static_cast<std::uint32_t>(names_.size());
  nodes_.push_back({.vertices = largest_leaf_});
}

FaceTree::FaceTree(FaceSet faces, const FaceTreeOptions& options, const std::string& name) : d_(faces.dimension) {
  SUNDER_REQUIRE(options.share >= 0 && options.share < 1);
  face_count_ = faces.face_count();
  FaceTreeBuilder(*this, faces, options, name).build();
  vertices_ = std::move(faces.vertices);
}

std::uint32_t FaceTree::child_towards(const Node& node, std::span<const double> direction, Cost& cost) const {
  const std::span<const std::uint32_t> net = vertices(node);
  auto best = static_cast<std::uint32_t>(net.size());
  double furthest = -std::numeric_limits<double>::infinity();
  const auto last = apexes_.begin() + node.first_cone + node.cones, first = apexes_.begin() + node.first_cone;
  if (*(last - 1) == net.size()) furthest = 0;  // the origin is of the net
  for (std::uint32_t k = 0; k < net.size(); ++k) {
    const double product = std::inner_product(direction.begin(), direction.end(), point(net[k]).begin(), 0.0);
    if (!(product > furthest)) continue;
    furthest = product;
    best = k;
  }
  cost.probes += net.size();
  // The cone with the greatest of least weights.
  auto found = node.first_cone;
  double greatest = -std::numeric_limits<double>::infinity();
  const auto look_at = [&](std::uint32_t from, std::uint32_t to) {
    cost.probes += to - from;
    for (std::uint32_t cone = from; cone < to; ++cone) {
      const double* row = &inverses_[cone * d_ * d_];
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (std::size_t i = 0; i < d_; ++i, row += d_) {
        const double weight = std::inner_product(direction.begin(), direction.end(), row, 0.0);
        least = std::min(least, weight);
        most = std::max(most, std::fabs(weight));
      }
      const double fit = most > 0 ? least / most : -1;
      if (!(fit > greatest)) continue;
      greatest = fit;
      found = cone;
    }
  };
  const auto [from, to] = std::equal_range(first, last, best);
  look_at(static_cast<std::uint32_t>(from - apexes_.begin()), static_cast<std::uint32_t>(to - apexes_.begin()));
  if (!(greatest > -cone_slack)) look_at(node.first_cone, node.first_cone + node.cones);
  return children_[found];
}

std::size_t FaceTree::memory() const {
  const auto bytes = [](const auto& list) { return list.size() * sizeof(list[0]); };
  return bytes(vertices_) + bytes(nodes_) + bytes(names_) + bytes(children_) + bytes(apexes_) + bytes(inverses_);
}

}  // namespace sunder::polytope
