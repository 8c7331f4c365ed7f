// A small study in a database, for what exports it.
#pragma once

#include <filesystem>

#include "tests/study_store/made_study.h"

namespace ocelli::test {

/// What an experimenter typed there.
inline constexpr const char* kTypedNote = "came with Ada";
/// An answer that a spreadsheet would take for a formula.
inline constexpr const char* kFormula = "=1+1";

/// Three subjects: S01 with two blocks of two trials, a practice trial, one redone attempt and one that never ended;
/// S02 with two blocks of two trials; R1, simulated, the same.
void storeStudy(const std::filesystem::path& database);

}  // namespace ocelli::test
