// What sunder region was asked, for its kinds of objects.
#pragma once

#include <sunder/ask/question.h>
#include <sunder/ask/set/polygons_input.h>

#include <string>

namespace sunder::ask {

struct RegionCall : QuestionCall {
  std::string file;
  std::string of = "half-planes";
  std::string maximize;
  PolygonsRequest polygons;  // how they are read
};

}  // namespace sunder::ask
