#include "study/session/session_pages.h"

#include <fmt/format.h>

#include <cmath>

#include "study/trial/estimated_value.h"

namespace ocelli {
namespace {

PageScreen page(const std::string& title, const std::vector<std::string>& paragraphs, const std::string& action) {
  PageScreen made;
  made.title = title;
  made.paragraphs = paragraphs;
  made.action = action;
  return made;
}

/// What a key does: "Enter: go on".
std::string actionOf(Key key, const std::string& does) {
  return fmt::format("{}: {}", nameOf(key), does);
}

}  // namespace

PageScreen pageOf(const SubjectTexts& texts, const ProtocolPage& text) {
  PageScreen made = page(text.title, text.paragraphs, actionOf(Key::kEnter, texts.say("go_on")));
  made.image = text.image;
  made.example = text.example;
  return made;
}

PageScreen readyPage(const SubjectTexts& texts, const std::string& trialName, const std::string& blockTitle,
                     const SessionProgress& progress) {
  PageScreen made = page(trialName, {blockTitle}, actionOf(Key::kEnter, texts.say("begin")));
  made.progress = progress;
  return made;
}

PageScreen feedbackPage(const SubjectTexts& texts, const TrialOutcome& outcome) {
  PageScreen made;
  made.title = texts.say(outcome.correct ? "right" : outcome.censored ? "time_over" : "not_right");
  if (outcome.correct) {
    const double seconds = static_cast<double>(outcome.responseTicks) / static_cast<double>(kTicksPerSecond);
    made.paragraphs = {texts.say("took_seconds", {{"seconds", fmt::format("{:.1f}", seconds)}})};
  }
  if (const std::optional<EstimatedValue> value = estimatedValue(outcome.measures)) {
    // Of directions the error says more than two bearings.
    made.paragraphs.push_back(texts.say(fmt::format("estimate_{}", value->unit->name),
                                        {{"estimate", fmt::format("{:.1f}", value->estimate)},
                                         {"truth", fmt::format("{:.1f}", value->truth)},
                                         {"error", fmt::format("{:.0f}", std::abs(value->signedError()))}}));
  }
  made.good = outcome.correct;
  made.action = actionOf(Key::kEnter, texts.say("go_on"));
  return made;
}

PageScreen breakPage(const SubjectTexts& texts, const SessionProgress& progress, double waitSeconds) {
  PageScreen made = page(texts.say("break"), {texts.say("break_rest")},
                         waitSeconds > 0 ? "" : actionOf(Key::kEnter, texts.say("go_on")));
  made.progress = progress;
  made.waitSeconds = waitSeconds;
  return made;
}

PageScreen callPage(const SubjectTexts& texts, SubjectKind kind) {
  return page(texts.say("call"), {texts.say("call_practice_done"), texts.say("call_goes_on")},
              kind == SubjectKind::kPerson ? "" : actionOf(Key::kEnter, texts.say("go_on")));
}

PageScreen unwellPage(const SubjectTexts& texts) {
  return page(
      texts.say("unwell"), {texts.say("unwell_may_stop")},
      actionOf(Key::kEnter, texts.say("end_session")) + "    " + actionOf(Key::kEscape, texts.say("go_on_with_it")));
}

PageScreen lastPage(const SubjectTexts& texts, const std::string& title, const std::vector<std::string>& paragraphs) {
  return page(title, paragraphs, actionOf(Key::kEnter, texts.say("close")));
}

}  // namespace ocelli
