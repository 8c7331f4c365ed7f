#include <malloc.h>

#include "cli/program.h"

int main(int argumentCount, char** arguments) {
  // Images of some megabytes come and go. What is freed of them stays with the process: to have memory from the system
  // again each time, page by page, costs more than to decode an image.
  constexpr int kLargestKept = 32 << 20;  // glibc takes no more
  mallopt(M_MMAP_THRESHOLD, kLargestKept);
  mallopt(M_TRIM_THRESHOLD, 4 * kLargestKept);
  return ocelli::runProgram(argumentCount, arguments);
}
