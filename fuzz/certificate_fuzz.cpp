// Fuzzes the C++ verifier: any text gets a consistent result, without a throw, a crash or much memory.
// Seeds: cases/certificates/accepted and cases/certificates/refused.
#include <fuzz/require.h>

#include <verifier/cpp/verify.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

using sunder::fuzz::require;
namespace {

// Of pairs, distances, clearances, depths and motions; of sections; of sets; of common parts; of linear programs;
// of valid polygons; of hulls.
constexpr std::array<std::string_view, 46> verdicts{"apart",
                                                    "meet",
                                                    "touching",
                                                    "overlapping",
                                                    "closest",
                                                    "none",
                                                    "some",
                                                    "these",
                                                    "count",
                                                    "empty",
                                                    "point",
                                                    "segment",
                                                    "ray",
                                                    "line",
                                                    "strip",
                                                    "half-plane",
                                                    "unbounded",
                                                    "bounded",
                                                    "plane",
                                                    "region",
                                                    "one",
                                                    "many",
                                                    "all",
                                                    "infeasible",
                                                    "valid",
                                                    "too_few_points",
                                                    "edges_meet",
                                                    "comes_twice",
                                                    "misplaced",
                                                    "circle",
                                                    "repeated",
                                                    "rings_touch",
                                                    "kept",
                                                    "broken",
                                                    "crosses",
                                                    "falls_apart",
                                                    "solid",
                                                    "flat",
                                                    "nothing",
                                                    "outlined",
                                                    "first",
                                                    "facets",
                                                    "at_most",
                                                    "at_least",
                                                    "apart_by_hyperplanes",
                                                    "vertices"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const sunder_verifier::FileResult result = sunder_verifier::verify_text(text, "fuzz");
  require(result.readable == result.error.empty());
  require(result.error.find('\n') == std::string::npos);
  if (!result.readable || !result.failed_form.empty()) require(result.statements.empty());
  bool accepted = result.readable && result.failed_form.empty();
  for (const sunder_verifier::StatementResult& pair : result.statements) {
    require(std::find(verdicts.begin(), verdicts.end(), pair.verdict) != verdicts.end());
    require(pair.accepted == pair.failed_check.empty() && pair.accepted == pair.reason.empty());
    accepted = accepted && pair.accepted;
  }
  require(accepted == result.accepted());
  return 0;
}
