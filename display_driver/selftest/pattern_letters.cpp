#include "display_driver/selftest/pattern_letters.h"

#include <array>
#include <string_view>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

struct Letter {
  char name;
  std::array<std::string_view, kLetterRows> rows;
};

constexpr std::array<Letter, 7> kLetters{{
    {'B', {"####.", "#...#", "#...#", "####.", "#...#", "#...#", "####."}},
    {'F', {"#####", "#....", "#....", "####.", "#....", "#....", "#...."}},
    {'L', {"#....", "#....", "#....", "#....", "#....", "#....", "#####"}},
    {'O', {".###.", "#...#", "#...#", "#...#", "#...#", "#...#", ".###."}},
    {'P', {"####.", "#...#", "#...#", "####.", "#....", "#....", "#...."}},
    {'R', {"####.", "#...#", "#...#", "####.", "#.#..", "#..#.", "#...#"}},
    {'T', {"#####", "..#..", "..#..", "..#..", "..#..", "..#..", "..#.."}},
}};

}  // namespace

bool letterCell(char letter, int column, int row) {
  for (const Letter& known : kLetters) {
    if (known.name == letter) {
      const bool inside = column >= 0 && column < kLetterColumns && row >= 0 && row < kLetterRows;
      return inside && known.rows[static_cast<size_t>(row)][static_cast<size_t>(column)] == '#';
    }
  }
  OC_CHECK(false, "a letter without cells");
  return false;
}

}  // namespace ocelli
