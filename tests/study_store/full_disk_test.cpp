// A disk that is full: nothing that was stored is lost, one is told, and what came since is stored once there is room.
#include "tests/base/full_disk.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "oc_core/base/error.h"
#include "study/store/trial_store.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_store/made_study.h"
#include "tests/study_store/study_checks.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr int kFramesOfTrial = 600;

void expectSound(const std::filesystem::path& file, int completedTrials) {
  SQLite::Database raw(file.string());
  EXPECT_EQ(raw.execAndGet("PRAGMA integrity_check").getString(), "ok");
  EXPECT_EQ(raw.execAndGet("SELECT count(*) FROM trial WHERE ending = 'completed'").getInt(), completedTrials);
  EXPECT_EQ(raw.execAndGet("SELECT count(*) FROM frame").getInt(), completedTrials * kFramesOfTrial);
}

TEST(FullDisk, KeepsWhatWasStoredAndStoresTheRestOnceThereIsRoom) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "study.db";
  const Protocol protocol = madeProtocol();
  StudyDatabase database = StudyDatabase::openForSessions(file, protocol);
  database.addSubject("S01", SubjectKind::kPerson);
  const SessionSchedule schedule = madeSchedule(0, 1, 4);
  TrialStore store(database, protocol, madeRun("S01", 1), schedule, {0.05});
  std::atomic<int> acknowledged{0};
  const auto storeOne = [&](int number) {
    storeTrial(store, number, madeTrial(schedule.trials[static_cast<size_t>(number)], 1, number), kFramesOfTrial,
               number, [&] { ++acknowledged; });
    store.flush();
  };
  storeOne(0);
  EXPECT_EQ(acknowledged, 1);
  {
    // The log has the first trial; half of another fits.
    const FileSizeLimit full(std::filesystem::file_size(folder / "study.db-wal") + 20'000);
    storeOne(1);
    EXPECT_EQ(acknowledged, 1);
    EXPECT_THAT(store.failure().value_or(""), HasSubstr("trials are not being stored"));
    storeOne(2);
    EXPECT_EQ(acknowledged, 1);
    expectSound(file, 1);
  }
  storeOne(3);
  EXPECT_EQ(store.failure(), std::nullopt);
  EXPECT_EQ(acknowledged, 4);
  expectSound(file, 4);
  for (const TrialRow& trial : database.trials("S01")) {
    EXPECT_EQ(database.frames(trial.trialId), madeFrames(0, kFramesOfTrial, trial.trialNumber));
    EXPECT_EQ(database.inputs(trial.trialId).size(), madeInputs().size());
    EXPECT_EQ(database.gaze(trial.trialId), madeGaze());
  }
}

TEST(FullDisk, IsToldAsSuch) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder / "disk", "512k");
  if (!disk.works()) {
    GTEST_SKIP() << "this system lets one mount nothing; the case above needs no rights";
  }
  const std::filesystem::path file = folder / "disk/study.db";
  const Protocol protocol = madeProtocol();
  EXPECT_THAT(messageOf<WorkError>([&] { StudyDatabase::openForSessions(file, protocol); }),
              HasSubstr("the disk has 0 MB left"));
  {
    StudyDatabase database = StudyDatabase::openForSessions(file, protocol, {.minFreeBytes = 0});
    database.addSubject("S01", SubjectKind::kPerson);
    const SessionSchedule schedule = madeSchedule(0, 1, 40);
    TrialStore store(database, protocol, madeRun("S01", 1), schedule, {0.05});
    std::atomic<int> acknowledged{0};
    int number = 0;
    for (; number < 80 && !store.failure(); ++number) {
      storeTrial(store, number, madeTrial(schedule.trials[static_cast<size_t>(number)], 1, number), kFramesOfTrial,
                 number, [&] { ++acknowledged; });
      store.flush();
    }
    EXPECT_GT(acknowledged, 0);
    EXPECT_EQ(acknowledged, number - 1);
    EXPECT_THAT(store.failure().value_or(""), HasSubstr("the disk is full"));
    expectSound(file, number - 1);
  }
  // With not a byte left even the first write fails.
  std::ofstream(folder / "disk/filler") << std::string(1 << 20, 'x');
  EXPECT_THROW(StudyDatabase::openForSessions(folder / "disk/new.db", protocol, {.minFreeBytes = 0}), WorkError);
}

}  // namespace
}  // namespace ocelli::test
