// The letters of test patterns, five cells wide and seven high.
#pragma once

namespace ocelli {

inline constexpr int kLetterColumns = 5;
inline constexpr int kLetterRows = 7;

/// Whether a cell of a letter is lit, counted from its upper left; false beside it. For B, F, L, O, P, R and T.
bool letterCell(char letter, int column, int row);

}  // namespace ocelli
