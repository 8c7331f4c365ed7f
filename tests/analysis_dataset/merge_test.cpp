#include "analysis/dataset/merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/dataset/database.h"
#include "oc_core/base/sha256.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

struct Merge : ::testing::Test {
  SampleFolder folder;
  std::string first = folder.file("first.db");
  std::string second = folder.file("second.db");

  static void fillOne(SampleStudy& study, const std::string& subject, const std::string& kind = "person",
                      double response = 10) {
    study.addSubject(subject, kind);
    study.addSession(subject, 1);
    SampleTrial trial;
    trial.subject = subject;
    trial.response = response;
    study.addTrial(trial);
    study.addAnswer(subject, "survey", "easier_find", "5");
  }
  Dataset both(const DatasetMergeOptions& options = {}) const {
    return merge({readDatabase(first), readDatabase(second)}, options);
  }
};

TEST_F(Merge, joinsStationsInAnyOrder) {
  SampleStudy a(first);
  fillOne(a, "S01");
  SampleStudy b(second);
  fillOne(b, "S02");
  const Dataset data = both();
  EXPECT_EQ(data.trials.size(), 2u);
  EXPECT_EQ(data.subjects.size(), 2u);
  EXPECT_EQ(data.trials[1].source, 1);
  EXPECT_EQ(data.sources[1].path, second);
  EXPECT_EQ(dataHash(data), dataHash(merge({readDatabase(second), readDatabase(first)})));
}

TEST_F(Merge, takesTheSameRowsOnce) {
  SampleStudy a(first);
  fillOne(a, "S01");
  SampleStudy b(second);
  fillOne(b, "S01");
  fillOne(b, "S02");
  const Dataset data = both();
  EXPECT_EQ(data.trials.size(), 2u);
  EXPECT_EQ(data.answers.size(), 2u);
  EXPECT_EQ(data.sessions.size(), 2u);
  ASSERT_EQ(data.leftOut.size(), 2u);
  EXPECT_EQ(data.leftOut[0].why, "the same row stands in " + first);
  EXPECT_EQ(data.leftOut[0].source, 1);
  EXPECT_EQ(dataHash(data), dataHash(readDatabase(second)));
}

TEST_F(Merge, refusesOneIdForTwoPeople) {
  SampleStudy a(first);
  fillOne(a, "S01");
  SampleStudy b(second);
  b.addSubject("S01", "person", "another key");
  const std::string error = analysisErrorOf([&] { both(); });
  EXPECT_THAT(error, HasSubstr("subject \"S01\" stands for different people"));
  EXPECT_THAT(error, HasSubstr(first));
  EXPECT_THAT(error, HasSubstr(second));
}

TEST_F(Merge, refusesATrialThatDiffers) {
  SampleStudy a(first);
  fillOne(a, "S01");
  SampleStudy b(second);
  fillOne(b, "S01", "person", 11);
  EXPECT_THAT(analysisErrorOf([&] { both(); }),
              HasSubstr("trial 0 of session 1 of subject \"S01\" (trial_id 1 and 1) is different"));
}

TEST_F(Merge, refusesOtherProtocolsUnlessTold) {
  SampleStudy a(first);
  fillOne(a, "S01");
  SampleStudy b(second, std::string(kSampleProtocol) + " ");
  fillOne(b, "S02");
  EXPECT_THAT(analysisErrorOf([&] { both(); }), HasSubstr("these are of different protocols"));
  EXPECT_EQ(both({SimulatedRows::kUnlessThereArePeople, true}).trials.size(), 2u);
}

TEST_F(Merge, keepsSimulatedRowsFromPeople) {
  SampleStudy a(first);
  fillOne(a, "S01");
  fillOne(a, "sim-1", "simulated_observer", 20);
  const Dataset people = merge({readDatabase(first)});
  ASSERT_EQ(people.trials.size(), 1u);
  EXPECT_EQ(people.trials[0].subject, "S01");
  EXPECT_EQ(people.subjects.size(), 1u);
  EXPECT_EQ(people.answers.size(), 1u);
  EXPECT_EQ(people.leftOut.size(), 2u);
  ASSERT_EQ(people.notes.size(), 1u);
  EXPECT_THAT(people.notes[0], HasSubstr("1 simulated subjects with 1 trials were left out"));
  EXPECT_FALSE(people.isSimulated());

  const Dataset simulated = merge({readDatabase(first)}, {SimulatedRows::kOnly, false});
  ASSERT_EQ(simulated.trials.size(), 1u);
  EXPECT_EQ(simulated.trials[0].subject, "sim-1");
  EXPECT_TRUE(simulated.isSimulated());

  const Dataset all = merge({readDatabase(first)}, {SimulatedRows::kTogetherWithPeople, false});
  EXPECT_EQ(all.trials.size(), 2u);
  EXPECT_THAT(all.notes[0], HasSubstr("1 of the 2 subjects are simulated"));
}

TEST_F(Merge, usesSimulatedRowsWhereThereIsNobodyElse) {
  SampleStudy a(first);
  fillOne(a, "sim-1", "simulated_generator");
  const Dataset data = merge({readDatabase(first)});
  EXPECT_EQ(data.trials.size(), 1u);
  EXPECT_TRUE(data.isSimulated());
  EXPECT_THAT(data.notes[0], HasSubstr("All subjects are simulated"));
}

TEST_F(Merge, leavesOutWhoWithdrewFromAnotherSource) {
  SampleStudy a(first);
  fillOne(a, "S02");
  const std::string hash = sha256("some saltkey of S01");  // the sample's key of S01
  a.database().exec(
      "INSERT INTO audit (at_utc, action, detail_json, program_version, station) VALUES ('', 'withdrawn', "
      "'{\"salt\": \"some salt\", \"subject_key_sha256\": \"" +
      hash + "\"}', '', '')");
  SampleStudy b(second);
  fillOne(b, "S01");
  fillOne(b, "S03");
  for (const Dataset& data : {both(), merge({readDatabase(second), readDatabase(first)})}) {
    ASSERT_EQ(data.subjects.size(), 2u);
    EXPECT_EQ(data.trials.size(), 2u);
    EXPECT_EQ(data.answers.size(), 2u);
    EXPECT_EQ(data.findSubject("S01"), nullptr);
    ASSERT_EQ(data.notes.size(), 1u);
    EXPECT_THAT(data.notes[0], ::testing::AllOf(HasSubstr(second + " still has subjects who withdrew, as " + first),
                                                HasSubstr("subjects: 1, trials: 1"), ::testing::Not(HasSubstr("S01"))));
  }
}

TEST_F(Merge, needsSomething) {
  EXPECT_THAT(analysisErrorOf([] { merge({}); }), HasSubstr("nothing to analyse"));
}

}  // namespace
}  // namespace ocelli::test
