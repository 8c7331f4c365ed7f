// Reading the fields of a JSON object strictly: a missing, mistyped or unknown field is an InputError that names it.
// Include it in .cpp files only: nlohmann/json is slow to compile.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "oc_core/base/json_document.h"

namespace ocelli {

/// What rejectUnknown() does: files that other versions of the toolkit wrote may have fields that this one does not
/// know.
enum class UnknownFields { kRejected, kIgnored };

class JsonFields {
 public:
  /// `where` names the object in messages: a file, or file and field.
  JsonFields(const nlohmann::json& object, std::string where);
  /// Messages name file and line of the field. The document must live as long as the fields and those inside of them.
  explicit JsonFields(const JsonDocument& document, UnknownFields unknown = UnknownFields::kRejected);
  explicit JsonFields(JsonDocument&& document, UnknownFields unknown = UnknownFields::kRejected) = delete;

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
  /// A text of 1 to so many characters of UTF-8.
  std::string shortText(const std::string& name, size_t maxCharacters);
  std::string shortText(const std::string& name, size_t maxCharacters, const std::string& otherwise);
  /// An array of `min` to `max` texts, each of 1 to so many characters. A missing field is an empty array.
  std::vector<std::string> texts(const std::string& name, size_t min, size_t max, size_t maxCharacters);
  /// One of the texts.
  std::string choice(const std::string& name, const std::vector<std::string>& allowed);
  std::string choice(const std::string& name, const std::vector<std::string>& allowed, const std::string& otherwise);
  /// One of the values, which stand in files as nameOf() writes them.
  template <class List>
  auto choiceOf(const std::string& name, const List& choices);
  template <class List, class Choice>
  Choice choiceOf(const std::string& name, const List& choices, const Choice& otherwise);

  /// The fields of the object in a field: messages say `, "name"` after the place. The caller calls rejectUnknown().
  JsonFields inner(const std::string& name);
  /// Calls `read`, then rejectUnknown(), for each of `min` to `max` objects of an array: messages say `, "name" 2`. A
  /// missing field is an empty array. `elements` is what messages call them.
  void forEach(const std::string& name, size_t min, size_t max, const std::function<void(JsonFields& each)>& read,
               const char* elements = "objects");

  /// The same for at most so many objects in an object: messages say `, "name" key`.
  void forEachNamed(const std::string& name, size_t max,
                    const std::function<void(const std::string& key, JsonFields& each)>& read,
                    const char* elements = "objects");

  /// The raw value; marks the field as known. Throws where it is missing.
  const nlohmann::json& value(const std::string& name);

  /// Throws for every field that nothing above asked for, unless these are ignored. `$schema` and `comment` are always
  /// allowed.
  void rejectUnknown() const;

  /// The object that these are the fields of, as messages name it.
  std::string where() const { return placeOf(pointer_); }
  /// Messages say ` (name)` after the object.
  void callIt(const std::string& name);
  [[noreturn]] void fail(const std::string& name, const std::string& problem) const;

 private:
  /// An object inside of the object of `outer`.
  JsonFields(const JsonFields& outer, const nlohmann::json& object, std::string pointer, const std::string& inside);

  /// Of a field, or of the object itself.
  std::string placeOf(const std::string& pointer) const;

  const nlohmann::json* object_;
  std::string where_;                       ///< of fields without a document
  const JsonDocument* document_ = nullptr;  ///< or nothing
  UnknownFields unknown_ = UnknownFields::kRejected;
  std::string pointer_;  ///< to the object in the document
  std::string inside_;   ///< what stands after the place: ", \"blocks\" 2"
  std::set<std::string> known_;
};

template <class List>
auto JsonFields::choiceOf(const std::string& name, const List& choices) {
  std::vector<std::string> names;
  for (const auto& each : choices) {
    names.emplace_back(nameOf(each));
  }
  const std::string given = choice(name, names);
  size_t index = 0;
  while (names[index] != given) {
    ++index;
  }
  return choices[index];
}

template <class List, class Choice>
Choice JsonFields::choiceOf(const std::string& name, const List& choices, const Choice& otherwise) {
  return has(name) ? choiceOf(name, choices) : otherwise;
}

}  // namespace ocelli
