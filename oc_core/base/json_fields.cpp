#include "oc_core/base/json_fields.h"

#include <algorithm>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/base/json_lines.h"
#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

template <class List>
std::string commaSeparated(const List& texts) {
  std::string list;
  for (const std::string& text : texts) {
    list += list.empty() ? "" : ", ";
    list += text;
  }
  return list;
}

std::string arrayOf(size_t min, size_t max, const char* elements) {
  std::ostringstream text;
  text << "must be an array of " << min << " to " << max << " " << elements;
  return text.str();
}

}  // namespace

JsonFields::JsonFields(const nlohmann::json& object, std::string where) : object_(&object), where_(std::move(where)) {
  if (!object_->is_object()) {
    throw JsonFieldError("a JSON object { ... } is expected", this->where());
  }
}

JsonFields::JsonFields(const JsonDocument& document, UnknownFields unknown)
    : object_(&document.root()), document_(&document), unknown_(unknown) {
  if (!object_->is_object()) {
    throw JsonFieldError("a JSON object { ... } is expected", where());
  }
}

JsonFields::JsonFields(const JsonFields& outer, const nlohmann::json& object, std::string pointer,
                       const std::string& inside)
    : object_(&object),
      where_(outer.where_),
      document_(outer.document_),
      unknown_(outer.unknown_),
      pointer_(std::move(pointer)),
      inside_(outer.inside_ + inside) {
  if (!object_->is_object()) {
    throw JsonFieldError("a JSON object { ... } is expected", where());
  }
}

std::string JsonFields::placeOf(const std::string& pointer) const {
  return (document_ == nullptr ? where_ : document_->placeOf(pointer)) + inside_;
}

void JsonFields::callIt(const std::string& name) {
  inside_ += " (";
  inside_ += name;
  inside_ += ")";
}

bool JsonFields::has(const std::string& name) {
  known_.insert(name);
  return object_->contains(name);
}

void JsonFields::fail(const std::string& name, const std::string& problem) const {
  throw JsonFieldError("field \"" + name + "\" " + problem, placeOf(pointerToField(pointer_, name)));
}

const nlohmann::json& JsonFields::value(const std::string& name) {
  known_.insert(name);
  const auto found = object_->find(name);
  if (found == object_->end()) {
    fail(name, "is missing");
  }
  return *found;
}

double JsonFields::number(const std::string& name, double least, double most) {
  const nlohmann::json& field = value(name);
  if (!field.is_number()) {
    fail(name, "must be a number");
  }
  const auto number = field.get<double>();
  if (!(number >= least && number <= most)) {
    std::ostringstream range;
    range << "must lie between " << least << " and " << most << ", not " << number;
    fail(name, range.str());
  }
  return number;
}

double JsonFields::number(const std::string& name, double least, double most, double otherwise) {
  return has(name) ? number(name, least, most) : otherwise;
}

std::vector<double> JsonFields::numbers(const std::string& name, size_t count, double least, double most) {
  const nlohmann::json& field = value(name);
  const auto isInRange = [&](const nlohmann::json& element) {
    return element.is_number() && element.get<double>() >= least && element.get<double>() <= most;
  };
  if (!field.is_array() || field.size() != count || !std::all_of(field.begin(), field.end(), isInRange)) {
    std::ostringstream expected;
    expected << "must be an array of " << count << " numbers between " << least << " and " << most;
    fail(name, expected.str());
  }
  return field.get<std::vector<double>>();
}

int JsonFields::integer(const std::string& name, int least, int most) {
  const nlohmann::json& field = value(name);
  if (!field.is_number_integer()) {
    fail(name, "must be a whole number");
  }
  const auto number = field.get<double>();
  if (!(number >= least && number <= most)) {
    std::ostringstream range;
    range << "must lie between " << least << " and " << most << ", not " << field;
    fail(name, range.str());
  }
  return field.get<int>();
}

int JsonFields::integer(const std::string& name, int least, int most, int otherwise) {
  return has(name) ? integer(name, least, most) : otherwise;
}

bool JsonFields::boolean(const std::string& name, bool otherwise) {
  if (!has(name)) {
    return otherwise;
  }
  const nlohmann::json& field = value(name);
  if (!field.is_boolean()) {
    fail(name, "must be true or false");
  }
  return field.get<bool>();
}

