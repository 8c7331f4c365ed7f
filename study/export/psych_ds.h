// What a Psych-DS data set holds beside its tables (psych-ds.github.io).
#pragma once

#include <string>
#include <vector>

#include "study/export/export_columns.h"

namespace ocelli {

struct PsychDsText {
  std::string studyTitle;  ///< name of the protocol
  std::string protocolSha256;
  std::string programVersion;
  std::string dateUtc;  ///< of the export
  int subjects = 0;
  int simulatedSubjects = 0;  ///< of them
  std::vector<std::string> dataFiles;
  std::vector<ColumnMeaning> columns;  ///< of all tables, each once
};

/// dataset_description.json: schema.org, with a PropertyValue for each column.
std::string datasetDescription(const PsychDsText& text);
std::string psychDsReadme(const PsychDsText& text);
std::string psychDsChanges(const PsychDsText& text);

/// "study-NAME_KEY-VALUE_data.csv"; what is no letter or digit is left out of name and value.
std::string psychDsFileName(const std::string& study, const std::string& key, const std::string& value);

}  // namespace ocelli
