#include "study/tasks/task_registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/constructor/graph_operations.h"
#include "study/task/eye_camera.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

TEST(TaskRegistry, RowsAreWholeAndNamedOnce) {
  std::set<std::string> names;
  for (const TaskKind& kind : taskKinds()) {
    SCOPED_TRACE(kind.name);
    EXPECT_TRUE(names.insert(kind.name).second);
    EXPECT_TRUE(std::all_of(kind.name.begin(), kind.name.end(), [](char c) { return c >= 'a' && c <= 'z'; }))
        << "names stand in files' names";
    EXPECT_FALSE(kind.description.empty());
    EXPECT_NE(kind.read, nullptr);
    EXPECT_NE(kind.policy, nullptr);
    EXPECT_EQ(&taskKind(kind.name, "test"), &kind);
  }
}

TEST(TaskRegistry, AllHaveAnExample) {
  for (const TaskKind& kind : taskKinds()) {
    const auto& examples = test::taskExamples();
    EXPECT_TRUE(std::any_of(examples.begin(), examples.end(), [&](const test::TaskExample& example) {
      return example.task == kind.name;
    })) << kind.name;
  }
}

// Databases, protocols and exports hold these names: they stay, and new ones come after them.
TEST(TaskRegistry, NamesOfEarlierVersionsStay) {
  EXPECT_THAT(taskNames(), testing::StartsWith("find, count, path"));
}

TEST(TaskRegistry, AnUnknownNameIsAnErrorThatListsTheKnownOnes) {
  for (const char* name : {"search", "", "Find", "find "}) {
    try {
      taskKind(name, "block 1");
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("no task"), testing::HasSubstr("block 1"),
                                               testing::HasSubstr(taskNames())));
    }
  }
}

// By the curve of EyeCameraOptions, which is not the usual one; where an example stands nearer to its portals than
// subjects do, they are bent from nearer by.
TEST(TaskRegistry, InstructionsShowThePortalsOfTrials) {
  size_t otherThanUsual = 0;
  for (const char* name : {"find_gc", "nearer_gc", "distance_gc", "direction_gc"}) {
    const InstructionImage* image = instructionImage(name);
    ASSERT_NE(image, nullptr) << name;
    const InstructionExample example = image->make({160, 100});
    ASSERT_EQ(example.layout.views.size(), 1u) << name;
    const GraphCamera& graph = std::get<GraphCamera>(example.layout.views.front().camera);
    SceneGuides guides;
    guides.maze = example.scene->maze();
    const auto builtBy = [&](PortalOptions options, double bentBeyond) {
      options.bentBeyond = bentBeyond;
      return jsonText(buildPortalCamera(options, guides, graph.root()));
    };
    const PortalOptions ofTrials = EyeCameraOptions().portals;
    const std::string drawn = jsonText(graph);
    EXPECT_TRUE(drawn == builtBy(ofTrials, ofTrials.bentBeyond) || drawn == builtBy(ofTrials, 1)) << name;
    otherThanUsual += drawn != builtBy(PortalOptions(), PortalOptions().bentBeyond);
  }
  EXPECT_GE(otherThanUsual, 2u);
}

// A row that may be registered would be one too many for the other tests: examples/add_a_task registers one.
TEST(RegisterTask, RefusesRowsThatNobodyCouldUse) {
  const auto refusalOf = [](TaskKind kind) -> std::string {
    try {
      registerTask(std::move(kind));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const TaskKind good = [] {
    TaskKind kind = taskKind("nearer", "test");
    kind.name = "mine";
    return kind;
  }();
  const size_t before = taskKinds().size();
  for (const char* name : {"", "Mine", "my task", "nearer", "path"}) {
    TaskKind kind = good;
    kind.name = name;
    EXPECT_THAT(refusalOf(kind), testing::HasSubstr(name));
    EXPECT_NE(refusalOf(kind), "");
  }
  TaskKind unread = good;
  unread.read = nullptr;
  EXPECT_THAT(refusalOf(unread), testing::HasSubstr("mine"));
  TaskKind unanswered = good;
  unanswered.policy = nullptr;
  EXPECT_THAT(refusalOf(unanswered), testing::HasSubstr("mine"));
  TaskKind unmodelled = good;
  unmodelled.generator.effects.clear();
  EXPECT_THAT(refusalOf(unmodelled), testing::HasSubstr("graph"));
  EXPECT_EQ(taskKinds().size(), before);
}

}  // namespace
}  // namespace ocelli
