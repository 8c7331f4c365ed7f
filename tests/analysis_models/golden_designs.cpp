#include "tests/analysis_models/golden_designs.h"

namespace ocelli {

Design interceptsDesign(const GoldenData& data, const std::vector<std::string>& groups) {
  FixedEffects fixed(static_cast<Eigen::Index>(data.labels(groups[0]).size()));
  fixed.addIntercept();
  std::vector<RandomTerm> random;
  for (const std::string& group : groups) {
    random.push_back(randomIntercepts(group, data.labels(group)));
  }
  return makeDesign(fixed, random);
}

Design sleepDesign(const GoldenData& data, bool correlated) {
  FixedEffects fixed(180);
  fixed.addIntercept();
  fixed.addNumber("Days", data.numbers("Days"));
  RandomTerm subjects = randomIntercepts("Subject", data.labels("Subject"));
  addSlope(subjects, "Days", fixed);
  subjects.correlated = correlated;
  return makeDesign(fixed, {subjects});
}

Design findDesign(const GoldenData& data, bool interaction) {
  FixedEffects fixed(static_cast<Eigen::Index>(data.numbers("y").size()));
  fixed.addIntercept();
  for (const char* name : {"view", "moving", "session"}) {
    fixed.addNumber(name, data.numbers(name));
  }
  if (interaction) {
    fixed.addInteraction("view", "moving");
  }
  RandomTerm subjects = randomIntercepts("subject", data.labels("subject"));
  addSlope(subjects, "view", fixed);
  return makeDesign(fixed, {subjects, randomIntercepts("item", data.labels("item"))});
}

}  // namespace ocelli
