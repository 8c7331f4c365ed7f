// Any of several options, one at least: a protocol that wants to know of none has an option that says so.
#include <algorithm>

#include "oc_core/base/json_document.h"
#include "study/outline/option_fields.h"

namespace ocelli {
namespace {

void toggle(const FormField& field, QuestionEntry& entry, int option) {
  if (option < 0 || option >= static_cast<int>(field.options.size())) {
    return;
  }
  const auto at = std::ranges::lower_bound(entry.chosen, option);
  if (at != entry.chosen.end() && *at == option) {
    entry.chosen.erase(at);
  } else {
    entry.chosen.insert(at, option);
  }
  entry.cursor = option;
}

void pressMultiple(const FormField& field, QuestionEntry& entry, Key key) {
  const int last = static_cast<int>(field.options.size()) - 1;
  if (const std::optional<int> option = optionOfDigit(field, key)) {
    toggle(field, entry, *option);
  } else if (key == Key::kRight) {
    entry.cursor = std::min(entry.cursor + 1, last);
  } else if (key == Key::kLeft) {
    entry.cursor = std::max(entry.cursor - 1, 0);
  } else if (key == Key::kSpace) {
    toggle(field, entry, entry.cursor);
  }
}

void clickMultiple(const FormField& field, QuestionEntry& entry, const QuestionClick& click) {
  toggle(field, entry, click.option);
}

std::optional<std::string> storedMultiple(const FormField& field, const QuestionEntry& entry) {
  if (entry.chosen.empty()) {
    return std::nullopt;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const int option : entry.chosen) {
    list.push_back(storedOptions(field)[static_cast<size_t>(option)]);
  }
  return textOfJson(list);
}

QuestionLook lookOfMultiple(const FormField& field, const QuestionEntry& entry) {
  QuestionLook look = lookOfOption(field, entry);
  look.severalOptions = true;
  look.options[static_cast<size_t>(entry.cursor)].underCursor = true;
  return look;
}

QuestionEntry randomMultiple(const FormField& field, Random& random) {
  QuestionEntry entry;
  for (int i = 0; i < static_cast<int>(field.options.size()); ++i) {
    if (random.below(2) == 1) {
      entry.chosen.push_back(i);
    }
  }
  if (entry.chosen.empty()) {
    entry.chosen = {static_cast<int>(random.below(field.options.size()))};
  }
  return entry;
}

std::optional<QuestionStroke> strokeTowardsMultiple(const FormField& field, const QuestionEntry& entry,
                                                    const QuestionEntry& target) {
  for (int i = 0; i < static_cast<int>(field.options.size()); ++i) {
    if (std::ranges::count(entry.chosen, i) != std::ranges::count(target.chosen, i)) {
      const bool there = entry.cursor == i;
      return QuestionStroke{there ? Key::kSpace : entry.cursor < i ? Key::kRight : Key::kLeft};
    }
  }
  return std::nullopt;
}

}  // namespace

QuestionKind multipleQuestion() {
  return {.name = "multiple",
          .description = "any of several options, one at least",
          .value = QuestionValue::kOptions,
          .read = readOptions,
          .press = pressMultiple,
          .type = typeNothing,
          .click = clickMultiple,
          .stored = storedMultiple,
          .problem = noProblem,
          .look = lookOfMultiple,
          .atRandom = randomMultiple,
          .towards = strokeTowardsMultiple};
}

}  // namespace ocelli
