// A question of each kind, as protocols write them, for the tests of the contract.
#pragma once

#include <string>
#include <vector>

#include "study/outline/question_kinds.h"

namespace ocelli::test {

const std::vector<std::string>& questionExamples();
FormField questionExample(const std::string& json);

}  // namespace ocelli::test
