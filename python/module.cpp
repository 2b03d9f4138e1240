#include <sunder/version.h>

#include "common.h"

#include <exception>

namespace sunder::python {

namespace {

void set_error(const Error& error) {
  const nb::object type = nb::module_::import_("sunder._error").attr("Error");
  PyErr_SetObject(type.ptr(), type(std::string(name_of(error.code())), error.place(), error.text()).ptr());
}

}  // namespace

void translate_errors() {
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Error& error) {
      set_error(error);
    }
  });
}

Doubles doubles_of(nb::handle given, const char* place, std::initializer_list<std::vector<int>> shapes) {
  nb::list allowed;
  for (const std::vector<int>& shape : shapes) allowed.append(nb::tuple(nb::cast(shape)));
  return nb::cast<Doubles>(nb::module_::import_("sunder._arrays").attr("doubles")(given, place, *allowed));
}

std::vector<std::uint32_t> groups_of(nb::handle given, std::size_t size) {
  if (given.is_none()) return {};
  const auto numbers = nb::cast<nb::ndarray<const std::uint32_t, nb::c_contig, nb::device::cpu>>(
      nb::module_::import_("sunder._arrays").attr("numbers_of_groups")(given, size));
  return {numbers.data(), numbers.data() + numbers.size()};
}

namespace {

struct MantissaAndExponent {
  nb::object mantissa;
  std::int64_t exponent;
};

// By hexadecimal digits: of decimal ones Python reads 4300 at most.
MantissaAndExponent parts_of(const Dyadic& x) {
  const std::string text = x.hexadecimal();
  const std::size_t p = text.find('p');
  PyObject* const mantissa = PyLong_FromString(text.substr(0, p).c_str(), nullptr, 16);
  if (mantissa == nullptr) throw nb::python_error();
  return {nb::steal(mantissa), std::stoll(text.substr(p + 1))};
}

}  // namespace

nb::object fraction_of(const Dyadic& numerator, const Dyadic& denominator) {
  auto [n, n_exponent] = parts_of(numerator);
  auto [d, d_exponent] = parts_of(denominator);
  const std::int64_t shift = n_exponent - d_exponent;
  if (shift > 0) n = n << nb::int_(shift);
  if (shift < 0) d = d << nb::int_(-shift);
  return nb::module_::import_("fractions").attr("Fraction")(n, d);
}

nb::tuple fractions_of(const ExactPoint2& p) {
  return nb::make_tuple(fraction_of(p.x, p.denominator), fraction_of(p.y, p.denominator));
}

void bind_answers(nb::module_& module) {
  nb::class_<Cost>(module, "Cost", "What a question cost, in counts that are the same on every machine.")
      .def_ro("probes", &Cost::probes, "vertices, pairs or signs that were looked at: each question says which")
      .def_ro("iterations", &Cost::iterations, "steps of the search")
      .def_ro("exact", &Cost::exact, "signs that exact arithmetic decided")
      .def_ro("proposals", &Cost::proposals, "what the search proposed, until one held");
  nb::class_<Answer>(module, "Answer", "The answer to a question.")
      .def_ro("cost", &Answer::cost)
      .def("certificate", &Answer::certificate, "The certificate file that proves the answer, for sunder_verify.");
  nb::class_<YesNo, Answer>(module, "YesNo", "The answer to a question whether some meet; true where they do.")
      .def_ro("meet", &YesNo::yes)
      .def("__bool__", [](const YesNo& answer) { return answer.yes; });
}

}  // namespace sunder::python

// The extension module sunder._sunder. Its folders of names are those of the library.
NB_MODULE(_sunder, module) {
  using namespace sunder::python;  // NOLINT(google-build-using-namespace): of this folder
  module.attr("__version__") = std::string(sunder::version);
  translate_errors();
  bind_answers(module);
  nb::module_ planar = module.def_submodule("planar"), solid = module.def_submodule("solid"),
              polytope = module.def_submodule("polytope");
  bind_planar(module, planar);
  bind_polygons(planar);
  bind_sets(planar);
  bind_regions(planar);
  bind_solid(module, solid);
  bind_flats(module, solid);
  bind_polytopes(module, polytope);
  bind_robots(module);
  bind_ask(module);
}
