// A straight way from one point to another, of rays that need no more than that.
#pragma once

#include <glm/vec3.hpp>

namespace ocelli {

struct SightLine {
  glm::vec3 from{0};
  glm::vec3 to{0};
};

}  // namespace ocelli
