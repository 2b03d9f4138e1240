// sunder simple FILE where FILE is a mesh: does it bound a body, and does it cross itself?
#pragma once

#include <sunder/ask/report.h>
#include <sunder/ask/talk.h>
#include <sunder/ask/verb.h>

#include <string>

namespace sunder::ask {

struct SimpleMeshCall : QuestionCall {
  std::string file;
  bool all = false;  // list all crossings; else one
  bool leave_out = false;
};

// Throws Error for what is no mesh of polygons.
Report run_simple_mesh(const SimpleMeshCall& call, Talk& talk);

}  // namespace sunder::ask
