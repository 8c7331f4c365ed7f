// Reading JSON that people wrote. For .cpp files: it shows nlohmann/json.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>

namespace ocelli {

/// A JSON text and where its values stand. Comments are allowed.
class JsonText {
 public:
  /// Throws InputError with line and column where it is no JSON, where a field stands twice in an object, or where
  /// it is nested deeper than 100 levels. `where` is the file; `schema` describes all fields of such a file, and is
  /// named where one of them is wrong.
  JsonText(std::string_view text, std::string where, std::string schema);

  const nlohmann::json& root() const { return root_; }
  /// "FILE:LINE" of the value that a JSON pointer ("/models/0/task") leads to, or of the nearest around it.
  std::string placeOf(const std::string& pointer) const;
  const std::string& schema() const { return schema_; }

 private:
  std::string where_;
  std::string schema_;
  nlohmann::json root_;
  std::map<std::string, int> lines_;  ///< by pointer
};

/// The fields of an object; a missing, mistyped or unknown one is an InputError with line and field.
class JsonObject {
 public:
  JsonObject(const JsonText& text, const nlohmann::json& object, std::string pointer);

  bool has(const char* name);
  std::string text(const char* name, size_t maxBytes);
  std::string textOr(const char* name, size_t maxBytes, const std::string& otherwise);
  double number(const char* name, double least, double most);
  double numberOr(const char* name, double least, double most, double otherwise);
  int64_t integerOr(const char* name, int64_t least, int64_t most, int64_t otherwise);
  bool booleanOr(const char* name, bool otherwise);
  /// Marks the field as known. Throws where it is missing.
  const nlohmann::json& value(const char* name);
  /// Calls `read` for each object of an array; not at all where the field is missing.
  void forEach(const char* name, size_t most, const std::function<void(JsonObject& element)>& read);
  std::vector<std::string> texts(const char* name, size_t most, size_t maxBytes);

  /// Throws for every field that nothing above asked for. `$schema` and `comment` are always allowed.
  void rejectUnknown() const;
  [[noreturn]] void fail(const std::string& name, const std::string& problem) const;

 private:
  const JsonText* text_;
  const nlohmann::json* object_;
  std::string pointer_;
  std::set<std::string> known_;
};

}  // namespace ocelli
