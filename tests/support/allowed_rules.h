// What pairs of a set may do to each other.
#pragma once

#include <sunder/near/set_question.h>

#include <array>

namespace sunder::tests {

constexpr std::array<Allowed, 3> allowed_rules{Allowed::nothing, Allowed::shared_endpoint, Allowed::touch};

}  // namespace sunder::tests
