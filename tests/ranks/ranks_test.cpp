#include "oc_core/ranks/ranks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/ranks/mpi_launch.h"
#include "oc_core/ranks/packed_bytes.h"
#include "oc_core/ranks/shared_tasks.h"
#include "tests/ranks/thread_ranks.h"

namespace ocelli::test {
namespace {

Bytes bytesOf(const std::string& text) {
  BytePacker packer;
  packer.add(text);
  return packer.take();
}

TEST(Shares, HoldEachItemOnce) {
  for (const size_t count : {0u, 1u, 7u, 64u, 1000u}) {
    for (const int size : {1, 2, 3, 8, 100}) {
      size_t next = 0;
      for (int rank = 0; rank < size; ++rank) {
        const RankShare share = shareOfRank(count, rank, size);
        EXPECT_EQ(share.begin, next);
        EXPECT_LE(share.size(), count / static_cast<size_t>(size) + 1);
        next = share.end;
      }
      EXPECT_EQ(next, count);
    }
  }
}

TEST(SerialRanks, AreOneWhoHearsItself) {
  const std::unique_ptr<Ranks> ranks = serialRanks();
  EXPECT_EQ(ranks->size(), 1);
  EXPECT_TRUE(ranks->isFirst());
  EXPECT_EQ(ranks->broadcast(bytesOf("a")), bytesOf("a"));
  EXPECT_THAT(ranks->gather(bytesOf("b")), testing::ElementsAre(bytesOf("b")));
  EXPECT_THAT(ranks->exchangeAll({bytesOf("c")}), testing::ElementsAre(bytesOf("c")));
  EXPECT_EQ(ranks->largest(7), 7u);
  EXPECT_EQ(ranks->bytesSent(), 0u);
}

TEST(SharedTasks, ComeBackInTheirOrder) {
  for (const int size : {1, 2, 3, 8}) {
    for (const size_t count : {0u, 1u, 5u, 17u}) {
      runInRanks(size, [&](Ranks& ranks) {
        std::vector<Bytes> mine;
        for (const size_t task : tasksOfRank(ranks, count)) {
          mine.push_back(bytesOf(std::string(task, 'x')));
        }
        const std::vector<Bytes> all = gatherTasksToAll(ranks, count, mine);
        const std::vector<Bytes> first = gatherTasks(ranks, count, mine);
        EXPECT_EQ(all.size(), count);
        EXPECT_EQ(first.size(), ranks.isFirst() ? count : 0);
        for (size_t task = 0; task < count; ++task) {
          EXPECT_EQ(all[task], bytesOf(std::string(task, 'x')));
        }
      });
    }
  }
}

TEST(PackedBytes, ComeOutAsTheyWentIn) {
  BytePacker packer;
  packer.add(3);
  packer.add(std::string("text"));
  packer.add(std::vector<double>{0.5, -1});
  const Bytes bytes = packer.take();
  ByteUnpacker unpacker(bytes);
  EXPECT_EQ(unpacker.value<int>(), 3);
  EXPECT_EQ(unpacker.text(), "text");
  EXPECT_THAT(unpacker.values<double>(), testing::ElementsAre(0.5, -1.0));
  EXPECT_TRUE(unpacker.atEnd());
}

class Launch : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE", "PMIX_RANK",
                             "SLURM_STEP_NUM_TASKS"}) {
      unsetenv(name);
    }
  }
  void TearDown() override { SetUp(); }
};

TEST_F(Launch, IsNoneWithoutALauncher) {
  EXPECT_FALSE(mpiLaunch());
  setenv("SLURM_STEP_NUM_TASKS", "4", 1);  // a step of Slurm that is no job of MPI
  EXPECT_FALSE(mpiLaunch());
}

TEST_F(Launch, IsReadFromTheEnvironment) {
  setenv("OMPI_COMM_WORLD_RANK", "2", 1);
  setenv("OMPI_COMM_WORLD_SIZE", "4", 1);
  ASSERT_TRUE(mpiLaunch());
  EXPECT_EQ(mpiLaunch()->rank, 2);
  EXPECT_EQ(mpiLaunch()->size, 4);
}

TEST_F(Launch, IsNoneWhereTheEnvironmentMakesNoSense) {
  setenv("OMPI_COMM_WORLD_RANK", "4", 1);
  setenv("OMPI_COMM_WORLD_SIZE", "4", 1);
  EXPECT_FALSE(mpiLaunch());
  setenv("OMPI_COMM_WORLD_RANK", "one", 1);
  EXPECT_FALSE(mpiLaunch());
}

}  // namespace
}  // namespace ocelli::test
