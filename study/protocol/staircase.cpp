#include "study/protocol/staircase.h"

#include <array>

#include "study/protocol/quest_plus.h"
#include "study/protocol/up_down.h"

namespace ocelli {
namespace {

constexpr std::array kStaircaseMethods{StaircaseMethod{"quest_plus", readQuestPlus},
                                       StaircaseMethod{"up_down", readUpDown}};

}  // namespace

std::span<const StaircaseMethod> staircaseMethods() {
  return kStaircaseMethods;
}

}  // namespace ocelli
