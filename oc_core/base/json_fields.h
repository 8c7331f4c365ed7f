// Reading the fields of a JSON object strictly: a missing, mistyped or unknown field is an InputError that names it.
// Include it in .cpp files only: nlohmann/json is slow to compile.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

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

class JsonFields {
 public:
  /// `where` names the object in messages: a file, or file and field.
  JsonFields(const nlohmann::json& object, std::string where);

  /// Marks the field as known.
  bool has(const std::string& name);

  /// A number in [least, most] (NaN and infinity have no JSON form).
  double number(const std::string& name, double least, double most);
  double number(const std::string& name, double least, double most, double otherwise);
  /// An array of so many numbers, each in [least, most].
  std::vector<double> numbers(const std::string& name, size_t count, double least, double most);
  int integer(const std::string& name, int least, int most);
  int integer(const std::string& name, int least, int most, int otherwise);
  bool boolean(const std::string& name, bool otherwise);
  std::string text(const std::string& name);
  std::string text(const std::string& name, const std::string& otherwise);
  /// The raw value; marks the field as known. Throws where it is missing.
  const nlohmann::json& value(const std::string& name);

  /// Throws for every field that nothing above asked for. `$schema` and `comment` are always allowed.
  void rejectUnknown() const;

  /// The object that these are the fields of, as messages name it.
  const std::string& where() const { return where_; }
  [[noreturn]] void fail(const std::string& name, const std::string& problem) const;

 private:
  const nlohmann::json& object_;
  std::string where_;
  std::set<std::string> known_;
};

/// JSON as text, in one line or indented. Names of files, objects and cameras may hold any bytes: those that are not
/// UTF-8 become U+FFFD, so that every reader takes the text.
std::string textOfJson(const nlohmann::ordered_json& json, int indent = -1);

/// Parses a JSON file (// and /* */ comments allowed); an InputError says file, line and column. Throws for more than
/// 100 levels of brackets too.
nlohmann::json readJsonFile(const std::filesystem::path& path);
nlohmann::json parseJson(const std::string& text, const std::string& where);

}  // namespace ocelli
