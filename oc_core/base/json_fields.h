// Reading the fields of a JSON object strictly: a missing, mistyped or unknown field is an InputError that names it.
// Include it in .cpp files only: nlohmann/json is slow to compile.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace ocelli {

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

/// Parses a JSON file (// and /* */ comments allowed); an InputError says file, line and column. Throws for more than
/// 100 levels of brackets too.
nlohmann::json readJsonFile(const std::filesystem::path& path);
nlohmann::json parseJson(const std::string& text, const std::string& where);

}  // namespace ocelli
