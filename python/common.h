// What all bindings share: errors, arrays given and returned, and answers that write their certificates when asked.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/near/set_question.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/crossing.h>
#include <sunder/predicate/point.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::python {

namespace nb = nanobind;

// The chapters of the module.
void bind_answers(nb::module_& module);
void bind_planar(nb::module_& module, nb::module_& planar);
void bind_many(nb::module_& module);
void bind_sets(nb::module_& planar);
void bind_regions(nb::module_& planar);
void bind_solid(nb::module_& module, nb::module_& solid);
void bind_scene(nb::module_& scene);

// C++ errors become sunder.Error of Python.
void translate_errors();

// --- Arrays given -------------------------------------------------------------------------------------------------

// Anything that NumPy makes an array of; stubs say numpy.typing.ArrayLike.
class ArrayLike : public nb::object {
  static bool is_any(PyObject*) { return true; }
  NB_OBJECT_DEFAULT(ArrayLike, nb::object, "numpy.typing.ArrayLike", is_any)
};

using Doubles = nb::ndarray<const double, nb::c_contig, nb::device::cpu>;
inline constexpr int any_length = -1;

// The same numbers as doubles, of one of these shapes, as python/sunder/_arrays.py says. Throws sunder.Error.
Doubles doubles_of(nb::handle given, const char* place, std::initializer_list<std::vector<int>> shapes);

template <std::size_t N>
std::array<double, N> numbers_of(nb::handle given, const char* place, std::initializer_list<std::vector<int>> shapes) {
  const Doubles numbers = doubles_of(given, place, shapes);
  std::array<double, N> result;
  std::copy_n(numbers.data(), N, result.begin());
  return result;
}

// Rows of D numbers.
template <std::size_t D>
std::vector<Point<D>> points_of(nb::handle given, const char* place) {
  const Doubles numbers = doubles_of(given, place, {{any_length, static_cast<int>(D)}});
  std::vector<Point<D>> points(numbers.shape(0));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < D; ++k) points[i][k] = numbers.data()[D * i + k];
  }
  return points;
}

// Numbers of groups for so many members; empty for None.
std::vector<std::uint32_t> groups_of(nb::handle given, std::size_t size);

// Throws Error where the text names none of these, the names of which name_of tells.
template <class Enum>
Enum named(std::string_view text, std::initializer_list<Enum> known, const char* place) {
  std::string names;
  for (const Enum value : known) {
    if (name_of(value) == text) return value;
    names.append(names.empty() ? "" : ", ").append(name_of(value));
  }
  throw Error(ErrorCode::bad_call, "there is no '" + std::string(text) + "'; give one of " + names, place);
}

// --- Arrays returned ----------------------------------------------------------------------------------------------

template <class T, class... Shape>
using Returned = nb::ndarray<T, nb::numpy, nb::c_contig, Shape...>;

// The numbers of plain entries, W each, as an array that owns them: (N, W), or (N,) where W is 1.
template <class T, std::size_t W = 1, class Entry>
auto array_of(std::vector<Entry> entries) {
  static_assert(sizeof(Entry) == W * sizeof(T));
  auto* const kept = new std::vector<Entry>(std::move(entries));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<Entry>*>(p); });
  T* const data = reinterpret_cast<T*>(kept->data());
  if constexpr (W == 1) {
    return Returned<T, nb::ndim<1>>(data, {kept->size()}, owner);
  } else {
    return Returned<T, nb::shape<-1, static_cast<nb::ssize_t>(W)>>(data, {kept->size(), W}, owner);
  }
}
template <class T, std::size_t W = 1, class Entry>
auto array_of(std::span<const Entry> entries) {
  return array_of<T, W>(std::vector<Entry>(entries.begin(), entries.end()));
}

// A pair of fractions.Fraction.
nb::tuple fractions_of(const ExactPoint2& p);

// The nearest doubles.
inline Point2 rounded(const ExactPoint2& p) {
  return {nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator)};
}

// --- Answers ------------------------------------------------------------------------------------------------------

// What every answer has: its cost, and a certificate that is made when it is asked for, of what the closure keeps.
struct Answer {
  Cost cost;
  std::function<std::string()> certificate_text;

  nb::bytes certificate() const;
};

// To a question that is answered by yes or no; in Python it is true where they meet.
struct YesNo : Answer {
  bool yes = false;
};

// Runs without the interpreter's lock. `work` touches nothing of Python.
template <class Work>
auto unlocked(const Work& work) {
  const nb::gil_scoped_release release;
  return work();
}

}  // namespace sunder::python
