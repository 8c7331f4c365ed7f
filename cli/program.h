// The `ocelli` program.
#pragma once

namespace ocelli {

/// Returns the exit code: 0 done, 1 the work failed, 2 the command line or an input file is wrong.
int runProgram(int argumentCount, char** arguments);

}  // namespace ocelli
