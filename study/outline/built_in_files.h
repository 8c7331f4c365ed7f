// Files of protocols/ that are part of the program, so that it needs no folder of data.
#pragma once

#include <string>
#include <vector>

namespace ocelli {

struct BuiltInFile {
  std::string name;  ///< in the source tree: "protocols/languages/en.json"
  std::string text;
};

/// protocols/languages/*.json, English first.
std::vector<BuiltInFile> builtInLanguages();
/// protocols/questionnaires/*.json.
std::vector<BuiltInFile> builtInQuestionnaires();

}  // namespace ocelli
