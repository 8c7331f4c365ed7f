#include "study/trial/view_condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace ocelli {
namespace {

bool startsSentence(std::string_view text, size_t at) {
  return at == 0 || (at >= 2 && text[at - 1] == ' ' && (text[at - 2] == '.' || text[at - 2] == ':'));
}

/// `wordOf`: what stands for the mark of a view that begins at a place of the text.
template <class WordOf>
std::string withoutMarks(std::string_view text, const WordOf& wordOf) {
  std::string result;
  size_t done = 0;
  for (size_t at = text.find('@'); at != std::string_view::npos; at = text.find('@', std::max(at + 1, done))) {
    for (const TrialView view : kViews) {
      const std::string_view mark = markOf(view);
      if (text.substr(at, mark.size()) == mark) {
        result += text.substr(done, at - done);
        result += wordOf(view, at);
        done = at + mark.size();
        break;
      }
    }
  }
  return result += text.substr(done);
}

/// A name stands in databases, tables, names of cells and commands.
bool isName(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
}

}  // namespace

std::optional<TrialView> ViewConditions::viewNamed(std::string_view name) const {
  for (const TrialView view : kViews) {
    if (nameOf(view) == name) {
      return view;
    }
  }
  return std::nullopt;
}

std::string ViewConditions::mustBe() const {
  return fmt::format("must be {} or {}", list[0].name, list[1].name);
}

bool ViewConditions::hasNamesOf(const ViewConditions& others) const {
  return list[0].name == others.list[0].name && list[1].name == others.list[1].name;
}

std::optional<ViewConditions::Problem> ViewConditions::problem() const {
  for (size_t i = 0; i < list.size(); ++i) {
    const ViewCondition& condition = list[i];
    if (!isName(condition.name)) {
      return Problem{i, "name",
                     fmt::format("is \"{}\", but must be letters, digits, \"-\", \"_\" and \".\"", condition.name)};
    }
    if (condition.label.empty()) {
      return Problem{i, "label", "must not be empty"};
    }
    if (i > 0 && condition.name == list[0].name) {
      return Problem{i, "name", "is that of the other condition too"};
    }
    if (i > 0 && condition.label == list[0].label) {
      return Problem{i, "label", "is that of the other condition too"};
    }
  }
  return std::nullopt;
}

const ViewConditions& defaultConditions() {
  static const ViewConditions kConditions{
      {{{"ppc", "pinhole", "a planar pinhole camera, or several (pinhole)", {"plain", "pinhole", "ppc"}},
        {"gc", "graph camera", "the graph camera", {"bent", "graph", "gc"}}}}};
  return kConditions;
}

std::string withViewNames(std::string_view text, const ViewConditions& conditions) {
  return withoutMarks(text, [&](TrialView view, size_t) { return conditions.nameOf(view); });
}

std::string withViewLabels(std::string_view text, const ViewConditions& conditions) {
  return withoutMarks(text, [&](TrialView view, size_t at) {
    std::string word = conditions.labelOf(view);
    if (startsSentence(text, at) && !word.empty()) {
      word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    }
    return word;
  });
}

}  // namespace ocelli
