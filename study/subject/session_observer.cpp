#include "study/subject/session_observer.h"

#include <algorithm>

#include "oc_core/base/conventions.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

/// Brysbaert 2019: 238 words of English a minute.
constexpr double kWordsPerSecond = 4;
constexpr double kLongestReadSeconds = 60;
/// Where nothing came of a key, it is pressed again.
constexpr int64_t kAgain = 3'000'000'000;

double pixelsPerDegree(const Protocol& protocol, const TrialScreen& screen) {
  const double half = std::atan(protocol.screen.widthMillimeters / 2 / protocol.screen.distanceMillimeters);
  return screen.width / degreesFromRadians(2 * half);
}

size_t wordsOf(const std::string& text) {
  return text.empty() ? 0 : static_cast<size_t>(std::count(text.begin(), text.end(), ' ')) + 1;
}

}  // namespace

SessionObserver::SessionObserver(const Protocol& protocol, const ObserverSetting& setting, uint64_t seed)
    : protocol_(protocol),
      setting_(setting),
      seed_(seed),
      factors_(drawHumanFactors(seed, setting.factors)),
      vision_(factors_, pixelsPerDegree(protocol, setting.screen)),
      eye_(setting.screen, setting.renderer),
      random_(seedOf(seed, 1)),
      motor_(factors_, protocol.controls, seedOf(seed, 2)) {}

SessionObserver::~SessionObserver() = default;

void SessionObserver::beginSession(int session) {
  const auto sessionsBefore = static_cast<uint64_t>(session - 1);
  random_ = Random(seedOf(seed_, 1000 + sessionsBefore));
  motor_ = MotorModel(factors_, protocol_.controls, seedOf(seed_, 2000 + sessionsBefore));
  if (sessionsBefore > 0) {
    for (auto& [surroundings, memory] : mazes_) {
      memory.beginTrial(factors_.forgetBetweenSessions, random_);
    }
  }
  inTrial_ = false;
  policy_.reset();
  nextLook_ = 0;
  page_.clear();
  question_.clear();
}

std::vector<TimedInput> SessionObserver::act(int64_t until) {
  return motor_.take(until);
}

void SessionObserver::beginTrial(const TrialPlan& plan, int64_t now) {
  inTrial_ = true;
  plan_ = plan;
  trialBegan_ = now;
  ++trials_;
  still_.reset();
  policy_.reset();
  page_.clear();
  nextLook_ = now;
}

void SessionObserver::endTrial(int64_t now) {
  inTrial_ = false;
  motor_.release(now);
  if (policy_ && plan_) {
    Effort& effort = experience_[plan_->task][static_cast<size_t>(plan_->view)];
    effort.add(policy_->effort(secondsOf(now - trialBegan_)));
  }
  policy_.reset();
  nextLook_ = now;
}

std::optional<uint64_t> SessionObserver::watch(const SessionFlow& flow, int64_t now) {
  const bool trialRuns = flow.trial() != nullptr;
  if (trialRuns && !inTrial_) {
    beginTrial(flow.trialPlan().value_or(TrialPlan{}), now);
  } else if (!trialRuns && inTrial_) {
    endTrial(now);
  }
  if (now < nextLook_) {
    return std::nullopt;
  }
  const SessionScreen screen = flow.screen();
  if (const auto* trial = std::get_if<TrialScreenView>(&screen)) {
    return fixate(trial->layout, now);
  }
  see(screen, now);
  return std::nullopt;
}

const Percept& SessionObserver::see(const TrialLayout& layout) {
  const bool withFloor = !policy_ || policy_->wantsFloor();
  if (withFloor || layout.views.empty()) {
    percept_ = eye_.look(layout, withFloor);
    return percept_;
  }
  if (!still_ || still_->scene != layout.scene || still_->offsets != layout.objectOffsets) {
    still_ = Seen{layout.scene, layout.objectOffsets, eye_.look(layout, false)};
  }
  return still_->percept;
}