std::string JsonFields::text(const std::string& name) {
  const nlohmann::json& field = value(name);
  if (!field.is_string()) {
    fail(name, "must be a text in quotes");
  }
  return field.get<std::string>();
}

std::string JsonFields::text(const std::string& name, const std::string& otherwise) {
  return has(name) ? text(name) : otherwise;
}

std::string JsonFields::shortText(const std::string& name, size_t maxCharacters) {
  std::string given = text(name);
  const size_t count = characterCount(given);
  if (count == 0 || count > maxCharacters) {
    std::ostringstream limits;
    limits << "must have 1 to " << maxCharacters << " characters, not " << count;
    fail(name, limits.str());
  }
  return given;
}

std::string JsonFields::shortText(const std::string& name, size_t maxCharacters, const std::string& otherwise) {
  return has(name) ? shortText(name, maxCharacters) : otherwise;
}

std::vector<std::string> JsonFields::texts(const std::string& name, size_t min, size_t max, size_t maxCharacters) {
  std::vector<std::string> texts;
  if (min == 0 && !has(name)) {
    return texts;
  }
  const nlohmann::json& list = value(name);
  if (!list.is_array() || list.size() < min || list.size() > max) {
    fail(name, arrayOf(min, max, "texts"));
  }
  for (const nlohmann::json& each : list) {
    const size_t count = each.is_string() ? characterCount(each.get_ref<const std::string&>()) : 0;
    if (count == 0 || count > maxCharacters) {
      std::ostringstream limits;
      limits << "must be an array of texts of 1 to " << maxCharacters << " characters, but entry " << texts.size() + 1
             << " is none";
      fail(name, limits.str());
    }
    texts.push_back(each.get<std::string>());
  }
  return texts;
}

std::string JsonFields::choice(const std::string& name, const std::vector<std::string>& allowed) {
  std::string given = text(name);
  if (std::find(allowed.begin(), allowed.end(), given) == allowed.end()) {
    fail(name, "must be one of " + commaSeparated(allowed) + ", not \"" + given + "\"");
  }
  return given;
}

std::string JsonFields::choice(const std::string& name, const std::vector<std::string>& allowed,
                               const std::string& otherwise) {
  return has(name) ? choice(name, allowed) : otherwise;
}

JsonFields JsonFields::inner(const std::string& name) {
  return {*this, value(name), pointerToField(pointer_, name), ", \"" + name + "\""};
}

void JsonFields::forEach(const std::string& name, size_t min, size_t max,
                         const std::function<void(JsonFields& each)>& read, const char* elements) {
  if (min == 0 && !has(name)) {
    return;
  }
  const nlohmann::json& list = value(name);
  if (!list.is_array() || list.size() < min || list.size() > max) {
    fail(name, arrayOf(min, max, elements));
  }
  const std::string pointer = pointerToField(pointer_, name);
  for (size_t i = 0; i < list.size(); ++i) {
    JsonFields each(*this, list[i], pointerToElement(pointer, i), ", \"" + name + "\" " + std::to_string(i + 1));
    read(each);
    each.rejectUnknown();
  }
}

void JsonFields::forEachNamed(const std::string& name, size_t max,
                              const std::function<void(const std::string& key, JsonFields& each)>& read,
                              const char* elements) {
  if (!has(name)) {
    return;
  }
  const nlohmann::json& object = value(name);
  if (!object.is_object() || object.size() > max) {
    std::ostringstream limits;
    limits << "must be an object of at most " << max << " " << elements << " by name";
    fail(name, limits.str());
  }
  const std::string pointer = pointerToField(pointer_, name);
  for (const auto& [key, json] : object.items()) {
    JsonFields each(*this, json, pointerToField(pointer, key), ", \"" + name + "\" " + key);
    read(key, each);
    each.rejectUnknown();
  }
}

void JsonFields::rejectUnknown() const {
  if (unknown_ == UnknownFields::kIgnored) {
    return;
  }
  for (const auto& [name, value] : object_->items()) {
    if (!known_.contains(name) && name != "$schema" && name != "comment") {
      throw InputError("field \"" + name + "\" is unknown", placeOf(pointerToField(pointer_, name)),
                       "use one of: " + commaSeparated(known_));
    }
  }
}

}  // namespace ocelli
