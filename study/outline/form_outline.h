// Forms of a protocol: "demographics" and "survey", those of the lists "before" and "after", and those after a block. A
// form is written out, or names a questionnaire that the program has.
#pragma once

#include <string>
#include <vector>

#include "study/outline/form_field.h"

namespace ocelli {

struct ProtocolForm {
  std::string name;  ///< as the data call it: "demographics", "survey", "ssq before", "ssq after find moving"
  std::string title;
  std::string introduction{};
  std::vector<FormField> fields;
  std::string questionnaire{};  ///< of study/outline/questionnaire.h; empty where the protocol writes the form out
};

/// What all readers of forms need.
struct FormSetting {
  const ViewConditions& conditions;
  ProtocolReading reading = ProtocolReading::kByStudy;
  std::string language = kSourceLanguage;
};

/// A form that is written out, from its own fields. Throws InputError naming the field.
ProtocolForm readFormOutline(JsonFields& fields, const std::string& name, const FormSetting& setting);

/// Forms of a list: {"questionnaire": "ssq"}, or {"name": "fatigue", "title": ..., "fields": ...}. Each is called by
/// its name and by when it is asked: "ssq before". A missing field is an empty list. An analysis leaves out
/// questionnaires that this program does not know. Throws InputError naming the field.
std::vector<ProtocolForm> readFormList(JsonFields& fields, const std::string& name, const std::string& when,
                                       const FormSetting& setting);

/// All forms of a protocol, from the fields of the whole: demographics, those before, those after each block, those
/// after, survey. For whoever reads stored protocols and knows no tasks.
std::vector<ProtocolForm> readAllForms(JsonFields& protocol, const FormSetting& setting);
/// The same of a protocol's text, with its own language and conditions. Throws InputError that names `where`.
std::vector<ProtocolForm> formsOfProtocolText(const std::string& text, const std::string& where);

}  // namespace ocelli
