// Polytopes of any dimension: one pair with its evidence, points against a hull, hierarchical trees.
#include <sunder/polytope/pair/hyperplanes.h>
#include <sunder/polytope/pair/polytope_claims.h>
#include <sunder/polytope/pair/polytope_point.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/tree/polytope_polytope_by_tree.h>

#include "polytopes.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace sunder::python {

namespace {

using polytope::ExactEvidence;
using polytope::FaceTrees;
using polytope::FaceTreesOf;
using polytope::HierarchicalTree;
using polytope::HyperplaneEvidence;
using polytope::Polytope;
using polytope::PolytopeAnswer;
using polytope::Pose;

using SharedPolytope = std::shared_ptr<Polytope>;
using SharedTree = std::shared_ptr<const HierarchicalTree>;
using SharedTrees = std::shared_ptr<FaceTrees>;

// Two placed polytopes, kept for the evidence; or a polytope and a point.
struct PlacedPair {
  SharedPolytope a, b;
  Pose pose_a, pose_b;
  SharedTree tree_a, tree_b;  // null, unless the answer is by trees
};

struct PythonPolytopeAnswer : YesNo {
  DecidedBy decided_by = DecidedBy::filter;
  std::shared_ptr<const PlacedPair> pair;
  PolytopeAnswer answer;

  ExactEvidence evidence() const {
    return unlocked([&] { return exact_evidence(a(), pair->pose_a, b(), pair->pose_b, answer); });
  }
  const Polytope& a() const { return pair->a ? *pair->a : pair->tree_a->body(); }
  const Polytope& b() const { return pair->b ? *pair->b : pair->tree_b->body(); }
};

PythonPolytopeAnswer answer_of(std::shared_ptr<const PlacedPair> pair, const PolytopeAnswer& answer) {
  PythonPolytopeAnswer result{{{answer.cost, {}}, answer.meet()}, answer.decided_by, std::move(pair), answer};
  result.certificate_text = [pair = result.pair, answer] {
    const Polytope& a = pair->a ? *pair->a : pair->tree_a->body();
    const Polytope& b = pair->b ? *pair->b : pair->tree_b->body();
    return proof_of(AskedPair{a, pair->pose_a, b, pair->pose_b}, answer);
  };
  return result;
}

void require_one_dimension(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b) {
  const std::size_t d = a.dimension();
  for (const auto& [dimension, place] :
       {std::pair(pose_a.dimension(), "pose_a"), {b.dimension(), "b"}, {pose_b.dimension(), "pose_b"}}) {
    if (dimension == d) continue;
    throw Error(ErrorCode::bad_shape,
                "it is of dimension " + std::to_string(dimension) + ", and a of " + std::to_string(d) +
                    "; give all of one dimension",
                place);
  }
}

using Method = PolytopeAnswer (*)(const Polytope&, const Pose&, const Polytope&, const Pose&);

Method method_of(const std::string& name) {
  if (name == "automatic") return polytope::polytope_polytope;
  if (name == "gjk") return polytope::polytope_polytope_by_gjk;
  if (name == "scan") return polytope::polytope_polytope_by_scan;
  throw Error(ErrorCode::bad_value, "there is no such method; give automatic, gjk or scan, or trees instead of bodies",
              "method");
}

PythonPolytopeAnswer meet(const SharedPolytope& a, const Pose& pose_a, const SharedPolytope& b, const Pose& pose_b,
                          const std::string& method) {
  require_one_dimension(*a, pose_a, *b, pose_b);
  const auto pair = std::make_shared<const PlacedPair>(PlacedPair{a, b, pose_a, pose_b, {}, {}});
  const Method decide = method_of(method);
  return answer_of(pair, unlocked([&] { return decide(*a, pose_a, *b, pose_b); }));
}

PythonPolytopeAnswer meet_by_tree(const SharedTrees& a, const Pose& pose_a, const SharedTrees& b, const Pose& pose_b) {
  require_one_dimension(a->body(), pose_a, b->body(), pose_b);
  const auto pair = std::make_shared<const PlacedPair>(
      PlacedPair{{}, {}, pose_a, pose_b, SharedTree(a, &a->walks()), SharedTree(b, &b->walks())});
  return answer_of(pair, unlocked([&] { return polytope_polytope_by_tree(*a, pose_a, *b, pose_b); }));
}

PythonPolytopeAnswer meet_by_columns(const std::shared_ptr<HierarchicalTree>& a, const Pose& pose_a,
                                     const std::shared_ptr<HierarchicalTree>& b, const Pose& pose_b) {
  require_one_dimension(a->body(), pose_a, b->body(), pose_b);
  const auto pair = std::make_shared<const PlacedPair>(PlacedPair{{}, {}, pose_a, pose_b, a, b});
  return answer_of(pair, unlocked([&] { return polytope_polytope_by_columns(*a, pose_a, *b, pose_b); }));
}

HyperplaneEvidence hyperplanes_of(const PythonPolytopeAnswer& of) {
  const PlacedPair& pair = *of.pair;
  if (of.yes) throw Error(ErrorCode::bad_call, "they meet, and no hyperplanes part them; ask for the point");
  if (!pair.tree_a || !pair.tree_b) {
    throw Error(ErrorCode::bad_call,
                "only answers by trees have hyperplanes; ask polytope_polytope_by_tree or _by_columns");
  }
  return unlocked([&] { return parting_hyperplanes(*pair.tree_a, pair.pose_a, *pair.tree_b, pair.pose_b, of.answer); });
}

nb::bytes hyperplane_certificate(const PythonPolytopeAnswer& of) {
  const HyperplaneEvidence evidence = hyperplanes_of(of);
  return bytes_of_file([&](ClaimsWriter& file) {
    add_claims(file, {"A", of.a(), of.pair->pose_a}, {"B", of.b(), of.pair->pose_b}, evidence);
  });
}

nb::tuple hyperplane_counts(const PythonPolytopeAnswer& of) {
  const HyperplaneEvidence evidence = hyperplanes_of(of);
  return nb::make_tuple(HyperplaneEvidence::count(evidence.a), HyperplaneEvidence::count(evidence.b));
}

// The answers about many points and one polytope.
struct PointsAnswer {
  SharedPolytope polytope;
  std::vector<double> points;
  std::vector<PolytopeAnswer> answers;