std::optional<uint64_t> SessionObserver::fixate(const TrialLayout& layout, int64_t now) {
  if (!policy_) {
    policy_ = taskKind(plan_->task, protocol_.name)
                  .policy({.vision = vision_,
                           .controls = protocol_.controls,
                           .memory = [&]() -> MazeMemory& { return mazes_[eye_.look(layout, true).grid.surroundings]; },
                           .seed = seedOf(seed_, 1'000'000 + trials_)});
  }
  const int64_t ends =
      now + nanosecondsOf(std::max(0.1, normal(random_, factors_.fixationSeconds, factors_.fixationSpread)));
  const double more = policy_->think(see(layout), now, ends, motor_);
  nextLook_ = ends + nanosecondsOf(more + factors_.saccadeSeconds);
  if (setting_.hashFrames && !layout.views.empty()) {
    return pixelHashOf(viewsOf(layout, setting_.screen, setting_.renderer));
  }
  return std::nullopt;
}

void SessionObserver::press(Key key, int64_t at, int64_t again) {
  motor_.tap(key, at);
  nextLook_ = at + again;
}

void SessionObserver::see(const SessionScreen& screen, int64_t now) {
  if (const auto* page = std::get_if<PageScreen>(&screen)) {
    read(*page, now);
  } else if (const auto* form = std::get_if<FormScreen>(&screen)) {
    fillIn(*form, now);
  } else if (const auto* consent = std::get_if<ConsentScreen>(&screen)) {
    PageScreen asPage;
    asPage.title = consent->text.title;
    asPage.paragraphs = consent->text.paragraphs;
    read(asPage, now);
  }
}

void SessionObserver::read(const PageScreen& page, int64_t now) {
  std::string text = page.title;
  for (const std::string& paragraph : page.paragraphs) {
    text += '\n';
    text += paragraph;
  }
  const double seconds = text == page_ ? 0.5 : static_cast<double>(wordsOf(text)) / kWordsPerSecond;
  page_ = text;
  const double spread = normalWithin(random_, 1, 0.2, 0.5, 2);
  const double until = std::max(std::min(factors_.readSeconds / 2 + seconds, kLongestReadSeconds) * spread,
                                page.waitSeconds + factors_.reactionSeconds);
  press(Key::kEnter, now + nanosecondsOf(until), nanosecondsOf(factors_.holdSeconds * 2 + 0.1));
}

void SessionObserver::fillIn(const FormScreen& form, int64_t now) {
  const auto pressAfter = [&](Key key, double seconds) {
    press(key, now + nanosecondsOf(seconds * normalWithin(random_, 1, 0.2, 0.5, 2)), kAgain / 10);
  };
  if (form.form == nullptr || form.focus >= static_cast<int>(form.items.size())) {
    pressAfter(Key::kEnter, factors_.decideSeconds);
    return;
  }
  const QuestionItem& item = form.items[static_cast<size_t>(form.focus)];
  const QuestionEntry& entry = form.entries[static_cast<size_t>(form.focus)];
  const FormField& field = form.form->fields[static_cast<size_t>(item.field)];
  const QuestionKind& kind = questionKind(field.kind);
  const std::string question = form.form->name + "/" + item.name;
  if (question != question_) {
    question_ = question;
    // Where the form comes again to a question that was answered, the answer stays.
    meant_ = entry.isEmpty() ? entryOf(protocol_, *form.form, item, experience_, random_) : entry;
  }
  const double seconds = entry.isEmpty()
                             ? factors_.decideSeconds + static_cast<double>(wordsOf(item.label)) / kWordsPerSecond
                             : factors_.reactionSeconds * 2;
  const std::optional<QuestionStroke> stroke = kind.towards(field, entry, meant_);
  if (!stroke) {
    pressAfter(Key::kEnter, seconds);
  } else if (stroke->key) {
    const bool mirrored = protocol_.texts.rightToLeft();
    const Key key = *stroke->key;
    pressAfter(mirrored && key == Key::kLeft    ? Key::kRight
               : mirrored && key == Key::kRight ? Key::kLeft
                                                : key,
               seconds);
  } else {
    const int64_t at = now + nanosecondsOf(seconds * normalWithin(random_, 1, 0.2, 0.5, 2));
    motor_.type(stroke->character, at);
    nextLook_ = at + kAgain / 10;
  }
}

}  // namespace ocelli
