#include "cli/program.h"

int main(int argumentCount, char** arguments) {
  return ocelli::runProgram(argumentCount, arguments);
}
