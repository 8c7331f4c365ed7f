// Notes whose reader is slow, or does not read.
#include "oc_core/remote/server/note_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <vector>

namespace ocelli::test {
namespace {

TEST(NoteQueue, WritesAllInTheirOrderAlsoAtTheEnd) {
  std::vector<std::string> written;
  {
    NoteQueue notes([&](const std::string& line) {
      written.push_back(line);
      if (line == "b") {
        throw 1;  // this line alone is lost
      }
    });
    for (const char* const line : {"a", "b", "c"}) {
      notes.add(line);
    }
  }
  EXPECT_THAT(written, testing::ElementsAre("a", "b", "c"));
}

TEST(NoteQueue, DoesNotWaitForItsReader) {
  std::promise<void> reads;
  std::promise<void> begins;
  std::vector<std::string> written;
  auto notes = std::make_unique<NoteQueue>([&](const std::string& line) {
    if (written.empty()) {
      begins.set_value();
      reads.get_future().wait();
    }
    written.push_back(line);
  });
  notes->add("first");
  begins.get_future().wait();
  for (size_t i = 0; i < NoteQueue::kMaxLines + 5; ++i) {
    notes->add("more");  // this test would not end where it waited
  }
  reads.set_value();
  notes.reset();
  ASSERT_EQ(written.size(), NoteQueue::kMaxLines + 2);
  EXPECT_EQ(written.back(), "(5 lines are left out)");
}

}  // namespace
}  // namespace ocelli::test
