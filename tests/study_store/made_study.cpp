#include "tests/study_store/made_study.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/sha256.h"

namespace ocelli::test {

Protocol madeProtocol(const std::string& comment) {
  Protocol protocol;
  protocol.name = "made-up";
  protocol.title = "A made-up study";
  protocol.text = "{\"name\": \"made-up\", \"comment\": \"" + comment + "\"}";
  protocol.sha256 = sha256(protocol.text);
  protocol.sessions = 2;
  protocol.minutesBetweenSessions = 60;
  protocol.consent = ProtocolPage{"Consent", {"You may stop at any time."}};
  protocol.demographics = ProtocolForm{
      "demographics",
      "About you",
      "",
      {{"age_band", "How old are you?", {"18-24", "25-34"}}, {"vision", "How well do you see?", {"well", "not well"}}}};
  protocol.survey = ProtocolForm{"survey", "In the end", "", {{"easier", "What was easier?", {"1", "2", "3"}}}};
  for (const char* name : {"find stationary", "count moving"}) {
    ProtocolBlock block;
    block.name = name;
    block.taskName = std::string(name).substr(0, std::string(name).find(' '));
    protocol.blocks.push_back(block);
  }
  return protocol;
}

SessionSchedule madeSchedule(int slot, int session, int trials) {
  SessionSchedule schedule;
  schedule.slot = slot;
  schedule.session = session;
  schedule.blockOrder = {0, 1};
  schedule.seed = 0xfedcba9876543210u;  // has the highest bit set
  for (int i = 0; i < 2 * trials; ++i) {
    TrialPlan plan;
    plan.index = i;
    plan.block = i / trials;
    plan.task = plan.block == 0 ? "find" : "count";
    plan.caseIndex = i % trials;
    plan.view = kViews[static_cast<size_t>(i % 2)];
    plan.seed = 0xf000000000000000u + static_cast<uint64_t>(i);
    schedule.trials.push_back(plan);
  }
  return schedule;
}

RunRecord madeRun(const std::string& subject, int session, SubjectKind kind) {
  RunRecord run;
  run.subject = subject;
  run.kind = kind;
  run.session = session;
  run.startedUtc = "2026-03-01T12:00:00.000Z";
  run.programVersion = "0.0.1";
  run.station = "station-1";
  run.environment = R"({"clock": "made up"})";
  run.timingCheck = R"({"verdict": "good"})";
  if (kind != SubjectKind::kPerson) {
    run.simulation = R"({"speed": 1.5})";
  }
  return run;
}

TrialRecord madeTrial(const TrialPlan& plan, int attempt, int salt) {
  TrialRecord record;
  record.plan = plan;
  record.attempt = attempt;
  record.info.label = "case " + std::to_string(plan.caseIndex);
  record.info.moving = plan.block == 1;
  if (plan.task == "count") {
    record.info.exposureSeconds = 5;
    record.info.objects = 4 + plan.caseIndex % 4;
    record.info.duplicateColors = plan.caseIndex % 2 == 0;
  }
  record.info.longestSeconds = 60;
  record.info.typicalSeconds = 17;
  record.screen = {1920, 1200, 59.94};
  record.startedNanoseconds = 1'000'000'000LL * salt + 17;
  record.endedNanoseconds = record.startedNanoseconds + 15'000'000'003;
  record.startedUtc = "2026-03-01T12:00:01.000Z";
  record.endedUtc = "2026-03-01T12:00:16.000Z";
  record.outcome.answer = plan.task == "find" ? "object" : "5";
  record.outcome.expected = plan.task == "find" ? "object" : "6";
  record.outcome.correct = plan.task == "find";
  record.outcome.censored = salt % 7 == 3;
  record.outcome.responseTicks = 1000 + salt;
  record.outcome.exposureFrames = plan.task == "count" ? 300 : 0;
  record.outcome.measures = {{"path_length_m", 12.1 + salt / 3.0}, {"clicks", 2}};
  record.timing = {900, 1, 16'683'350, 33'366'700, TimingVerdict::kGood};
  return record;
}

std::vector<FrameRecord> madeFrames(int first, int count, int salt) {
  std::vector<FrameRecord> frames;
  for (int i = first; i < first + count; ++i) {
    FrameRecord frame;
    frame.frame = i;
    frame.tick = 4 * i;
    frame.shownNanoseconds = 1'000'000'000LL * salt + 16'683'350LL * i;
    frame.pose = {std::sin(0.1 * i + salt), std::cos(0.07 * i) / 3, 0.001 * i + 1.0 / 3 * salt};
    if (i % 2 == 0) {
      frame.pixelHash = 0x8000000000000000u + static_cast<uint64_t>(i);
    }
    frames.push_back(frame);
  }
  return frames;
}

std::vector<InputRecord> madeInputs() {
  return {{5, 1, KeyEvent{Key::kW, true, {true, false, true}}},
          {6, 1, KeyEvent{Key::kPageUp, false, {false, true, false}}},
          {7, 2, TextEvent{U'\u00e4'}},
          {8, 2, PointerMoveEvent{0.1, -1e-9}},
          {9, 3, PointerButtonEvent{PointerButton::kMiddle, true, {}}},
          {10, 3, ScrollEvent{-0.25, 1}},
          {11, 3, ResizeEvent{1920, 1080, 1.25, 2}},
          {12, 4, DropEvent{{"", ""}}},
          {13, 4, CloseEvent{}}};
}

std::vector<GazeRecord> madeGaze() {
  return {{14, 1042.5, true, 960.25, -1.0 / 3, 3.5}, {15, 1.5e15, true, 0, 1e-9, {}}, {16, -1, false, 0, 0, {}}};
}

void storeTrial(SessionSink& sink, int number, const TrialRecord& record, int frames, int salt,
                std::function<void()> acknowledged) {
  sink.trialBegins(number, record.plan, record.attempt);
  for (int first = 0; first < frames; first += 30) {
    sink.frames(number, madeFrames(first, std::min(30, frames - first), salt));
  }
  sink.inputs(number, madeInputs());
  sink.gaze(number, madeGaze());
  sink.trialEnds(number, record, std::move(acknowledged));
}

}  // namespace ocelli::test
