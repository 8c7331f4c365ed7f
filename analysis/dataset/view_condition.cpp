#include "analysis/dataset/view_condition.h"

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
