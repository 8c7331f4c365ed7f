#include "analysis/dataset/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr int kMaxDepth = 100;

[[noreturn]] void fail(const std::string& what, const std::string& where, const std::string& next) {
  throw InputError(what, where, next);
}

std::string escapedForPointer(const std::string& name) {
  std::string escaped;
  for (const char c : name) {
    escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return escaped;
}

/// Goes through a text that is known to be JSON, and notes the line of each value, or of the name before it.
class LineWalk {
 public:
  LineWalk(std::string_view text, std::map<std::string, int>& lines) : text_(text), lines_(lines) {}

  void value(const std::string& pointer) {
    skipSpace();
    lines_.emplace(pointer, line_);
    if (peek() == '{') {
      members(pointer);
    } else if (peek() == '[') {
      elements(pointer);
    } else if (peek() == '"') {
      quoted();
    } else {
      while (at_ < text_.size() && std::string_view(",]} \t\r\n/").find(text_[at_]) == std::string_view::npos) {
        ++at_;
      }
    }
    skipSpace();
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void step() {
    line_ += peek() == '\n' ? 1 : 0;
    at_ += at_ < text_.size() ? 1 : 0;
  }
  void skipSpace() {
    while (at_ < text_.size()) {
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("//")) {
        // As the parser: a comment ends with its line, or with a byte of 0.
        const size_t end = text_.find_first_of(std::string_view("\n\r\0", 3), at_);
        while (at_ < std::min(end, text_.size() - 1) + 1) {
          step();
        }
      } else if (rest.starts_with("/*")) {
        const size_t end = text_.find("*/", at_ + 2);
        while (at_ < std::min(end, text_.size() - 2) + 2) {
          step();
        }
      } else if (std::string_view(" \t\r\n\xef\xbb\xbf").find(peek()) != std::string_view::npos) {
        step();
      } else {
        return;
      }
    }
  }
  std::string quoted() {
    const size_t begin = at_;
    step();
    while (at_ < text_.size() && peek() != '"') {
      if (peek() == '\\') {
        step();
      }
      step();
    }
    step();
    return std::string(text_.substr(begin, at_ - begin));
  }
  void members(const std::string& pointer) {
    step();
    skipSpace();
    while (at_ < text_.size() && peek() != '}') {
      const int line = line_;
      const nlohmann::json parsedName = nlohmann::json::parse(quoted(), nullptr, false);
      if (!parsedName.is_string()) {
        at_ = text_.size();  // a byte of 0 ends the text for the parser
        return;
      }
      const auto& name = parsedName.get_ref<const std::string&>();
      const std::string member = fmt::format("{}/{}", pointer, escapedForPointer(name));
      lines_.emplace(member, line);
      skipSpace();
      step();  // :
      value(member);
      afterComma();
    }
    step();
  }
  void elements(const std::string& pointer) {
    step();
    skipSpace();
    for (int i = 0; at_ < text_.size() && peek() != ']'; ++i) {
      value(fmt::format("{}/{}", pointer, i));
      afterComma();
    }
    step();
  }
  void afterComma() {
    if (peek() == ',') {
      step();
      skipSpace();
    }
  }

  std::string_view text_;
  std::map<std::string, int>& lines_;
  size_t at_ = 0;
  int line_ = 1;
};

nlohmann::json parsed(std::string_view text, const std::string& where, const std::string& schema) {
  std::vector<std::set<std::string>> names;
  const auto check = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& value) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > kMaxDepth) {
      fail(fmt::format("this JSON is nested deeper than {} levels", kMaxDepth), where, "see " + schema);
    }
    if (event == Event::object_start) {
      names.emplace_back();
    } else if (event == Event::object_end) {
      names.pop_back();
    } else if (event == Event::key) {
      const auto& name = value.get_ref<const std::string&>();
      if (!names.back().insert(name).second) {
        fail(fmt::format("field \"{}\" stands twice in one object", name), where, "keep one of them");
      }
    }
    return true;
  };
  try {
    return nlohmann::json::parse(text, check, true, true);
  } catch (const nlohmann::json::parse_error& error) {
    const size_t at = std::min<size_t>(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const size_t lineStart = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    const size_t column = at - (lineStart == std::string_view::npos ? 0 : lineStart + 1) + 1;
    fail("this is not valid JSON", fmt::format("{}:{}:{}", where, line, column),
         "look for a missing comma, quote or bracket there");
  } catch (const nlohmann::json::out_of_range&) {
    fail("a number in this JSON is too large", where, "keep numbers below 1.8e308");
  }
}

}  // namespace

JsonText::JsonText(std::string_view text, std::string where, std::string schema)
    : where_(std::move(where)), schema_(std::move(schema)), root_(parsed(text, where_, schema_)) {
  LineWalk(text, lines_).value("");
}

