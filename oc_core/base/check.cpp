#include "oc_core/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace ocelli {

void checkFailed(const char* condition, const char* message, const char* file, int line) {
  std::fprintf(stderr, "internal error: %s (%s) at %s:%d; please report this\n", message, condition, file, line);
  std::abort();
}

}  // namespace ocelli
