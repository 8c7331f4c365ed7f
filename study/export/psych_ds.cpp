#include "study/export/psych_ds.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace ocelli {
namespace {

std::string lettersAndDigits(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) {
      result += c;
    }
  }
  return result.empty() ? "unnamed" : result;
}

std::string describeSubjects(const PsychDsText& text) {
  if (text.simulatedSubjects == 0) {
    return fmt::format("{} subjects, all of them people", text.subjects);
  }
  if (text.simulatedSubjects == text.subjects) {
    return fmt::format("{} subjects, ALL OF THEM SIMULATED: no person took part", text.subjects);
  }
  return fmt::format("{} subjects, {} of them SIMULATED (column simulated)", text.subjects, text.simulatedSubjects);
}

}  // namespace

std::string datasetDescription(const PsychDsText& text) {
  nlohmann::ordered_json json = {
      {"@context", "https://schema.org/"},
      {"@type", "Dataset"},
      {"name", text.studyTitle},
      {"description",
       fmt::format(
           "Trials of the perception study \"{}\", which compares planar pinhole cameras with graph cameras: {}. "
           "Protocol with SHA-256 {}, exported by ocelli {}.",
           text.studyTitle, describeSubjects(text), text.protocolSha256, text.programVersion)},
      {"dateModified", text.dateUtc.substr(0, 10)},
      {"variableMeasured", nlohmann::ordered_json::array()}};
  for (const ColumnMeaning& column : text.columns) {
    nlohmann::ordered_json variable = {
        {"@type", "PropertyValue"}, {"name", column.name}, {"description", column.description}};
    if (!column.unit.empty()) {
      variable["unitText"] = column.unit;
    }
    json["variableMeasured"].push_back(std::move(variable));
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string psychDsReadme(const PsychDsText& text) {
  std::string readme = fmt::format(
      "# {}\n\nData of a perception study: {}.\n\nSubjects have pseudonyms. Which person is which is not in this data "
      "set.\n\nEach file of `data/` is a table (CSV, UTF-8); each row says in the column `simulated` whether a person "
      "or a "
      "simulated subject gave it. `dataset_description.json` says what each column means. In tables of trials and "
      "answers use the rows where `counts` is 1: the others are practice, attempts that were repeated, or were cut "
      "short. Texts that a spreadsheet would take for formulas have a `'` in front.\n\n`materials/protocol.json` is "
      "the "
      "protocol of the study.\n\n## Files\n\n",
      text.studyTitle, describeSubjects(text));
  for (const std::string& file : text.dataFiles) {
    readme += fmt::format("- `{}`\n", file);
  }
  return readme;
}

std::string psychDsChanges(const PsychDsText& text) {
  return fmt::format("# Changes\n\n## {}\n\nExported by ocelli {}: {}.\n", text.dateUtc.substr(0, 10),
                     text.programVersion, describeSubjects(text));
}

std::string psychDsFileName(const std::string& study, const std::string& key, const std::string& value) {
  return fmt::format("study-{}_{}-{}_data.csv", lettersAndDigits(study), key, lettersAndDigits(value));
}

}  // namespace ocelli
