#include "study/subject/generator_effects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "study/tasks/task_registry.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::Not;

Protocol protocolOf(const std::string& task) {
  Protocol protocol;
  ProtocolBlock block;
  block.taskName = task;
  protocol.blocks.push_back(block);
  return protocol;
}

std::string problemOf(const std::function<void()>& work) {
  try {
    work();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(GeneratorEffects, AreThoseOfTheRowsByDefault) {
  const GeneratorEffects effects;
  for (const TaskKind& kind : taskKinds()) {
    ASSERT_EQ(effects.of(kind.name).size(), kind.generator.effects.size());
    for (const GeneratorEffect& effect : kind.generator.effects) {
      EXPECT_EQ(effects.at(kind.name, effect.name), effect.value) << kind.name << effect.name;
    }
  }
}

TEST(GeneratorEffects, ReadsThemBackAndRejectsUnknownOnes) {
  const test::TemporaryFolder folder;
  GeneratorEffects effects;
  effects.at("find", "graph") = -0.7;
  effects.at("path", "item_sd") = 0;
  effects.at("find", "item_view_sd") = 0.8;
  effects.at("count", "item_view_sd") = 0.3;
  effects.at("path", "item_view_sd") = 0.2;
  effects.at("nearer", "right") = -1;
  writeFile(folder / "effects.json", jsonText(effects, protocolOf("nearer")));
  EXPECT_EQ(readGeneratorEffects(folder / "effects.json"), effects);
  writeFile(folder / "wrong.json", R"({"find": {"grapf": 1}})");
  EXPECT_THROW(readGeneratorEffects(folder / "wrong.json"), InputError);
  writeFile(folder / "negative.json", R"({"find": {"item_view_sd": -1}})");
  EXPECT_THROW(readGeneratorEffects(folder / "negative.json"), InputError);
}

TEST(GeneratorEffects, HaveTheTasksThatAreRegisteredLater) {
  const GeneratorEffects effects;
  TaskKind later = taskKinds().front().get();
  later.name = "later";
  later.images.clear();
  later.generator.recordedAlways = false;
  registerTask(later);
  EXPECT_EQ(effects.of("later"), effects.of(taskKinds().front().get().name));
  EXPECT_EQ(effects, GeneratorEffects());
}

TEST(GeneratorEffects, UnknownNamesAreErrorsThatListTheKnownOnes) {
  GeneratorEffects effects;
  EXPECT_THAT(problemOf([&] { effects.at("search", "graph") = 1; }),
              testing::AllOf(HasSubstr("no task \"search\""), HasSubstr("find, count, path")));
  EXPECT_THAT(problemOf([&] { effects.at("count", "grapf") = 1; }),
              testing::AllOf(HasSubstr("the task count has no effect \"grapf\""), HasSubstr("duplicates")));
  EXPECT_THAT(problemOf([&] { fixedPart(effects, {.task = "search", .info = {}}); }), HasSubstr("find, count, path"));
  EXPECT_EQ(effects.valueOr0("count", kResidualSd), 0);
  const test::TemporaryFolder folder;
  folder.write("other.json", R"({"search": {"graph": 1}})");
  EXPECT_THAT(problemOf([&] { readGeneratorEffects(folder / "other.json"); }), HasSubstr("search"));
}

// Databases of simulated subjects hold this text, and a study goes on only where it is the same again.
TEST(GeneratorEffects, TheRecordOfASubjectIsWhatItWasBeforeThereWasARegistry) {
  const std::string before =
      R"({"find":{"log_seconds":2.5,"graph":-0.3,"moving":-0.3,"session":-0.1,"subject_sd":0.25,)"
      R"("subject_graph_sd":0.1,"item_sd":0.35,"item_view_sd":0.0,"residual_sd":0.45},)"
      R"("count":{"right":0.5,"graph":1.5,"duplicates":-0.4,"doubled_exposure":0.3,"session":0.2,"subject_sd":0.5,)"
      R"("item_sd":0.4,"item_view_sd":0.0},)"
      R"("path":{"right":1.0,"graph":0.1,"session":0.2,"subject_sd":0.5,"item_sd":0.4,"item_view_sd":0.0}})";
  EXPECT_EQ(jsonText({}, protocolOf("find")), before);
  EXPECT_EQ(jsonText({}, protocolOf("path")), before);
  EXPECT_THAT(jsonText({}, protocolOf("nearer")), HasSubstr(R"("nearer":{"right":)"));
}

}  // namespace
}  // namespace ocelli
