#include "oc_core/base/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace ocelli {
namespace {

struct NumberRow {
  std::string name;
  int number = 0;
};

std::vector<int> numbersOf(const Registry<NumberRow>& registry) {
  std::vector<int> numbers;
  for (const NumberRow& row : registry.rows()) {
    numbers.push_back(row.number);
  }
  return numbers;
}

TEST(Registry, registeredRowsFollowTheBuiltInOnes) {
  Registry<NumberRow> registry("number", {{"one", 1}, {"two", 2}});
  registry.add({"three", 3});
  EXPECT_THAT(numbersOf(registry), testing::ElementsAre(1, 2, 3));
}

TEST(Registry, aNameThatIsTakenIsRefusedAndChangesNothing) {
  Registry<NumberRow> registry("number", {{"one", 1}});
  registry.add({"two", 2});
  for (const char* taken : {"one", "two"}) {
    try {
      registry.add({taken, 3});
      ADD_FAILURE() << taken << " was taken twice";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("number"), testing::HasSubstr(taken)));
    }
  }
  EXPECT_THAT(numbersOf(registry), testing::ElementsAre(1, 2));
}

TEST(Registry, rowsMayAnswerToMoreThanOneName) {
  const auto answersTo = [](const NumberRow& row, std::string_view name) { return name.starts_with(row.name); };
  Registry<NumberRow> registry("number", {{"ab", 1}}, answersTo);
  EXPECT_THROW(registry.add({"abc", 2}), InputError);  // "ab" answers to it
  EXPECT_THROW(registry.add({"a", 2}), InputError);    // it answers to "ab"
  registry.add({"b", 2});
  EXPECT_THAT(numbersOf(registry), testing::ElementsAre(1, 2));
}

TEST(Registry, rowsStayWhereTheyAreWhileOthersAreAdded) {
  Registry<NumberRow> registry("number", {{"first", 7}});
  const NumberRow& first = registry.rows().front();
  const Rows<NumberRow> before = registry.rows();
  for (int i = 0; i < 1000; ++i) {
    registry.add({std::to_string(i), i});
  }
  EXPECT_EQ(&first, &registry.rows().front().get());
  EXPECT_EQ(first.number, 7);
  EXPECT_EQ(before.size(), 1u);
}

// What ThreadSanitizer would report, and a count that a lost row would change.
TEST(Registry, threadsAddAndReadAtOnce) {
  Registry<NumberRow> registry("number", {});
  constexpr int kThreads = 4;
  constexpr int kRowsEach = 100;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&registry, t] {
      for (int i = 0; i < kRowsEach; ++i) {
        registry.add({std::to_string(t) + ":" + std::to_string(i), 1});
        for (const NumberRow& row : registry.rows()) {
          EXPECT_EQ(row.number, 1);
        }
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(registry.rows().size(), static_cast<size_t>(kThreads * kRowsEach));
}

}  // namespace
}  // namespace ocelli