  PythonPolytopeAnswer at(std::size_t k) const {
    if (k >= answers.size()) throw nb::index_error();
    const std::size_t d = polytope->dimension();
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(k * d);
    auto point = std::make_shared<Polytope>(
        Polytope::from_points(d, std::vector<double>(first, first + static_cast<std::ptrdiff_t>(d))));
    return answer_of(std::make_shared<const PlacedPair>(PlacedPair{polytope, point, Pose(d), Pose(d), {}, {}}),
                     answers[k]);
  }
};

PointsAnswer points_in(const SharedPolytope& polytope, const ArrayLike& given) {
  const Doubles rows = doubles_of(given, "points", {{any_length, static_cast<int>(polytope->dimension())}});
  PointsAnswer result{polytope, {rows.data(), rows.data() + rows.size()}, {}};
  result.answers = unlocked([&] { return polytope_points(*polytope, result.points); });
  return result;
}

std::size_t dimension_of(const Doubles& rows, std::size_t more, const char* place) {
  const std::size_t width = rows.shape(1);
  if (width < polytope::least_dimension + more || width > polytope::most_dimension + more) {
    throw Error(ErrorCode::bad_shape,
                "rows of " + std::to_string(width) + "; give " + std::to_string(polytope::least_dimension + more) +
                    " to " + std::to_string(polytope::most_dimension + more) + " numbers a row",
                place);
  }
  return width - more;
}

auto matrix_of(std::vector<double> numbers, std::size_t columns) {
  auto* const kept = new std::vector<double>(std::move(numbers));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
  return Returned<double, nb::ndim<2>>(kept->data(), {kept->size() / columns, columns}, owner);
}

auto rows_of(const Polytope& body) {
  std::vector<double> all;
  for (std::uint32_t k = 0; k < body.size(); ++k) all.insert(all.end(), body.row(k).begin(), body.row(k).end());
  return matrix_of(std::move(all), body.columns().dimension);
}

}  // namespace

nb::tuple fractions_of(std::span<const Dyadic> numbers, const Dyadic& denominator) {
  return nb::tuple(list_of(numbers, [&](const Dyadic& n) { return fraction_of(n, denominator); }));
}

nb::dict weights_of(const Weights& weights) {
  nb::dict result;
  for (const Weights::Part& part : weights.parts) {
    result[nb::int_(part.index)] = fraction_of(part.numerator, weights.denominator);
  }
  return result;
}

