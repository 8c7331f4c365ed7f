// Pages of text: instructions, consent, feedback, breaks, pauses, the end.
#pragma once

#include <optional>

#include "study/screen/instruction_images.h"
#include "study/screen/study_canvas.h"
#include "study/session/session_flow.h"

namespace ocelli {

/// How far a text that is longer than its place is scrolled, in pixels.
struct PageScroll {
  double offset = 0;
  double most = 0;  ///< set by what was drawn last; 0 where all of it fits

  void move(double pixels);
};

/// What was clicked.
struct PageClick {
  std::optional<FormAction> action{};
  std::optional<Key> key{};  ///< a button that does what this key does
};

PageClick drawPage(StudyCanvas& canvas, const PageScreen& page, InstructionImages& images, PageScroll& scroll);
PageClick drawConsent(StudyCanvas& canvas, const ConsentScreen& consent, PageScroll& scroll);
void drawPause(StudyCanvas& canvas, const PauseScreen& pause);

}  // namespace ocelli
