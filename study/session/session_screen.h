// What the screen shows at a moment of a session. The session decides what; whoever draws decides how it looks.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "study/outline/question_kinds.h"
#include "study/protocol/protocol.h"
#include "study/task/trial_layout.h"

namespace ocelli {

/// How far the session is.
struct SessionProgress {
  int trialsDone = 0;
  int trials = 0;
  int block = 0;  ///< of the session, from 0
  int blocks = 0;
};

/// Instructions, a break, feedback, the end: text until a key is pressed.
struct PageScreen {
  std::string title;
  std::vector<std::string> paragraphs;
  std::string image{};         ///< of ProtocolPage
  std::optional<bool> good{};  ///< feedback: right or wrong, shown by shape and word as well as colour
  std::optional<SessionProgress> progress{};
  double waitSeconds = 0;                        ///< left until one may go on
  std::string action;                            ///< "Enter: begin"
  std::shared_ptr<const PageExample> example{};  ///< of ProtocolPage
};

struct ConsentScreen {
  ProtocolPage text;
};

struct FormScreen {
  const ProtocolForm* form = nullptr;
  std::vector<QuestionItem> items;     ///< what is filled in
  std::vector<QuestionEntry> entries;  ///< of each item
  int focus = 0;                       ///< the item that keys act on; items.size() is the button to go on
  bool missing = false;                ///< one wanted to go on though items are open or wrong

  const FormField& fieldOf(size_t item) const { return form->fields[static_cast<size_t>(items[item].field)]; }
};
/// What keeps an item of a form from being done: the id of a text with {least} and {most}; nothing where it is done.
std::optional<QuestionProblem> problemOf(const FormScreen& screen, size_t item);

/// Where a subject looked, for replays.
struct GazeMark {
  glm::dvec2 place{0};  ///< pixels of the screen
  double age = 0;       ///< 0 when it came, 1 where it vanishes
  bool joined = true;   ///< to the one before: nothing between them was not seen
};

struct TrialScreenView {
  TrialLayout layout;
  bool patchWhite = false;  ///< of the photodiode
  bool showsPatch = false;
  std::vector<GazeMark> gaze{};  ///< the newest last; subjects do not see it
};

/// The experimenter, or the subject, stopped the session for a while.
struct PauseScreen {
  std::string reason;
};

using SessionScreen = std::variant<PageScreen, ConsentScreen, FormScreen, TrialScreenView, PauseScreen>;

}  // namespace ocelli
