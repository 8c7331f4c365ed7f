// A simulated subject that sees: it goes through whole sessions as a person does. It looks at what the session shows,
// reads pages, fills in forms, does the trials (task_policy.h), and gives back what its motor model does.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "study/agent/maze_memory.h"
#include "study/agent/visibility_sensor.h"
#include "study/session/session_flow.h"
#include "study/subject/form_taste.h"

namespace ocelli {

struct ObserverSetting {
  TrialScreen screen{};
  StudyRenderer renderer = rasterizeStudy;
  bool hashFrames = false;  ///< of the views of each layout that is looked at
  FactorMeans factors{};    ///< other than the usual ones
};

class SessionObserver {
 public:
  /// `protocol` must outlive it. The seed makes the subject what it is.
  SessionObserver(const Protocol& protocol, const ObserverSetting& setting, uint64_t seed);
  ~SessionObserver();

  const HumanFactors& factors() const { return factors_; }
  /// Sessions come in order: what was learned in one is there in the next, as far as it is not forgotten.
  void beginSession(int session);
  /// The session shows its screen, from `now` on. Returns the hash of the layout where it made one.
  std::optional<uint64_t> watch(const SessionFlow& flow, int64_t now);
  /// What its motor model did before `until`.
  std::vector<TimedInput> act(int64_t until);

 private:
  void beginTrial(const TrialPlan& plan, int64_t now);
  void endTrial(int64_t now);
  std::optional<uint64_t> fixate(const TrialLayout& layout, int64_t now);
  const Percept& see(const TrialLayout& layout);
  void see(const SessionScreen& screen, int64_t now);
  void read(const PageScreen& page, int64_t now);
  void fillIn(const FormScreen& form, int64_t now);
  void press(Key key, int64_t at, int64_t again);

  const Protocol& protocol_;
  ObserverSetting setting_;
  uint64_t seed_;
  HumanFactors factors_;
  Vision vision_;
  VisibilitySensor eye_;
  Random random_;
  MotorModel motor_;
  std::map<uint64_t, MazeMemory> mazes_{};  ///< by their surroundings
  Experience experience_{};

  uint64_t trials_ = 0;  ///< so far, practice included
  bool inTrial_ = false;
  std::optional<TrialPlan> plan_{};
  int64_t trialBegan_ = 0;
  std::unique_ptr<TaskPolicy> policy_{};
  int64_t nextLook_ = 0;    ///< when the next fixation begins, or something is to be read or pressed
  std::string page_{};      ///< that was read
  std::string question_{};  ///< that is being answered: form and item
  QuestionEntry meant_{};   ///< what the answer is to be
  struct Seen {
    const StudyScene* scene = nullptr;
    std::vector<glm::vec3> offsets{};
    Percept percept{};
  };
  std::optional<Seen> still_{};  ///< of a layout whose cameras stay where they are
  Percept percept_{};
};

}  // namespace ocelli
