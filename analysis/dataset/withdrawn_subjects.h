// Subjects who withdrew from one database and are still in another, such as an older copy: no analysis takes them.
#pragma once

#include <vector>

#include "analysis/dataset/dataset.h"

namespace ocelli {

/// Takes out all that the parts hold of subjects who withdrew from one of them (DataSource::withdrawals), with a note
/// that names the source but not the subject. Tables do not hold the keys that tell who they are.
void removeWithdrawn(std::vector<Dataset>& parts);

}  // namespace ocelli
