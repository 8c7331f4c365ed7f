#include "study/protocol/up_down.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

/// Turns that are on the way to where it settles.
constexpr size_t kFirstTurns = 2;

}  // namespace

UpDown::UpDown(std::vector<double> levels, const UpDownOptions& options)
    : levels_(std::move(levels)), options_(options) {
  OC_CHECK(levels_.size() >= 2 && levels_.front() > 0 && std::is_sorted(levels_.begin(), levels_.end()),
           "levels ascend and are above 0");
}

UpDown::Walk UpDown::walk(std::span<const LevelAnswer> answers) const {
  Walk walk;
  walk.level = levels_.size() - 1;
  int inARow = 0;
  int last = 0;  // the way of the last step: 1 is easier
  for (const LevelAnswer& answer : answers) {
    inARow = answer.correct ? inARow + 1 : 0;
    if (answer.correct && inARow < options_.rightInARow) {
      walk.level = answer.level;
      continue;
    }
    inARow = 0;
    const int way = answer.correct ? -1 : 1;
    if (last != 0 && way != last) {
      walk.turns.push_back(answer.level);
    }
    last = way;
    const int step = walk.turns.empty() ? options_.firstStep : 1;
    const int greatest = static_cast<int>(levels_.size()) - 1;
    walk.level = static_cast<size_t>(std::clamp(static_cast<int>(answer.level) + way * step, 0, greatest));
  }
  return walk;
}

size_t UpDown::next(std::span<const LevelAnswer> before) const {
  return walk(before).level;
}

std::vector<size_t> UpDown::turns(std::span<const LevelAnswer> answers) const {
  return walk(answers).turns;
}

std::optional<double> UpDown::threshold(std::span<const LevelAnswer> answers) const {
  const std::vector<size_t> all = turns(answers);
  if (all.size() < kFirstTurns + 2) {
    return std::nullopt;
  }
  const size_t first = kFirstTurns + (all.size() - kFirstTurns) % 2;
  double sum = 0;
  for (size_t i = first; i < all.size(); ++i) {
    sum += std::log(levels_[all[i]]);
  }
  return std::exp(sum / static_cast<double>(all.size() - first));
}

double UpDown::target() const {
  return std::pow(0.5, 1.0 / options_.rightInARow);
}

std::string UpDown::summary() const {
  return fmt::format("{} down, 1 up: settles where {:.1f} % of the answers are right", options_.rightInARow,
                     100 * target());
}

std::unique_ptr<const Staircase> readUpDown(JsonFields& fields, const std::vector<double>& levels,
                                            double /*guessRate*/) {
  UpDownOptions options;
  options.rightInARow = fields.integer("right_in_a_row", 1, 10, options.rightInARow);
  options.firstStep = fields.integer("first_step", 1, 100, options.firstStep);
  return std::make_unique<UpDown>(levels, options);
}

}  // namespace ocelli
