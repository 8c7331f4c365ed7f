#include "study/replay/stored_replay.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "study/replay/trial_frame.h"
#include "study/session/trial_rows.h"
#include "study/trial/trials_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_subject/simulated_sessions.h"

namespace ocelli {
namespace {

Image<Rgb8> views(const TrialLayout& layout, const TrialScreen& screen) {
  return viewsOf(layout, screen, rasterizeStudy);
}

/// Written by a program of that version, and brought up to date by this one.
TEST(StoredReplay, ofADatabaseOfVersion3IsTheSame) {
  const test::TemporaryFolder folder;
  {
    SQLite::Database old((folder / "old.db").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    old.exec(readFile(OCELLI_SOURCE_DIR "/tests/study_store/version_3.sql", 1'000'000));
    old.exec("PRAGMA application_id = " + std::to_string(kTrialsApplicationId) + "; PRAGMA user_version = 3");
  }
  const ReplayStudy study(folder / "old.db");
  const ReplaySummary summary = study.check(study.trials({}), {});
  EXPECT_TRUE(summary.allSame()) << summary.differences.front();
  EXPECT_EQ(summary.trials, 6);
  EXPECT_EQ(summary.framesSame, 503);
}

TEST(StoredReplay, ofAllSimulatedTrialsIsTheSame) {
  const test::TemporaryFolder folder;
  SimulationPlan plan = test::observers(2);
  plan.hashFrames = true;
  simulateStudy(test::simulatedProtocol(), folder / "study.db", plan);
  const ReplayStudy study(folder / "study.db");
  const std::vector<TrialRow> trials = study.trials({.withPractice = true});
  const ReplaySummary summary = study.check(trials, {{"raster", views}});
  EXPECT_EQ(summary.trials, static_cast<int64_t>(trials.size()));
  EXPECT_TRUE(summary.allSame()) << summary.differences.front();
  EXPECT_GT(summary.hashes, 100);
  EXPECT_EQ(summary.hashesSame, summary.hashes);
  EXPECT_EQ(summary.withoutLog, 0);
  EXPECT_EQ(study.check(trials, {{"another", views}}).hashes, 0) << "it drew none of them";

  EXPECT_EQ(study.trials({.subject = "sim-0002", .session = 1, .trial = 0}).size(), 1u);
  EXPECT_THROW(study.trials({.subject = "nobody"}), InputError);
  EXPECT_THROW(study.trials({.trial = 1000}), InputError);

  // Each frame of a trial can be drawn.
  const TrialRow trial = study.trials({.subject = "sim-0001", .session = 1, .trial = 0}).front();
  ReplayOptions options;
  options.onFrame = [&](const FrameRecord& frame, const TrialRun& run) {
    if (frame.frame % 100 == 0) {
      const Image<Rgb8> drawn = trialFrame(run.layout(), recordOf(trial).screen, rasterizeStudy);
      EXPECT_EQ(drawn.width(), test::kSmallScreen.width);
      EXPECT_NE(drawn, Image<Rgb8>(drawn.width(), drawn.height(), Rgb8(0)));
    }
  };
  replayTrial(study.blockOf(trial), study.logOf(trial), options);
}

TEST(StoredReplay, knowsTrialsWithoutALog) {
  const test::TemporaryFolder folder;
  SimulationPlan plan = test::observers(2);
  plan.kind = SubjectKind::kGenerator;
  simulateStudy(test::simulatedProtocol(false), folder / "study.db", plan);
  const ReplayStudy study(folder / "study.db");
  const std::vector<TrialRow> trials = study.trials({});
  const ReplaySummary summary = study.check(trials, {});
  EXPECT_EQ(summary.trials, 0);
  EXPECT_EQ(summary.withoutLog, static_cast<int64_t>(trials.size()));
}

}  // namespace
}  // namespace ocelli
