#include "oc_core/base/json_lines.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace ocelli {
namespace {

/// Goes through a text that is known to be JSON, and notes the line of each value, or of the name before it.
class LineWalk {
 public:
  LineWalk(std::string_view text, std::map<std::string, int>& lines, std::string wanted = "")
      : text_(text), lines_(lines), wanted_(std::move(wanted)) {}

  std::pair<size_t, size_t> bytesOfWanted() const { return bytes_; }

  void value(const std::string& pointer) {
    skipSpace();
    lines_.emplace(pointer, line_);
    const size_t begin = at_;
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
    if (pointer == wanted_) {
      bytes_ = {begin, at_};
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
      const std::string member = pointerToField(pointer, parsedName.get_ref<const std::string&>());
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
    for (size_t i = 0; at_ < text_.size() && peek() != ']'; ++i) {
      value(pointerToElement(pointer, i));
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
  std::string wanted_;  ///< pointer whose bytes are noted
  std::pair<size_t, size_t> bytes_{};
  size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

std::string pointerToField(const std::string& pointer, std::string_view name) {
  std::string field = pointer;
  field += '/';
  for (const char c : name) {
    if (c == '~') {
      field += "~0";
    } else if (c == '/') {
      field += "~1";
    } else {
      field += c;
    }
  }
  return field;
}

std::string pointerToElement(const std::string& pointer, size_t index) {
  return pointerToField(pointer, std::to_string(index));
}

std::map<std::string, int> linesOfJson(std::string_view text) {
  std::map<std::string, int> lines;
  LineWalk(text, lines).value("");
  return lines;
}

std::pair<size_t, size_t> bytesOfJson(std::string_view text, const std::string& pointer) {
  std::map<std::string, int> lines;
  LineWalk walk(text, lines, pointer);
  walk.value("");
  return walk.bytesOfWanted();
}

}  // namespace ocelli
