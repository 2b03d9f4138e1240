// Many placed pairs in one call.
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include "common.h"

namespace sunder::python {

namespace {

// What differs between the plane and space. Object: closed, convex, of D dimensions. Pose::from_matrix takes the linear
// part row by row, and the translation.
template <class ObjectType, class PoseType, std::size_t D>
struct PairKind {
  using Object = ObjectType;
  using Pose = PoseType;
  static constexpr std::size_t dimension = D;
  static constexpr int rows = static_cast<int>(D), columns = rows + 1;
};
using Planar = PairKind<planar::ConvexPolygon, planar::Pose, 2>;
using Solid = PairKind<solid::ConvexPolyhedron, solid::Pose, 3>;

// The pose of D rows of D + 1 numbers, each a row of the linear part and a number of the translation.
template <class Kind>
typename Kind::Pose pose_of_rows(const double* numbers) {
  constexpr std::size_t D = Kind::dimension;
  std::array<double, D * D> linear;
  std::array<double, D> translation;
  for (std::size_t i = 0; i < D; ++i) {
    for (std::size_t k = 0; k < D; ++k) linear[D * i + k] = numbers[(D + 1) * i + k];
    translation[i] = numbers[(D + 1) * i + D];
  }
  return Kind::Pose::from_matrix(linear, translation);
}

// One side of many pairs: one object or one for each pair, and the same of poses.
template <class Kind>
class Side {
 public:
  using Object = typename Kind::Object;
  using Pose = typename Kind::Pose;

  Side(nb::handle objects, nb::handle poses, const char* objects_place, const char* poses_place)
      : poses_place_(poses_place) {
    if (nb::isinstance<Object>(objects)) {
      kept_ = nb::borrow(objects);
      objects_ = {nb::cast<const Object*>(objects)};
    } else {
      take_objects(objects, objects_place);
    }
    if (poses.is_none()) {
      fixed_ = Pose();
    } else if (nb::isinstance<Pose>(poses)) {
      fixed_ = nb::cast<Pose>(poses);
    } else {
      take_poses(poses);
    }
  }

  std::size_t size() const { return are_many_ ? objects_.size() : poses_; }  // no_size: one of each
  bool has_size() const { return are_many_ || !fixed_; }
  bool fits(std::size_t n) const { return (!are_many_ || objects_.size() == n) && (fixed_ || poses_ == n); }

  const Object& object(std::size_t k) const { return *objects_[are_many_ ? k : 0]; }
  // Throws Error bad_pose that names the pose.
  Pose pose(std::size_t k) const {
    if (fixed_) return *fixed_;
    try {
      return pose_of_rows<Kind>(&numbers_[k * Kind::rows * Kind::columns]);
    } catch (const Error& error) {
      std::string text = error.what();
      if (!error.place().empty()) text.erase(0, error.place().size() + 2);
      throw Error(error.code(), text, std::string(poses_place_) + "[" + std::to_string(k) + "]");
    }
  }

 private:
  void take_objects(nb::handle objects, const char* place) {
    if (!nb::isinstance<nb::list>(objects) && !nb::isinstance<nb::tuple>(objects)) {
      throw Error(ErrorCode::bad_value, "give a convex object, or a list of them", place);
    }
    const nb::tuple all(nb::borrow(objects));
    kept_ = all;
    are_many_ = true;
    for (const nb::handle one : all) {
      const Object* object = nullptr;
      if (!nb::try_cast<const Object*>(one, object) || object == nullptr) {
        throw Error(ErrorCode::bad_value, "is no convex object of the kind of the others; give these only",
                    std::string(place) + "[" + std::to_string(objects_.size()) + "]");
      }
      objects_.push_back(object);
    }
  }

  void take_poses(nb::handle poses) {
    constexpr int rows = Kind::rows, columns = Kind::columns;
    const Doubles given =
        doubles_of(poses, poses_place_, {{any_length, rows, columns}, {any_length, rows * columns}, {rows, columns}});
    numbers_.assign(given.data(), given.data() + given.size());
    if (given.ndim() == 2 && given.shape(0) == rows && given.shape(1) == columns) {
      fixed_ = pose(0);
    } else {
      poses_ = given.shape(0);
    }
  }

  const char* poses_place_;
  nb::object kept_;  // the objects, while the interpreter may do something else
  std::vector<const Object*> objects_;
  bool are_many_ = false;
  std::optional<Pose> fixed_;
  std::vector<double> numbers_;
  std::size_t poses_ = 0;
};

template <class Kind>
std::size_t count_of_pairs(const Side<Kind>& a, const Side<Kind>& b) {
  const std::size_t count = a.has_size() ? a.size() : b.has_size() ? b.size() : 1;
  if (!a.fits(count) || !b.fits(count)) {
    throw Error(ErrorCode::bad_shape, "objects and poses are not equally many; give as many of each, or one",
                "intersect_many");
  }
  return count;
}

template <class Kind>
Returned<bool, nb::ndim<1>> verdicts_of(nb::handle a, nb::handle poses_a, nb::handle b, nb::handle poses_b) {
  const Side<Kind> of_a(a, poses_a, "a", "poses_a"), of_b(b, poses_b, "b", "poses_b");
  std::vector<std::uint8_t> meet(count_of_pairs(of_a, of_b));
  unlocked([&] {
    for (std::size_t k = 0; k < meet.size(); ++k) {
      meet[k] = intersect(of_a.object(k), of_a.pose(k), of_b.object(k), of_b.pose(k)).meet();
    }
  });
  return array_of<bool>(std::move(meet));
}

template <class Object>
bool is_of(nb::handle one_or_list) {
  if (!nb::isinstance<nb::list>(one_or_list) && !nb::isinstance<nb::tuple>(one_or_list)) {
    return nb::isinstance<Object>(one_or_list);
  }
  return nb::len(one_or_list) > 0 && nb::isinstance<Object>(one_or_list[0]);
}

}  // namespace

void bind_many(nb::module_& module) {
  module.def(
      "intersect_many",
      [](const nb::object& a, const nb::object& poses_a, const nb::object& b, const nb::object& poses_b) {
        const bool planar = is_of<planar::ConvexPolygon>(a) || is_of<planar::ConvexPolygon>(b);
        return planar ? verdicts_of<Planar>(a, poses_a, b, poses_b) : verdicts_of<Solid>(a, poses_a, b, poses_b);
      },
      nb::arg("a"), nb::arg("poses_a").none(), nb::arg("b"), nb::arg("poses_b").none(),
      "Which of many placed pairs meet, as an array of bool. a and b: one convex object, or a list with one for each "
      "pair. poses: (N, D, D + 1) or (N, D * (D + 1)) numbers, each row of the linear part followed by its number of "
      "the "
      "translation; or one pose for all, or None.");
}

}  // namespace sunder::python
