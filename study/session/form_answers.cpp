#include "study/session/form_answers.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {

void FormAnswers::choose(int field, int option) {
  if (field < 0 || field >= fieldCount()) {
    return;
  }
  const auto index = static_cast<size_t>(field);
  if (option >= 0 && option < static_cast<int>(form_.fields[index].options.size())) {
    screen_.chosen[index] = option;
    screen_.focus = field;
  }
}

bool FormAnswers::goOn() {
  const auto open = std::find(screen_.chosen.begin(), screen_.chosen.end(), std::nullopt);
  screen_.missing = open != screen_.chosen.end();
  screen_.focus = static_cast<int>(open - screen_.chosen.begin());
  return !screen_.missing;
}

bool FormAnswers::press(Key key) {
  const bool onButton = screen_.focus >= fieldCount();
  if (key == Key::kEnter && onButton) {
    return goOn();
  }
  if (key == Key::kDown || key == Key::kEnter || key == Key::kTab) {
    screen_.focus = std::min(screen_.focus + 1, fieldCount());
  } else if (key == Key::kUp) {
    screen_.focus = std::max(screen_.focus - 1, 0);
  } else if (!onButton) {
    const auto index = static_cast<size_t>(screen_.focus);
    const int last = static_cast<int>(form_.fields[index].options.size()) - 1;
    const std::optional<int> now = screen_.chosen[index];
    if (key == Key::kRight) {
      choose(screen_.focus, now ? std::min(*now + 1, last) : 0);
    } else if (key == Key::kLeft) {
      choose(screen_.focus, now ? std::max(*now - 1, 0) : last);
    } else if (key >= Key::k1 && key <= Key::k9) {
      choose(screen_.focus, static_cast<int>(key) - static_cast<int>(Key::k1));
    }
  }
  return false;
}

const std::string& FormAnswers::answer(size_t field) const {
  OC_CHECK(screen_.chosen[field].has_value(), "a form that is done has all answers");
  return form_.fields[field].options[static_cast<size_t>(*screen_.chosen[field])];
}

}  // namespace ocelli
