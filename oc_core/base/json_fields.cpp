#include "oc_core/base/json_fields.h"

#include <algorithm>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli {
namespace {

constexpr int kMaxDepth = 100;

}  // namespace

JsonFieldError::JsonFieldError(const std::string& problem, const std::string& where)
    : InputError(problem, where, "see docs/files.md"), problem_(problem), where_(where) {}

JsonFields::JsonFields(const nlohmann::json& object, std::string where) : object_(object), where_(std::move(where)) {
  if (!object_.is_object()) {
    throw JsonFieldError("a JSON object { ... } is expected", where_);
  }
}

bool JsonFields::has(const std::string& name) {
  known_.insert(name);
  return object_.contains(name);
}

void JsonFields::fail(const std::string& name, const std::string& problem) const {
  throw JsonFieldError("field \"" + name + "\" " + problem, where_);
}

const nlohmann::json& JsonFields::value(const std::string& name) {
  known_.insert(name);
  const auto found = object_.find(name);
  if (found == object_.end()) {
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
  if (!value(name).is_number_integer()) {
    fail(name, "must be a whole number");
  }
  return static_cast<int>(number(name, least, most));
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

void JsonFields::rejectUnknown() const {
  for (const auto& [name, value] : object_.items()) {
    if (!known_.contains(name) && name != "$schema" && name != "comment") {
      std::string allowed;
      for (const std::string& field : known_) {
        allowed += allowed.empty() ? field : ", " + field;
      }
      throw InputError("field \"" + name + "\" is unknown", where_, "use one of: " + allowed);
    }
  }
}

std::string textOfJson(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

nlohmann::json parseJson(const std::string& text, const std::string& where) {
  // What reads and writes a document follows it down: far deeper than any file of ours it would run out of stack.
  // Of two fields of one name the parser would keep the last; comments are not read.
  std::vector<std::set<std::string>> names;
  const auto check = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    if (depth > kMaxDepth) {
      throw JsonFieldError("this JSON is nested deeper than " + std::to_string(kMaxDepth) + " levels", where);
    }
    using Event = nlohmann::json::parse_event_t;
    if (event == Event::object_start) {
      names.emplace_back();
    } else if (event == Event::object_end) {
      names.pop_back();
    } else if (event == Event::key) {
      const auto& name = parsed.get_ref<const std::string&>();
      if (!names.back().insert(name).second && name != "comment") {
        throw InputError("field \"" + name + "\" stands twice in one object", where, "keep one of them");
      }
    }
    return true;
  };
  try {
    return nlohmann::json::parse(text, check, true, true);
  } catch (const nlohmann::json::parse_error& error) {
    const size_t at = std::min<size_t>(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const size_t lineStart = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const size_t column = at - (lineStart == std::string::npos ? 0 : lineStart + 1) + 1;
    throw InputError("this is not valid JSON", where + ":" + std::to_string(line) + ":" + std::to_string(column),
                     "look for a missing comma, quote or bracket there");
  } catch (const nlohmann::json::out_of_range&) {
    throw InputError("a number in this JSON is too large", where, "keep numbers below 1.8e308");
  }
}

nlohmann::json readJsonFile(const std::filesystem::path& path) {
  return parseJson(readFile(path, kMaxTextBytes), path.string());
}

}  // namespace ocelli
