// A form as it is filled in, by keys, by typing or by widgets.
#pragma once

#include "study/session/session_screen.h"

namespace ocelli {

class FormAnswers {
 public:
  /// `form` must outlive it. On screens that are laid out from the right to the left, the left arrow goes on.
  explicit FormAnswers(const ProtocolForm& form, bool rightToLeft = false);

  const FormScreen& screen() const { return screen_; }
  /// Up and down go from item to item, Enter and Tab to the next; other keys are for the kind of the question. Returns
  /// whether the form is done: each item that is required has an answer, none a wrong one, and Enter was pressed on the
  /// button.
  bool press(Key key);
  void type(char32_t character);
  void click(int item, const QuestionClick& click);
  /// The button. Where items are open it says so, and goes to the first of them.
  bool goOn();
  /// Of a form that is done, as the database holds it; empty where the subject left the item open.
  std::string answer(size_t item) const;

 private:
  int itemCount() const { return static_cast<int>(screen_.items.size()); }
  const QuestionKind& kindOf(size_t item) const { return questionKind(screen_.fieldOf(item).kind); }

  bool rightToLeft_;
  FormScreen screen_;
};

}  // namespace ocelli
