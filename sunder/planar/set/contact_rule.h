// Which kinds of contact of two segments count.
#pragma once

#include <sunder/near/set_question.h>
#include <sunder/planar/pair/segment_segment.h>

namespace sunder::planar {

bool counts(ContactKind kind, Allowed allowed);

}  // namespace sunder::planar
