// What Assimp may open: regular files, each of which raises the limits of this process.
#pragma once

#include <memory>

#include "oc_core/base/reading_budget.h"

namespace Assimp {
class IOSystem;
}

namespace ocelli {

/// Files as Assimp's own system opens them, for reading alone; what is no regular file (a device, a pipe) counts as
/// missing. What is missing beside the first file, the scene, is opened by what its name says as a URI
/// (percent_decoded.h), as glTF has names. `budget` must outlive it and may be null.
std::unique_ptr<Assimp::IOSystem> makeLimitedFiles(ReadingBudget* budget);

}  // namespace ocelli
