// The options of representations, each described once: what reads files, the JSON Schema, the viewer's form and the
// documentation follow from this table.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

struct CameraOption {
  /// Where a choice keeps the value.
  using Place = std::variant<float& (*)(CameraChoice&), int& (*)(CameraChoice&), bool& (*)(CameraChoice&),
                             glm::vec3& (*)(CameraChoice&)>;
  /// An option that takes the place of another way: a file that names it turns it on.
  struct Switch {
    bool (*isOn)(const CameraChoice&) = nullptr;
    void (*turn)(CameraChoice&, bool) = nullptr;
  };

  const char* name;     ///< of the field in a file
  const char* label;    ///< in a form: a word or two
  const char* unit;     ///< of the number; empty where it is a ratio or a count
  const char* meaning;  ///< a sentence without its full stop
  Place place;
  double min = 0;  ///< of a number, and of each component of a direction
  double max = 0;
  double formMin = 0;  ///< what a form offers: the part of the range that is of use
  double formMax = 0;
  bool isDetail = false;  ///< a form shows it on demand
  Switch onOff = {};
  void (*afterChange)(CameraChoice&) = nullptr;  ///< what else follows from a new value
};

/// An option that is no number: a word, or a list of objects.
struct CameraStructure {
  const char* name;
  const char* meaning;
  std::string (*schema)();                   ///< of the field, as JSON: a type at least, and its default
  std::string (*text)(const CameraChoice&);  ///< the value of a choice, as JSON
  void (*read)(JsonFields&, CameraChoice&);  ///< where the field is there; throws InputError
};

extern const CameraOption kCellSide;
extern const CameraOption kSegmentDirection;
/// In the order in which forms and tables show them.
const std::vector<const CameraOption*>& spocOptions();
const std::vector<const CameraOption*>& eocOptions();
const std::vector<const CameraOption*>& ddocOptions();
const std::vector<const CameraOption*>& cellOptions();
/// How the samples of a general pinhole camera lie: gpc_layout.h.
const std::vector<const CameraStructure*>& gpcStructures();

/// The value of a number, a count or a switch (0 or 1).
double numberOf(const CameraOption& option, const CameraChoice& choice);
/// Sets it without a check: the caller must have checked the range.
void setNumber(const CameraOption& option, CameraChoice& choice, double value);
glm::vec3 directionOf(const CameraOption& option, const CameraChoice& choice);
void setDirection(const CameraOption& option, CameraChoice& choice, const glm::vec3& direction);

bool isInteger(const CameraOption& option);
bool isBoolean(const CameraOption& option);
bool isDirection(const CameraOption& option);

}  // namespace ocelli
