#include "study/session/session_pages.h"

#include <fmt/format.h>

namespace ocelli {
namespace {

PageScreen page(const std::string& title, const std::vector<std::string>& paragraphs, const std::string& action) {
  PageScreen made;
  made.title = title;
  made.paragraphs = paragraphs;
  made.action = action;
  return made;
}

}  // namespace

PageScreen pageOf(const ProtocolPage& text) {
  PageScreen made = page(text.title, text.paragraphs, "Enter: go on");
  made.image = text.image;
  made.example = text.example;
  return made;
}

PageScreen readyPage(const std::string& trialName, const std::string& blockTitle, const SessionProgress& progress) {
  PageScreen made = page(trialName, {blockTitle}, "Enter: begin");
  made.progress = progress;
  return made;
}

PageScreen feedbackPage(const TrialOutcome& outcome) {
  PageScreen made;
  made.title = outcome.correct ? "Right" : outcome.censored ? "Time is over" : "Not right";
  if (outcome.correct) {
    made.paragraphs = {fmt::format("It took you {:.1f} seconds.",
                                   static_cast<double>(outcome.responseTicks) / static_cast<double>(kTicksPerSecond))};
  }
  made.good = outcome.correct;
  made.action = "Enter: go on";
  return made;
}

PageScreen breakPage(const SessionProgress& progress, double waitSeconds) {
  PageScreen made = page("A break", {"Please rest your eyes."}, waitSeconds > 0 ? "" : "Enter: go on");
  made.progress = progress;
  made.waitSeconds = waitSeconds;
  return made;
}

PageScreen callPage(SubjectKind kind) {
  return page("Please call the experimenter",
              {"You have done all trials of the practice.", "The experimenter will go on with you."},
              kind == SubjectKind::kPerson ? "" : "Enter: go on");
}

PageScreen unwellPage() {
  return page("Do you feel unwell?", {"You may stop at any time, without giving a reason."},
              "Enter: end the session    Escape: go on with it");
}

PageScreen lastPage(const std::string& title, const std::vector<std::string>& paragraphs) {
  return page(title, paragraphs, "Enter: close");
}

}  // namespace ocelli
