// What all bindings share: errors, arrays given and returned, and answers that write their certificates when asked.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/base/interruption.h>
#include <sunder/certificate/claims.h>
#include <sunder/near/set_question.h>
#include <sunder/number/dyadic.h>
#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/predicate/line/crossing.h>
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
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sunder::python {

namespace nb = nanobind;

// The chapters of the module.
void bind_answers(nb::module_& module);
void bind_planar(nb::module_& module, nb::module_& planar);
void bind_polygons(nb::module_& planar);
void bind_sets(nb::module_& planar);
void bind_regions(nb::module_& planar);
void bind_solid(nb::module_& module, nb::module_& solid);
void bind_sections(nb::module_& solid);
void bind_flats(nb::module_& module, nb::module_& solid);
void bind_polytopes(nb::module_& module, nb::module_& polytope);
void bind_robots(nb::module_& module);
void bind_ask(nb::module_& module);

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
  std::array<double, N> result;
  std::copy_n(doubles_of(given, place, shapes).data(), N, result.begin());
  return result;
}

// Rows of W numbers as plain entries of as many.
template <class Entry>
std::vector<Entry> entries_of(const Doubles& rows) {
  const auto* const first = reinterpret_cast<const Entry*>(rows.data());
  return {first, first + rows.shape(0)};
}
template <class Entry>
std::vector<Entry> entries_of(nb::handle given, const char* place) {
  return entries_of<Entry>(doubles_of(given, place, {{any_length, sizeof(Entry) / sizeof(double)}}));
}

// Numbers of groups for so many members; empty for None.
std::vector<std::uint32_t> groups_of(nb::handle given, std::size_t size);

// A list of rings, each an array of points, or one ring.
planar::PolygonRings one_polygon(nb::handle given, const char* place);

// Throws Error bad_shape where it is not valid under the rule.
planar::Polygon checked_polygon(const planar::PolygonRings& rings, planar::PolygonRule rule, const std::string& place);

// Polygons that are valid, but that rings may touch themselves: what questions about sets of polygons require.
struct Polygons {
  std::vector<planar::Polygon> members;
  std::size_t size() const { return members.size(); }
};

// --- Arrays returned ----------------------------------------------------------------------------------------------

template <class T, class... Shape>
using Returned = nb::ndarray<T, nb::numpy, nb::c_contig, Shape...>;

// Properties that return arrays take this policy: an array owns its numbers, and not the object that it is asked of.
inline constexpr auto owned = nb::rv_policy::automatic;

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
auto array_of(std::span<const Entry> given) {
  return array_of<T, W>(std::vector<Entry>(given.begin(), given.end()));
}

template <std::size_t D>
auto matrix_of(const std::array<double, D * D>& numbers) {
  std::vector<std::array<double, D>> rows(D);
  for (std::size_t k = 0; k < D * D; ++k) rows[k / D][k % D] = numbers[k];
  return array_of<double, D>(std::move(rows));
}

// A Python list of what `make` makes of each.
template <class Range, class Make>
nb::list list_of(const Range& range, const Make& make) {
  nb::list list;
  for (const auto& one : range) list.append(make(one));
  return list;
}

// numerator / denominator as a fractions.Fraction, of any length.
nb::object fraction_of(const Dyadic& numerator, const Dyadic& denominator);
// A pair of them.
nb::tuple fractions_of(const ExactPoint2& p);

// The nearest doubles.
inline Point2 rounded(const ExactPoint2& p) {
  return {nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator)};
}

// Runs without the interpreter's lock, and heeds signals: what a handler raises, as KeyboardInterrupt, ends it. `work`
// touches nothing of Python.
template <class Work>
auto unlocked(const Work& work) {
  const nb::gil_scoped_release release;
  const Interruptible interruptible([] {
    const nb::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
  });
  return work();
}

// Calls `make` without the lock, and returns its text as bytes.
template <class Make>
nb::bytes bytes_of(const Make& make) {
  const std::string text = unlocked(make);
  return nb::bytes(text.data(), text.size());
}

// --- Answers ------------------------------------------------------------------------------------------------------

// What every answer has: its cost, and a certificate that is made when it is asked for, of what the closure keeps.
struct Answer {
  Cost cost;
  std::function<std::string()> certificate_text;

  nb::bytes certificate() const { return bytes_of(certificate_text); }
};

// To a question that is answered by yes or no; in Python it is true where they meet.
struct YesNo : Answer {
  bool yes = false;
};

// A whole certificate file, of what `write` writes.
template <class Write>
std::string file_of(const Write& write) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) {
    may_be_interrupted(static_cast<std::uint32_t>(piece.size()));
    text += piece;
  });
  write(file);
  file.end();
  return text;
}

// The certificate file of an answer about an asked pair.
template <class Asked, class AnswerOf>
std::string proof_of(const Asked& asked, const AnswerOf& answer) {
  std::string text;
  prove([&](std::string_view piece) { text += piece; }, asked, answer);
  return text;
}
template <class Write>
nb::bytes bytes_of_file(const Write& write) {
  return bytes_of([&] { return file_of(write); });
}

}  // namespace sunder::python
