// A form as it is filled in, by keys or by widgets.
#pragma once

#include "study/session/session_screen.h"

namespace ocelli {

class FormAnswers {
 public:
  /// `form` must outlive it.
  explicit FormAnswers(const ProtocolForm& form) : form_(form), screen_{&form, {}, 0, false} {
    screen_.chosen.resize(form.fields.size());
  }

  const FormScreen& screen() const { return screen_; }
  /// Up and down change the field, left, right and digits its option, Enter goes on to the next. Returns whether the
  /// form is done: all fields have an answer, and Enter was pressed on the button.
  bool press(Key key);
  void choose(int field, int option);
  /// The button. Where fields are open it says so, and goes to the first of them.
  bool goOn();
  /// Of a form that is done.
  const std::string& answer(size_t field) const;

 private:
  int fieldCount() const { return static_cast<int>(form_.fields.size()); }

  const ProtocolForm& form_;
  FormScreen screen_;
};

}  // namespace ocelli
