// A study with every task of chapter 7 and known effects, small enough for a test to analyse in a moment.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {

/// Five blocks: searches and counts, stationary and moving, and paths of three maps; who is unwell is excluded.
extern const char* const kWholeProtocol;

struct MadeStudy {
  int subjects = 6;
  int sessions = 2;
  int firstNumber = 1;  ///< of their ids: S01, S02, ...
  std::string kind = "person";
  uint64_t seed = 1;
  /// Sees each trial before it is stored, and may change it; returns false for one that is left out.
  std::function<bool(SampleTrial&)> change{};
  /// The answer to all three questions of the survey; empty: drawn.
  std::string surveyAnswer{};
};

/// Per session 14 searches, 16 counts and 8 paths, each case in both views. Times are log-normal: with the graph camera
/// two thirds of those with the pinhole. Counts are right more often with it, paths as often.
void fillWholeStudy(SampleStudy& study, const MadeStudy& made = {});

}  // namespace ocelli::test
