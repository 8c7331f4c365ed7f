#include "study/store/program_version.h"

namespace ocelli {

const char* programVersion() {
  return OCELLI_VERSION;
}

}  // namespace ocelli
