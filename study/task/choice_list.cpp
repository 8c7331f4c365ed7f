#include "study/task/choice_list.h"

#include <algorithm>

namespace ocelli {

void ChoiceList::mark(int index) {
  marked_ = std::clamp(index, 0, static_cast<int>(choices_.size()) - 1);
  for (int i = 0; i < static_cast<int>(choices_.size()); ++i) {
    choices_[static_cast<size_t>(i)].chosen = i == marked_;
  }
}

std::optional<int> ChoiceList::handle(const InputEvent& event, const TaskPointer& pointer) {
  const auto indexWhere = [&](const auto& is) {
    const auto found = std::find_if(choices_.begin(), choices_.end(), is);
    return found == choices_.end() ? std::nullopt : std::optional(static_cast<int>(found - choices_.begin()));
  };
  const auto* key = std::get_if<KeyEvent>(&event);
  if (key != nullptr && key->pressed && !key->modifiers.shift) {
    if (const auto index = indexWhere([&](const auto& choice) { return choice.key == key->key; })) {
      return index;
    }
    if (key->key == Key::kRight || key->key == Key::kDown) {
      mark(marked_ + 1);
    } else if (key->key == Key::kLeft || key->key == Key::kUp) {
      mark(marked_ < 0 ? static_cast<int>(choices_.size()) - 1 : marked_ - 1);
    } else if (key->key == Key::kEnter && marked_ >= 0) {
      return marked_;
    }
  }
  return pointer.isClick(event) ? indexWhere([&](const auto& choice) { return choice.place.contains(pointer.place()); })
                                : std::nullopt;
}

}  // namespace ocelli
