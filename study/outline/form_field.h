// A question of a form: an object in the field "fields" of the forms of a protocol, "demographics" and "survey".
#pragma once

#include <string>
#include <vector>

#include "study/outline/protocol_reading.h"
#include "study/trial/view_condition.h"

namespace ocelli {

class JsonFields;

struct FormField {
  std::string name;  ///< of the answer in the database: "age_band"
  std::string question;
  std::vector<std::string> options;  ///< one is chosen; in a study always at least two
  std::vector<std::string> ends{};   ///< of a scale: what its first and last option mean; empty, or two
  std::vector<TrialView> favors{};   ///< of a scale that compares two conditions: which one its first and its last
                                     ///< option speak for; empty, or two
};

/// An analysis takes a field without a question, which is then its name, and one without options, which takes any text.
/// Throws InputError naming the field.
FormField readFormField(JsonFields& fields, const ViewConditions& conditions, ProtocolReading reading);

}  // namespace ocelli
