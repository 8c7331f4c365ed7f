#include "study/outline/block_outline.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr size_t kMaxIdentifier = 60;
constexpr const char* kAllViews = "all";

PracticeOutline readPracticeOutline(JsonFields& block, ProtocolReading reading) {
  constexpr int kMaxTrials = 100;
  JsonFields fields = block.inner("practice");
  PracticeOutline practice;
  practice.eachView = fields.boolean("each_view", practice.eachView);
  if (reading == ProtocolReading::kByAnalysis) {
    practice.minCorrect = fields.integer("least_correct", 1, 1000, practice.minCorrect);
    return practice;
  }
  practice.minCorrect = fields.integer("least_correct", 1, kMaxTrials, practice.minCorrect);
  practice.maxTrials = fields.integer("most_trials", 1, kMaxTrials, practice.maxTrials);
  if (practice.minCorrect > practice.maxTrials) {
    fields.fail("least_correct", fmt::format("must be at most \"most_trials\", which is {}", practice.maxTrials));
  }
  fields.rejectUnknown();
  return practice;
}

}  // namespace

BlockOutline readBlockOutline(JsonFields& fields, ProtocolReading reading) {
  BlockOutline block;
  const size_t maxTitle = maxCharacters(reading, kMaxTitleCharacters);
  if (reading == ProtocolReading::kByStudy) {
    block.name = readIdentifier(fields, "name", true);
    fields.callIt(block.name);
    block.title = fields.shortText("title", maxTitle);
    block.views =
        fields.choice("views", {"both", "one", "all"}, kAllViews) == "one" ? ViewsOfCases::kOne : ViewsOfCases::kAll;
  } else {
    block.name = fields.shortText("name", maxTitle);
    fields.callIt(block.name);
    block.title = fields.shortText("title", maxTitle, block.name);
    // Whatever another version calls it.
    const std::string views = fields.text("views", kAllViews);
    block.views = views == kAllViews || views == "both" ? ViewsOfCases::kAll : ViewsOfCases::kOne;
  }
  block.task = fields.shortText("task", maxTitle);
  if (fields.has("practice")) {
    block.practice = readPracticeOutline(fields, reading);
  }
  return block;
}

std::string readIdentifier(JsonFields& fields, const std::string& name, bool spaces) {
  std::string text = fields.shortText(name, kMaxIdentifier);
  const auto isAllowed = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           (spaces && c == ' ');
  };
  if (!std::all_of(text.begin(), text.end(), isAllowed)) {
    fields.fail(name, spaces ? "must be of letters, digits, - and spaces" : "must be of letters, digits and -");
  }
  return text;
}

}  // namespace ocelli
