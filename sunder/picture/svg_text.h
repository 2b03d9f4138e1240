// Text in pictures.
#pragma once

#include <string>
#include <string_view>

namespace sunder::picture {

// The text as it stands in XML, also within quotes. Two code points that UTF-8 has and XML has not become '?'. Requires
// UTF-8 without control characters, as io::one_line gives.
std::string escaped(std::string_view text);

}  // namespace sunder::picture
