// All that SessionFlow knows: the steps that are left, the trial that runs, what is shown before it.
#pragma once

#include <deque>
#include <map>
#include <set>

#include "study/session/form_answers.h"
#include "study/session/running_trial.h"
#include "study/session/session_agenda.h"
#include "study/session/session_pages.h"

namespace ocelli {

struct SessionFlow::State {
  State(const Protocol& theProtocol, SessionSchedule theSchedule, const SessionDone& done,
        SessionFlowOptions theOptions, SessionSink& theSink);

  const Protocol& protocol;
  SessionSchedule schedule;
  SessionFlowOptions options;
  SessionSink& sink;
  std::vector<int> attempts;  ///< of each plan, how often it began
  std::set<int> completed{};  ///< indices of plans
  AnsweredCases answered{};   ///< what they leave for staircases
  int64_t now = 0;

  std::deque<TimedInput> inputs{};  ///< that came, and took no effect yet
  std::set<Key> held{};

  // The first step is the one under way.
  std::deque<SessionStep> agenda;
  std::optional<FormAnswers> form{};
  int64_t breakBegan = 0;
  struct Practice {
    int trials = 0;
    int inARow = 0;
    int inARowBefore = 0;  ///< the last trial
  };
  std::map<std::pair<int, std::optional<TrialView>>, Practice> practice{};  ///< of blocks and rounds
  std::unique_ptr<RunningTrial> trial{};
  TrialRecord record{};  ///< of the trial that runs
  bool trialWasOnScreen = false;
  int trialsBegun = 0;
  std::vector<TrialPlan> practiceBegun{};
  std::optional<TrialPlan> lastPlan{};
  TrialTiming lastTiming{};

  // What is shown before the step under way.
  std::optional<std::string> pauseReason{};
  bool asksUnwell = false;
  std::optional<PageScreen> closingPage{};  ///< of a session that has ended, or failed
  std::optional<SessionEnding> ending{};
  std::string failure{};  ///< of the sink
  bool closed = false;

  /// Of the language of the protocol.
  std::string say(std::string_view id, std::initializer_list<TextArgument> arguments = {}) const {
    return protocol.texts.say(id, arguments);
  }

  template <class Step>
  Step* current() {
    return agenda.empty() ? nullptr : std::get_if<Step>(&agenda.front());
  }
  const ProtocolBlock& blockOf(int index) const { return protocol.blocks[static_cast<size_t>(index)]; }
  const TaskBlock& taskOf(const TrialPlan& plan) const {
    const ProtocolBlock& block = blockOf(plan.block);
    return plan.practice ? *block.practice->task : *block.task;
  }

  // Records
  /// Of whoever declines nothing more is stored.
  bool storesEvents() const { return ending != SessionEnding::kFailed && ending != SessionEnding::kDeclined; }
  void event(const std::string& what, const std::string& detail = {});
  void end(SessionEnding how, const std::string& title, const std::vector<std::string>& paragraphs);
  void checkSink();

  // Steps
  void nextStep();
  /// What happens when a step comes under way. Steps that show nothing are done at once.
  void enterStep();

  void goOnWithPractice(const PracticeStep& step);
  void continueAfterPractice();
  /// Whether the step under way, of practice or of its failure, is the last of the practice of its block.
  bool isLastRound(int block) const;
  /// To which a practice trial belongs.
  Practice& practiceOf(const TrialPlan& plan) { return practice[{plan.block, roundOf(plan)}]; }
  std::optional<TrialView> roundOf(const TrialPlan& plan) const {
    return blockOf(plan.block).practice->eachView ? std::optional(plan.view) : std::nullopt;
  }

  void decline();
  ConsentRecord consentRecord(bool agreed) const;

  /// Enter, or the button to go on.
  void goOn();
  void storeForm();
  double breakSecondsLeft() const;

  // Trials
  void beginTrial(const TrialPlan& plan);

  /// The trial that runs, in whichever way. Its step is still the first.
  void endTrial(TrialEnding how);

  void completeTrial();
  /// Keeps what the trial that was completed leaves for the staircase of its block.
  void answerStaircase(const TrialPlan& plan);

  /// Something stops the trial; it comes again.
  void interruptTrial(TrialEnding how);

  // Input
  void press(Key key, bool isRepeat);
  void type(char32_t character);
  /// To the page that asks whether the subject feels unwell.
  void answerUnwell(bool ends);

  /// Returns whether the input was taken; else its time is yet to come.
  bool take(const TimedInput& input);

  void update(int64_t time);

  // What is shown
  SessionProgress progress() const;

  /// As subjects read it, and for records in English.
  std::string nameOfTrial(const TrialPlan& plan, const SubjectTexts& texts) const;

  SessionScreen screenOf(const ConsentStep&) const { return ConsentScreen{*protocol.consent}; }
  SessionScreen screenOf(const FormStep&) const { return form->screen(); }
  SessionScreen screenOf(const TextStep& step) const { return pageOf(protocol.texts, *step.page); }
  SessionScreen screenOf(const PracticeStep&) const { return PageScreen{}; }  // done as it begins
  SessionScreen screenOf(const CallStep&) const { return callPage(protocol.texts, options.kind); }
  SessionScreen screenOf(const TrialStep& step) const;
  SessionScreen screenOf(const FeedbackStep& step) const { return feedbackPage(protocol.texts, step.outcome); }
  SessionScreen screenOf(const BreakStep&) const { return breakPage(protocol.texts, progress(), breakSecondsLeft()); }
  SessionScreen screenOf(const EndStep&) const { return PageScreen{}; }  // likewise
  SessionScreen screen() const;

  std::string nameOf(const ConsentStep&) const { return "consent"; }
  std::string nameOf(const FormStep& step) const { return "form " + step.form->name; }
  std::string nameOf(const TextStep& step) const { return "page " + step.page->title; }
  std::string nameOf(const PracticeStep&) const { return "practice"; }
  std::string nameOf(const CallStep&) const { return "practice failed, goes on by: resume"; }
  std::string nameOf(const TrialStep& step) const;
  /// Without what tells of a condition: titles of pages may, as of the one that explains it.
  std::string blindNameOf(const TextStep&) const { return "page"; }
  std::string blindNameOf(const TrialStep& step) const;
  template <class Step>
  std::string blindNameOf(const Step& step) const {
    return nameOf(step);
  }
  std::string nameOf(const FeedbackStep&) const { return "feedback"; }
  std::string nameOf(const BreakStep&) const { return "break"; }
  std::string nameOf(const EndStep&) const { return "end"; }
};

}  // namespace ocelli
