#include "study/trial/view_condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace ocelli {
namespace {

bool startsSentence(std::string_view text, size_t at) {
  return at == 0 || (at >= 2 && text[at - 1] == ' ' && (text[at - 2] == '.' || text[at - 2] == ':'));
}

/// `conditions`: how many there are; marks of others stay. `wordOf`: what stands for the mark of a view that begins at
/// a place of the text.
template <class WordOf>
std::string withoutMarks(std::string_view text, size_t conditions, const WordOf& wordOf) {
  std::string result;
  size_t done = 0;
  for (size_t at = text.find('@'); at != std::string_view::npos; at = text.find('@', std::max(at + 1, done))) {
    for (const TrialView view : kViews) {
      const std::string_view mark = markOf(view);
      if (indexOfCondition(view) < conditions && text.substr(at, mark.size()) == mark) {
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

std::vector<TrialView> ViewConditions::all() const {
  std::vector<TrialView> views;
  for (size_t i = 0; i < list.size(); ++i) {
    views.push_back(conditionAt(i));
  }
  return views;
}

std::optional<TrialView> ViewConditions::viewNamed(std::string_view name) const {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const ViewCondition& condition) { return condition.name == name; });
  return found == list.end() ? std::nullopt : std::optional(conditionAt(static_cast<size_t>(found - list.begin())));
}

std::string ViewConditions::namesText(const char* lastWord) const {
  std::string text;
  for (size_t i = 0; i < list.size(); ++i) {
    const bool isLast = i + 1 == list.size();
    text += i == 0 ? list[i].name : isLast ? fmt::format(" {} {}", lastWord, list[i].name) : ", " + list[i].name;
  }
  return text;
}

std::string ViewConditions::mustBe() const {
  return "must be " + namesText();
}

bool ViewConditions::hasNamesOf(const ViewConditions& others) const {
  return std::equal(list.begin(), list.end(), others.list.begin(), others.list.end(),
                    [](const ViewCondition& a, const ViewCondition& b) { return a.name == b.name; });
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
    const char* taken = isPair() ? "is that of the other condition too" : "is that of an earlier condition too";
    const auto before = list.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(list.begin(), before, [&](const ViewCondition& each) { return each.name == condition.name; })) {
      return Problem{i, "name", taken};
    }
    if (std::any_of(list.begin(), before, [&](const ViewCondition& each) { return each.label == condition.label; })) {
      return Problem{i, "label", taken};
    }
  }
  return std::nullopt;
}

const ViewConditions& defaultConditions() {
  static const ViewConditions kConditions{
      {{"ppc", "pinhole", "a planar pinhole camera, or several (pinhole)", {"plain", "pinhole", "ppc"}},
       {"gc", "graph camera", "the graph camera", {"bent", "graph", "gc"}}}};
  return kConditions;
}

std::string withViewNames(std::string_view text, const ViewConditions& conditions) {
  return withoutMarks(text, conditions.size(), [&](TrialView view, size_t) { return conditions.nameOf(view); });
}

std::string withViewLabels(std::string_view text, const ViewConditions& conditions) {
  return withoutMarks(text, conditions.size(), [&](TrialView view, size_t at) {
    std::string word = conditions.labelOf(view);
    if (startsSentence(text, at) && !word.empty()) {
      word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    }
    return word;
  });
}

}  // namespace ocelli
