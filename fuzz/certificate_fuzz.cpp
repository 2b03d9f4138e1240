// Fuzzes the C++ verifier: any text gets a consistent result, without a throw, a crash or much memory.
// Seeds: cases/certificates/accepted and cases/certificates/refused.
#include <fuzz/require.h>

#include <verifier/cpp/verify.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

using sunder::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const sunder_verifier::FileResult result = sunder_verifier::verify_text(text, "fuzz");
  require(result.readable == result.error.empty());
  require(result.error.find('\n') == std::string::npos);
  if (!result.readable || !result.failed_form.empty()) require(result.statements.empty());
  bool accepted = result.readable && result.failed_form.empty();
  for (const sunder_verifier::StatementResult& pair : result.statements) {
    require(sunder_verifier::is_verdict_of(pair.question, pair.verdict));
    require(pair.accepted == pair.failed_check.empty() && pair.accepted == pair.reason.empty());
    accepted = accepted && pair.accepted;
  }
  require(accepted == result.accepted());
  return 0;
}
