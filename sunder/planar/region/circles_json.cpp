#include <sunder/planar/region/circles_json.h>
#include <sunder/planar/set/tables_json.h>
#include <sunder/predicate/disc_powers.h>

namespace sunder::planar {

namespace {

void append_weights(std::string& text, const Circles& circles, const CirclesDeepest& deepest) {
  const DeepestWeights weights = deepest_weights(discs_of(circles.all(), deepest.basis()));
  text += ", \"discs\": ";
  append_indices(text, deepest.basis());
  text += ", \"weights\": [";
  for (std::uint32_t k = 0; k < deepest.count; ++k) {
    if (k > 0) text += ", ";
    text += '"' + fraction_text(weights.numerators[k], weights.denominator) + '"';
  }
  text += ']';
}

}  // namespace

std::string certificate_text(const Circles& circles, const CirclesPart& part) {
  std::string text = json_file_begin;
  append_circles(text, circles.all());
  text +=
      ",\n \"statements\": [\n  {\"question\": \"circles\", \"verdict\": \"" + std::string(name_of(part.kind)) + '"';
  if (part.kind == CirclesPartKind::region) {
    text += ", \"point\": ";
    append_point(text, deepest_point(discs_of(circles.all(), part.deepest.basis())));
    text += ", \"arcs\": ";
    append_indices(text, part.arcs);
  } else if (part.kind != CirclesPartKind::plane) {
    append_weights(text, circles, part.deepest);
  }
  return text + "}]}\n";
}

}  // namespace sunder::planar
