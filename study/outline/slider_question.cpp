// A mark on a line between two ends. There is none until the subject sets it: a mark that is already there would be an
// answer that nobody gave.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/json_fields.h"
#include "study/outline/option_fields.h"

namespace ocelli {
namespace {

constexpr double kMaxOfTrack = 1e6;
constexpr int kMaxSteps = 1000;
/// A decimal fraction is not lost to rounding: 0.1 * 3 is stored as 0.3.
constexpr double kDecimals = 1e9;

int stepsOf(const FormField& field) {
  return std::max(1, static_cast<int>(std::lround((field.most - field.least) / field.step)));
}

double numberAt(const FormField& field, int step) {
  const int clamped = std::clamp(step, 0, stepsOf(field));
  return std::round((field.least + clamped * field.step) * kDecimals) / kDecimals + 0.0;
}

int stepOf(const FormField& field, double number) {
  return std::clamp(static_cast<int>(std::lround((number - field.least) / field.step)), 0, stepsOf(field));
}

void readSlider(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language) {
  readEnds(fields, field, reading, language);
  if (reading == ProtocolReading::kByAnalysis) {
    return;
  }
  if (field.ends.empty()) {
    fields.fail("ends", "is missing: what the lower and the upper end of the line mean");
  }
  field.least = fields.number("least", -kMaxOfTrack, kMaxOfTrack, field.least);
  field.most = fields.number("most", -kMaxOfTrack, kMaxOfTrack, field.most);
  field.step = fields.number("step", 1e-6, kMaxOfTrack, field.step);
  const double steps = (field.most - field.least) / field.step;
  if (!(steps >= 1 && steps <= kMaxSteps) || std::abs(steps - std::round(steps)) > 1e-6) {
    fields.fail("step",
                fmt::format("must divide the way from \"least\" to \"most\" into 1 to {} equal parts", kMaxSteps));
  }
}

void pressSlider(const FormField& field, QuestionEntry& entry, Key key) {
  const int steps = stepsOf(field);
  if (key == Key::kHome || key == Key::kEnd) {
    entry.number = numberAt(field, key == Key::kHome ? 0 : steps);
  } else if (key == Key::kLeft || key == Key::kRight) {
    const int step = !entry.number ? steps / 2 : stepOf(field, *entry.number) + (key == Key::kRight ? 1 : -1);
    entry.number = numberAt(field, step);
  }
}

void clickSlider(const FormField& field, QuestionEntry& entry, const QuestionClick& click) {
  entry.number = numberAt(field, static_cast<int>(std::lround(std::clamp(click.share, 0.0, 1.0) * stepsOf(field))));
}

std::optional<std::string> storedSlider(const FormField& /*field*/, const QuestionEntry& entry) {
  return entry.number ? std::optional(fmt::format("{}", *entry.number)) : std::nullopt;
}

QuestionLook lookOfSlider(const FormField& field, const QuestionEntry& entry) {
  QuestionLook look;
  look.ends = field.ends;
  look.track = QuestionLook::Track{{}, stepsOf(field)};
  if (entry.number) {
    look.track->share = static_cast<double>(stepOf(field, *entry.number)) / stepsOf(field);
  }
  return look;
}

QuestionEntry randomSlider(const FormField& field, Random& random) {
  QuestionEntry entry;
  entry.number = numberAt(field, static_cast<int>(random.below(static_cast<size_t>(stepsOf(field)) + 1)));
  return entry;
}

std::optional<QuestionStroke> strokeTowardsSlider(const FormField& field, const QuestionEntry& entry,
                                                  const QuestionEntry& target) {
  if (!target.number || entry.number == target.number) {
    return std::nullopt;
  }
  const int wanted = stepOf(field, *target.number);
  if (!entry.number) {
    const int steps = stepsOf(field);
    return QuestionStroke{4 * wanted < steps ? Key::kHome : 4 * wanted > 3 * steps ? Key::kEnd : Key::kRight};
  }
  return QuestionStroke{stepOf(field, *entry.number) < wanted ? Key::kRight : Key::kLeft};
}

}  // namespace

QuestionKind sliderQuestion() {
  return {.name = "slider",
          .description = "a mark on a line between two ends",
          .value = QuestionValue::kNumber,
          .read = readSlider,
          .press = pressSlider,
          .type = typeNothing,
          .click = clickSlider,
          .stored = storedSlider,
          .problem = noProblem,
          .look = lookOfSlider,
          .atRandom = randomSlider,
          .towards = strokeTowardsSlider};
}

}  // namespace ocelli