void bind_polytopes(nb::module_& module, nb::module_& chapter) {
  const nb::arg a("a"), pose_a("pose_a"), b("b"), pose_b("pose_b");
  nb::class_<Polytope>(chapter, "Polytope", "A polytope of 2 to 6 dimensions, of points or of half-spaces, as given.")
      .def_static(
          "from_points",
          [](const ArrayLike& given) {
            const Doubles rows = doubles_of(given, "points", {{any_length, any_length}});
            const std::size_t d = dimension_of(rows, 0, "points");
            return Polytope::from_points(d, {rows.data(), rows.data() + rows.size()});
          },
          nb::arg("points"), "The convex hull of the rows x1, .., xd.")
      .def_static(
          "from_half_spaces",
          [](const ArrayLike& given) {
            const Doubles rows = doubles_of(given, "half_spaces", {{any_length, any_length}});
            const std::size_t d = dimension_of(rows, 1, "half_spaces");
            return Polytope::from_half_spaces(d, {rows.data(), rows.data() + rows.size()});
          },
          nb::arg("half_spaces"), "What the rows a1, .., ad, b have in common: all x with a x <= b.")
      .def("__len__", &Polytope::size)
      .def_prop_ro("dimension", &Polytope::dimension)
      .def_prop_ro("is_of_points", &Polytope::is_of_points)
      .def_prop_ro("rows", &rows_of, owned);
  nb::class_<Pose>(chapter, "Pose", "x_world = linear x_body + translation: these doubles are the map, exactly.")
      .def(
          "__init__",
          [](Pose* pose, std::size_t dimension) {
            if (dimension < polytope::least_dimension || dimension > polytope::most_dimension) {
              throw Error(ErrorCode::bad_pose, "a pose is of dimension 2 to 6", "dimension");
            }
            new (pose) Pose(dimension);
          },
          nb::arg("dimension"), "The identity.")
      .def_static(
          "from_matrix",
          [](const ArrayLike& linear, const ArrayLike& translation) {
            const Doubles t = doubles_of(translation, "translation", {{any_length}});
            if (t.size() > polytope::most_dimension) {
              throw Error(ErrorCode::bad_pose, "a pose is of dimension 2 to 6", "translation");
            }
            const int d = static_cast<int>(t.size());
            const Doubles m = doubles_of(linear, "linear", {{d, d}, {d * d}});
            return Pose::from_matrix(t.size(), {m.data(), m.size()}, {t.data(), t.size()});
          },
          nb::arg("linear"), nb::arg("translation"), "An invertible linear part, row by row.")
      .def_prop_ro("dimension", &Pose::dimension)
      .def_prop_ro(
          "linear",
          [](const Pose& pose) { return matrix_of({pose.linear().begin(), pose.linear().end()}, pose.dimension()); },
          owned)
      .def_prop_ro("translation", [](const Pose& pose) { return array_of<double>(pose.translation()); }, owned);
  nb::class_<HierarchicalTree>(chapter, "HierarchicalTree",
                               "A polytope, so that what is furthest along a direction is found in some log n looks.")
      .def(
          "__init__",
          [](HierarchicalTree* tree, const Polytope& body, std::size_t most_bytes) {
            unlocked([&] { new (tree) HierarchicalTree(body, {.most_bytes = most_bytes}); });
          },
          nb::arg("polytope"), nb::arg("most_bytes") = std::size_t{1} << 30,
          "Refused where it would take more memory than it may, by an estimate first.")
      .def_prop_ro("polytope", [](const HierarchicalTree& tree) { return tree.body(); })
      .def_prop_ro("depth", &HierarchicalTree::depth)
      .def_prop_ro("node_count", &HierarchicalTree::node_count)
      .def_prop_ro("cone_count", &HierarchicalTree::cone_count)
      .def_prop_ro("row_count", &HierarchicalTree::row_count, "Of all nodes.")
      .def_prop_ro("largest_leaf", &HierarchicalTree::largest_leaf)
      .def_prop_ro("unverified", &HierarchicalTree::unverified, "Cones with more conflicts than the share.")
      .def_prop_ro("estimate", &HierarchicalTree::estimate, "Bytes, from the root's lists; 0 for a single leaf.")
      .def_prop_ro("memory", &HierarchicalTree::memory, "Bytes, without the body.");
  nb::class_<FaceTrees>(chapter, "FaceTrees",
                        "A polytope of points, prepared for one descent: the trees of its faces and of its polar's.")
      .def(
          "__init__",
          [](FaceTrees* trees, const Polytope& body, std::size_t most_bytes) {
            if (!body.is_of_points()) {
              throw Error(ErrorCode::bad_shape, "it is of half-spaces; give points, or use HierarchicalTree",
                          "polytope");
            }
            unlocked([&] { new (trees) FaceTrees(body, FaceTreesOf::both, {.most_bytes = most_bytes}); });
          },
          nb::arg("polytope"), nb::arg("most_bytes") = std::size_t{1} << 30)
      .def_prop_ro("polytope", [](const FaceTrees& trees) { return trees.body(); })
      .def_prop_ro(
          "depth", [](const FaceTrees& trees) { return trees.faces()->depth(); }, "Of the tree of the faces.")
      .def_prop_ro(
          "polar_depth",
          [](const FaceTrees& trees) { return trees.polar() ? std::optional(trees.polar()->depth()) : std::nullopt; },
          "Of the tree of the polar's faces; None for a body of fewer dimensions.")
      .def_prop_ro("memory", &FaceTrees::memory, "Bytes, without the body.");
  nb::class_<PythonPolytopeAnswer, YesNo>(chapter, "PolytopeAnswer",
                                          "Do two polytopes meet? True where they do; with evidence as fractions.")
      .def_prop_ro("decided_by", [](const PythonPolytopeAnswer& answer) { return name_of(answer.decided_by); })
      .def_prop_ro(
          "point",
          [](const PythonPolytopeAnswer& answer) -> std::optional<nb::tuple> {
            if (!answer.yes) return std::nullopt;
            const ExactEvidence evidence = answer.evidence();
            return fractions_of(evidence.numbers, evidence.denominator);
          },
          "A common point; None where they are apart.")
      .def_prop_ro(
          "direction",
          [](const PythonPolytopeAnswer& answer) -> std::optional<nb::tuple> {
            if (answer.yes) return std::nullopt;
            return fractions_of(answer.evidence().numbers, Dyadic(1.0));
          },
          "A is less far along it than B; zero where half-spaces alone contradict; None where they meet.")
      .def_prop_ro(
          "weights_a", [](const PythonPolytopeAnswer& answer) { return weights_of(answer.evidence().of_a); },
          "Of rows of A: where they meet, the weights of points that make the point; where they are apart, the "
          "multipliers of half-spaces.")
      .def_prop_ro(
          "weights_b", [](const PythonPolytopeAnswer& answer) { return weights_of(answer.evidence().of_b); },
          "The same of B.")
      .def("hyperplane_certificate", &hyperplane_certificate,
           "Of an answer by trees, apart: half-spaces that hold A, and such that hold B, contradict.")
      .def_prop_ro("hyperplanes", &hyperplane_counts, "How many of these there are, around A and around B.");
  nb::class_<PointsAnswer>(chapter, "PointsAnswer", "Which of many points are in a polytope, each with its answer.")
      .def("__len__", [](const PointsAnswer& answer) { return answer.answers.size(); })
      .def("__getitem__", &PointsAnswer::at, nb::arg("k"), "The polytope, A, and point k, B.")
      .def_prop_ro(
          "inside",
          [](const PointsAnswer& answer) {
            std::vector<std::uint8_t> inside;
            for (const PolytopeAnswer& one : answer.answers) inside.push_back(one.meet());
            return array_of<bool>(std::move(inside));
          },
          owned);

  constexpr const char* doc = "Do two convex polytopes meet, placed or as they are? Touching is meeting.";
  chapter.def("polytope_polytope", &meet, a, pose_a, b, pose_b, nb::arg("method") = "automatic", doc);
  chapter.def("polytope_polytope_by_tree", &meet_by_tree, a, pose_a, b, pose_b,
              "The same, of bodies that were prepared: one descent down the faces of one and the polar of the other.");
  chapter.def("polytope_polytope_by_columns", &meet_by_columns, a, pose_a, b, pose_b,
              "The same, by a simplex method whose columns walks down two trees find.");
  chapter.def("polytope_points", &points_in, nb::arg("polytope"), nb::arg("points"),
              "Which of the points, an array of rows, are in the polytope?");
  const auto placed = [](const SharedPolytope& first, const Pose& at_first, const SharedPolytope& second,
                         const Pose& at_second) { return meet(first, at_first, second, at_second, "automatic"); };
  module.def("intersect", placed, a, pose_a, b, pose_b, doc);
  module.def(
      "intersect",
      [](const SharedPolytope& first, const SharedPolytope& second) {
        return meet(first, Pose(first->dimension()), second, Pose(second->dimension()), "automatic");
      },
      a, b, doc);
  bind_hulls(chapter);
}

}  // namespace sunder::python
