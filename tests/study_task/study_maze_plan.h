// The maze of the tests of studies, as the field "plan" of a maze in JSON.
#pragma once

namespace ocelli::test {

inline constexpr const char* kStudyMazePlan = R"(["+-+-+-+-+-+-+",
                                                  "|           |",
                                                  "+ +-+ + +-+ +",
                                                  "|   | |   | |",
                                                  "+-+ + + + + +",
                                                  "|           |",
                                                  "+ + + +-+ + +",
                                                  "| | |   | | |",
                                                  "+ +-+ + + + +",
                                                  "|     |     |",
                                                  "+-+-+-+ +-+-+"])";

}  // namespace ocelli::test
