#include "oc_core/base/json_document.h"

#include <algorithm>
#include <set>
#include <vector>

#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_lines.h"

namespace ocelli {
namespace {

constexpr int kMaxDepth = 100;

}  // namespace

JsonFieldError::JsonFieldError(const std::string& problem, const std::string& where)
    : InputError(problem, where, "see docs/files.md"), problem_(problem), where_(where) {}

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

JsonDocument::JsonDocument(const std::string& text, std::string where)
    : where_(std::move(where)), root_(parseJson(text, where_)), lines_(linesOfJson(text)) {}

std::string JsonDocument::placeOf(const std::string& pointer) const {
  std::string at = pointer;
  auto found = lines_.find(at);
  while (found == lines_.end() && !at.empty()) {
    at.resize(at.rfind('/'));
    found = lines_.find(at);
  }
  return found == lines_.end() ? where_ : where_ + ":" + std::to_string(found->second);
}

}  // namespace ocelli