std::string JsonText::placeOf(const std::string& pointer) const {
  for (std::string at = pointer;; at.resize(at.rfind('/'))) {
    const auto found = lines_.find(at);
    if (found != lines_.end()) {
      return fmt::format("{}:{}", where_, found->second);
    }
    if (at.empty()) {
      return where_;
    }
  }
}

JsonObject::JsonObject(const JsonText& text, const nlohmann::json& object, std::string pointer)
    : text_(&text), object_(&object), pointer_(std::move(pointer)) {
  if (!object.is_object()) {
    ocelli::fail("a JSON object { ... } is expected", text.placeOf(pointer_), "see " + text.schema());
  }
}

bool JsonObject::has(const char* name) {
  known_.insert(name);
  return object_->contains(name);
}

void JsonObject::fail(const std::string& name, const std::string& problem) const {
  ocelli::fail(fmt::format("field \"{}\" {}", name, problem),
               text_->placeOf(fmt::format("{}/{}", pointer_, escapedForPointer(name))), "see " + text_->schema());
}

const nlohmann::json& JsonObject::value(const char* name) {
  if (!has(name)) {
    fail(name, "is missing");
  }
  return *object_->find(name);
}

std::string JsonObject::text(const char* name, size_t maxBytes) {
  const nlohmann::json& field = value(name);
  if (!field.is_string() || field.get_ref<const std::string&>().empty() ||
      field.get_ref<const std::string&>().size() > maxBytes) {
    fail(name, fmt::format("must be a text of 1 to {} bytes", maxBytes));
  }
  return field.get<std::string>();
}

std::string JsonObject::textOr(const char* name, size_t maxBytes, const std::string& otherwise) {
  return has(name) ? text(name, maxBytes) : otherwise;
}

double JsonObject::number(const char* name, double least, double most) {
  const nlohmann::json& field = value(name);
  const double number = field.is_number() ? field.get<double>() : std::nan("");
  if (!(number >= least && number <= most)) {
    fail(name, fmt::format("must be a number from {:g} to {:g}", least, most));
  }
  return number;
}

double JsonObject::numberOr(const char* name, double least, double most, double otherwise) {
  return has(name) ? number(name, least, most) : otherwise;
}

int64_t JsonObject::integerOr(const char* name, int64_t least, int64_t most, int64_t otherwise) {
  if (!has(name)) {
    return otherwise;
  }
  const nlohmann::json& field = value(name);
  const bool fits = field.is_number_unsigned() ? field.get<uint64_t>() <= static_cast<uint64_t>(most)
                                               : field.is_number_integer() && field.get<int64_t>() <= most;
  if (!fits || field.get<int64_t>() < least) {
    fail(name, fmt::format("must be a whole number from {} to {}", least, most));
  }
  return field.get<int64_t>();
}

bool JsonObject::booleanOr(const char* name, bool otherwise) {
  if (!has(name)) {
    return otherwise;
  }
  const nlohmann::json& field = value(name);
  if (!field.is_boolean()) {
    fail(name, "must be true or false");
  }
  return field.get<bool>();
}

void JsonObject::forEach(const char* name, size_t most, const std::function<void(JsonObject&)>& read) {
  if (!has(name)) {
    return;
  }
  const nlohmann::json& list = value(name);
  if (!list.is_array() || list.size() > most) {
    fail(name, fmt::format("must be a list of at most {} objects", most));
  }
  for (size_t i = 0; i < list.size(); ++i) {
    JsonObject element(*text_, list[i], fmt::format("{}/{}/{}", pointer_, name, i));
    read(element);
    element.rejectUnknown();
  }
}

std::vector<std::string> JsonObject::texts(const char* name, size_t most, size_t maxBytes) {
  std::vector<std::string> result;
  if (!has(name)) {
    return result;
  }
  const nlohmann::json& list = value(name);
  const auto isText = [&](const nlohmann::json& each) {
    return each.is_string() && !each.get_ref<const std::string&>().empty() &&
           each.get_ref<const std::string&>().size() <= maxBytes;
  };
  if (!list.is_array() || list.size() > most || !std::all_of(list.begin(), list.end(), isText)) {
    fail(name, fmt::format("must be a list of at most {} texts of 1 to {} bytes", most, maxBytes));
  }
  return list.get<std::vector<std::string>>();
}

void JsonObject::rejectUnknown() const {
  for (const auto& [name, value] : object_->items()) {
    if (!known_.contains(name) && name != "$schema" && name != "comment") {
      std::string allowed;
      for (const std::string& field : known_) {
        allowed += allowed.empty() ? field : fmt::format(", {}", field);
      }
      ocelli::fail(fmt::format("field \"{}\" is unknown", name),
                   text_->placeOf(fmt::format("{}/{}", pointer_, escapedForPointer(name))),
                   fmt::format("use one of: {}", allowed));
    }
  }
}

}  // namespace ocelli
