#include "study/session/form_answers.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {

std::optional<QuestionProblem> problemOf(const FormScreen& screen, size_t item) {
  const FormField& field = screen.fieldOf(item);
  const QuestionEntry& entry = screen.entries[item];
  if (entry.isEmpty()) {
    return field.required ? std::optional(QuestionProblem{"form_open"}) : std::nullopt;
  }
  const QuestionKind& kind = questionKind(field.kind);
  if (std::optional<QuestionProblem> problem = kind.problem(field, entry)) {
    return problem;
  }
  return kind.stored(field, entry) || !field.required ? std::nullopt : std::optional(QuestionProblem{"form_open"});
}

FormAnswers::FormAnswers(const ProtocolForm& form, bool rightToLeft)
    : rightToLeft_(rightToLeft), screen_{&form, itemsOf(form.fields), {}, 0, false} {
  screen_.entries.resize(screen_.items.size());
}

void FormAnswers::click(int item, const QuestionClick& click) {
  if (item < 0 || item >= itemCount()) {
    return;
  }
  const auto index = static_cast<size_t>(item);
  kindOf(index).click(screen_.fieldOf(index), screen_.entries[index], click);
  screen_.focus = item;
}

void FormAnswers::type(char32_t character) {
  if (screen_.focus < itemCount()) {
    const auto index = static_cast<size_t>(screen_.focus);
    kindOf(index).type(screen_.fieldOf(index), screen_.entries[index], character);
  }
}

bool FormAnswers::goOn() {
  int open = 0;
  while (open < itemCount() && !problemOf(screen_, static_cast<size_t>(open))) {
    ++open;
  }
  screen_.missing = open < itemCount();
  screen_.focus = open;
  return !screen_.missing;
}

bool FormAnswers::press(Key key) {
  const bool onButton = screen_.focus >= itemCount();
  if (key == Key::kEnter && onButton) {
    return goOn();
  }
  if (key == Key::kDown || key == Key::kEnter || key == Key::kTab) {
    screen_.focus = std::min(screen_.focus + 1, itemCount());
  } else if (key == Key::kUp) {
    screen_.focus = std::max(screen_.focus - 1, 0);
  } else if (!onButton) {
    const auto index = static_cast<size_t>(screen_.focus);
    const Key meant = !rightToLeft_ ? key : key == Key::kLeft ? Key::kRight : key == Key::kRight ? Key::kLeft : key;
    kindOf(index).press(screen_.fieldOf(index), screen_.entries[index], meant);
  }
  return false;
}

std::string FormAnswers::answer(size_t item) const {
  OC_CHECK(!problemOf(screen_, item), "a form that is done has all answers");
  return kindOf(item).stored(screen_.fieldOf(item), screen_.entries[item]).value_or("");
}

}  // namespace ocelli
