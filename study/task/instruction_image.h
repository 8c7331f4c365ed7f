// An image of instruction pages: what a trial of a task looks like, in a scene of its own.
#pragma once

#include <glm/vec2.hpp>
#include <memory>

#include "study/task/trial_layout.h"

namespace ocelli {

struct InstructionExample {
  std::shared_ptr<const StudyScene> scene{};  ///< of the layout's views; empty where there are none
  TrialLayout layout{};                       ///< views, or choices and maps
};

struct InstructionImage {
  const char* name;           ///< "picture" of a page of a protocol
  bool marksObjects = false;  ///< by a ring around each that the first view shows
  /// Laid out in so many pixels, from (0, 0).
  InstructionExample (*make)(const glm::ivec2& size) = nullptr;
};

/// An eye in such a scene: from the middle of a cell, or as far behind it as walls allow.
PinholeCamera exampleEye(const Maze& maze, const MazeCell& cell, Direction heading, double backMeters,
                         const glm::ivec2& size);

/// All of an image.
PixelRect wholeImage(const glm::ivec2& size);

}  // namespace ocelli
