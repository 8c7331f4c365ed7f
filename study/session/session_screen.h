// What the screen shows at a moment of a session. The session decides what; whoever draws decides how it looks.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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
  std::vector<std::optional<int>> chosen;  ///< of each field, the option
  int focus = 0;                           ///< the field that keys act on; fields.size() is the button to go on
  bool missing = false;                    ///< one wanted to go on though fields are open
};

struct TrialScreenView {
  TrialLayout layout;
  bool patchWhite = false;  ///< of the photodiode
  bool showsPatch = false;
};

/// The experimenter, or the subject, stopped the session for a while.
struct PauseScreen {
  std::string reason;
};

using SessionScreen = std::variant<PageScreen, ConsentScreen, FormScreen, TrialScreenView, PauseScreen>;

}  // namespace ocelli
