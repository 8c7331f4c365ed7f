// What the tasks share whose answer is where an object is, as a number: one object a case, which stands in a maze, and
// a subject who stands there too and looks at it in the views of a condition. Nobody walks.
#pragma once

#include <string>
#include <vector>

#include "study/task/eye_camera.h"
#include "study/task/instruction_image.h"

namespace ocelli {

class JsonFields;

struct EstimatedCase {
  std::string label;
  Landmark object;
};

class EstimatedObjects {
 public:
  /// Reads "maze", "start", "object", "fov_horizontal_degrees", "portals" and the cases. Throws InputError naming the
  /// field.
  EstimatedObjects(JsonFields& fields, const std::string& caseField, const TaskSetting& setting);

  int caseCount() const { return static_cast<int>(cases_.size()); }
  const EstimatedCase& caseOf(int index) const;
  const WalkerPose& start() const { return start_; }
  const Controls& controls() const { return controls_; }
  /// Of the object on the floor, (east, south), metres.
  glm::dvec2 placeOf(int index) const;
  /// In a straight line on the floor from where one stands, metres.
  double metersTo(int index) const;
  /// The direction in the maze relative to where one looks, clockwise, 0 to below 360 degrees.
  double degreesTo(int index) const;

  /// Scene, objects and views within `place`.
  TrialLayout layoutOf(int index, TrialView view, const PixelRect& place) const;
  /// Throws InputError where a condition does not show all of the object of a case, at a moment when its views have
  /// `place`, which is of `screen`.
  void checkShown(const TrialScreen& screen, const PixelRect& place, const std::string& where) const;

 private:
  Maze maze_;
  Controls controls_;
  ViewConditions conditions_;
  WalkerPose start_{};
  std::vector<EstimatedCase> cases_{};
  EyeCamera camera_;
  StudyScene scene_;
};

/// A hall, with corridors to its sides, and an object in it.
InstructionExample estimateExample(TrialView view, const glm::ivec2& size);

}  // namespace ocelli
