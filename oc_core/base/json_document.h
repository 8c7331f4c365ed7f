// JSON texts: parsing, with errors that say file, line and column; and documents that know the lines of their values.
// Include it in .cpp files only: nlohmann/json is slow to compile.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "oc_core/base/error.h"

namespace ocelli {

/// What is wrong with a field, or with what should be an object. It names no schema yet: readAs() does.
class JsonFieldError : public InputError {
 public:
  JsonFieldError(const std::string& problem, const std::string& where);

  const std::string& problem() const { return problem_; }
  const std::string& where() const { return where_; }

 private:
  std::string problem_;
  std::string where_;
};

/// Calls `read`, which reads a file of one kind. What it finds wrong with a field then says where all fields of such a
/// file are described: `description` is a path in the source tree, also where the toolkit is installed (docs/files.md).
template <class Read>
auto readAs(const char* description, const Read& read) {
  try {
    return read();
  } catch (const JsonFieldError& error) {
    throw InputError(error.problem(), error.where(), std::string("see ") + description);
  }
}

/// JSON as text, in one line or indented. Names of files, objects and cameras may hold any bytes: those that are not
/// UTF-8 become U+FFFD, so that every reader takes the text.
std::string textOfJson(const nlohmann::ordered_json& json, int indent = -1);

/// Parses a JSON file (// and /* */ comments allowed); an InputError says file, line and column. Throws for more than
/// 100 levels of brackets, and for a field that stands twice in one object, too.
nlohmann::json readJsonFile(const std::filesystem::path& path);
nlohmann::json parseJson(const std::string& text, const std::string& where);

/// A JSON text and where its values stand.
class JsonDocument {
 public:
  /// `where` is the file. Throws as parseJson() does.
  JsonDocument(const std::string& text, std::string where);

  const nlohmann::json& root() const { return root_; }
  /// "FILE:LINE" of the value that a JSON pointer ("/models/0/task") leads to, or of the nearest around it.
  std::string placeOf(const std::string& pointer) const;

 private:
  std::string where_;
  nlohmann::json root_;
  std::map<std::string, int> lines_;  ///< by pointer
};

}  // namespace ocelli
