// Checks a certificate file of version 2 (docs/claims.md).
#pragma once

#include <verifier/statement_reader.h>
#include <verifier/sunder_verify.h>

namespace sunder_verifier {

bool is_of_claims(const json& top);

// Throws Refused where the form is wrong, and TooLong.
void verify_claims(const json& top, FileResult& result);

}  // namespace sunder_verifier
