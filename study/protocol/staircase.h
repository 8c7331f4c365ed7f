// Staircases: which level of a stimulus comes next, by how the levels before were answered, and the threshold that the
// answers tell. The methods are rows of a table; each is a pure function of the answers, so that a session that is
// resumed, and a replay, find the same level again.
//
// Recipe for a further method: a class of its own, as study/protocol/up_down.h has one, a row in
// study/protocol/staircase.cpp, and its fields in protocols/protocol.schema.json, "staircase".
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ocelli {

class JsonFields;

struct LevelAnswer {
  size_t level = 0;  ///< index of the levels, which ascend: the greater, the easier
  bool correct = false;
};

class Staircase {
 public:
  virtual ~Staircase() = default;
  /// Index of the level to show after these answers, in the order in which they came.
  virtual size_t next(std::span<const LevelAnswer> before) const = 0;
  /// Of the level, in its unit; nothing where the answers do not tell it yet.
  virtual std::optional<double> threshold(std::span<const LevelAnswer> answers) const = 0;
  /// What its options are, and what its threshold means, in a line.
  virtual std::string summary() const = 0;
};

struct StaircaseMethod {
  const char* name;  ///< in protocols
  /// `levels` ascend and are above 0; two at least. `guessRate` is the chance to be right by guessing. Reads its own
  /// fields and leaves others. Throws InputError naming the field.
  std::unique_ptr<const Staircase> (*read)(JsonFields& fields, const std::vector<double>& levels, double guessRate);
};

std::span<const StaircaseMethod> staircaseMethods();

}  // namespace ocelli
