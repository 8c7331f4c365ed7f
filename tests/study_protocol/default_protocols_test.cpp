// What went with the view in the study of 2010 does not in the protocols to begin with (docs/experimenters.md, threats
// to validity): instructions, practice and places. coverage_test.cpp has the views of counting.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "study/protocol/schedule.h"
#include "study/task/trial_image.h"

namespace ocelli::test {
namespace {

/// Read once: some make images to see whether they can be.
const Protocol& shipped(const std::string& name) {
  static std::map<std::string, Protocol> known;
  const auto found = known.find(name);
  return found != known.end()
             ? found->second
             : known
                   .emplace(name,
                            readProtocol(std::filesystem::path(OCELLI_SOURCE_DIR "/protocols") / (name + ".json")))
                   .first->second;
}

/// The first moment of a trial: its image, without what GL would add.
Image<Rgb8> imageOf(const TaskBlock& task, const TrialPlan& plan) {
  constexpr TrialScreen kSmall{1024, 640, 60};
  const std::unique_ptr<TrialRun> run = task.start(plan, kSmall);
  return viewsOf(run->layout(), kSmall, rasterizeStudy);
}

/// The protocol with the example cases of each block as its trials.
Protocol withExamplesAsTrials(const Protocol& protocol) {
  nlohmann::json json = nlohmann::json::parse(protocol.text, nullptr, true, true);
  for (nlohmann::json& block : json.at("blocks")) {
    block["cases"] = block.at("example_cases");
  }
  return protocolFromJsonText(json.dump(), protocol.name);
}

class DefaultProtocol : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shipped, DefaultProtocol,
                         testing::Values("short", "rosen2010-balanced", "nearer", "nearer-aside", "counting-heights",
                                         "estimates", "staircase", "solidity"));

TEST_P(DefaultProtocol, ShowsInItsInstructionsATrialInEachConditionAlike) {
  const Protocol& protocol = shipped(GetParam());
  for (const ProtocolBlock& block : protocol.blocks) {
    SCOPED_TRACE(block.name);
    std::map<int, std::multiset<TrialView>> viewsOfCases;
    std::set<size_t> paragraphs;
    for (const ProtocolPage& page : block.instructions) {
      EXPECT_TRUE(page.image.empty() || page.image == "path_maps") << page.image << " is not of a trial of the block";
      if (page.example) {
        EXPECT_EQ(page.example->task, block.examples);
        viewsOfCases[page.example->plan.caseIndex].insert(page.example->plan.view);
        paragraphs.insert(page.paragraphs.size());
      }
    }
    EXPECT_LE(paragraphs.size(), 1u) << "a view is explained at greater length";
    EXPECT_FALSE(viewsOfCases.empty());
    for (const auto& [caseIndex, views] : viewsOfCases) {
      const std::vector<TrialView> all = protocol.conditions.names.all();
      EXPECT_EQ(views, std::multiset<TrialView>(all.begin(), all.end()));
    }
  }
}

TEST(DefaultProtocols, ShowPicturesThatAreThoseOfTrials) {
  for (const char* name : {"short", "nearer"}) {
    const Protocol& protocol = shipped(name);
    const Protocol trials = withExamplesAsTrials(protocol);
    for (size_t i = 0; i < protocol.blocks.size(); ++i) {
      // Blocks of a task look alike but for what moves, and images take their time.
      if (protocol.blocks[i].name.find("moving") != std::string::npos) {
        continue;
      }
      for (const ProtocolPage& page : protocol.blocks[i].instructions) {
        if (page.example) {
          EXPECT_EQ(imageOf(*page.example->task, page.example->plan),
                    imageOf(*trials.blocks[i].task, page.example->plan))
              << protocol.blocks[i].name;
        }
      }
    }
  }
}

TEST_P(DefaultProtocol, PractisesEachViewByItself) {
  const Protocol& protocol = shipped(GetParam());
  for (int slot = 0; slot < 4; ++slot) {
    const SessionSchedule schedule = scheduleOf(protocol, slot, 1, protocol.seed);
    for (int block = 0; block < static_cast<int>(protocol.blocks.size()); ++block) {
      const auto rounds = practiceRounds(schedule, protocol, block);
      const std::vector<TrialView> all = protocol.conditions.names.all();
      ASSERT_EQ(rounds.size(), all.size());
      EXPECT_EQ(rounds[0], schedule.firstView);
      EXPECT_EQ(std::set<std::optional<TrialView>>(rounds.begin(), rounds.end()).size(), all.size());
      std::set<uint64_t> seeds;
      for (const std::optional<TrialView> round : rounds) {
        for (int number = 0; number < protocol.blocks[static_cast<size_t>(block)].practice->maxTrials; ++number) {
          const TrialPlan plan = practiceTrial(schedule, protocol, block, number, round);
          EXPECT_EQ(plan.view, round);
          EXPECT_TRUE(seeds.insert(plan.seed).second);
        }
      }
    }
  }
}

TEST(BalancedProtocol, DrawsPlacesThatDifferBySessionAndNotByViewAndTakesEachBandAsOften) {
  const Protocol& protocol = shipped("rosen2010-balanced");
  const nlohmann::json json = nlohmann::json::parse(protocol.text, nullptr, true, true);
  for (size_t b = 0; b < 2; ++b) {
    std::map<int, int> cases;
    for (const nlohmann::json& each : json.at("blocks").at(b).at("cases")) {
      ++cases[each.at("distance_band").get<int>()];
    }
    EXPECT_EQ(cases.size(), 4u);
    for (const auto& [band, count] : cases) {
      EXPECT_EQ(count, b == 0 ? 3 : 2) << band;
    }
    const TaskBlock& task = *protocol.blocks[b].task;
    std::set<std::vector<std::string>> placesOfSessions;
    for (int session = 1; session <= protocol.sessions; ++session) {
      std::map<int, std::set<std::string>> placesOfCases;
      for (const TrialPlan& trial : scheduleOf(protocol, 3, session, protocol.seed).trials) {
        if (trial.block == static_cast<int>(b)) {
          placesOfCases[trial.caseIndex].insert(task.answerOf(trial));
        }
      }
      std::vector<std::string> places;
      for (const auto& [caseIndex, drawn] : placesOfCases) {
        EXPECT_EQ(drawn.size(), 1u);  // in both views
        places.push_back(*drawn.begin());
      }
      EXPECT_EQ(static_cast<int>(places.size()), task.caseCount());
      EXPECT_EQ(std::set<std::string>(places.begin(), places.end()).size(), places.size());
      placesOfSessions.insert(places);
    }
    EXPECT_EQ(static_cast<int>(placesOfSessions.size()), protocol.sessions);
  }
}

}  // namespace
}  // namespace ocelli::test
