// A study's database as the data of an analysis, through the schema alone (protocols/trials.schema.sql).
#pragma once

#include "analysis/dataset/dataset.h"

namespace ocelli {

/// Everything is of one moment, also while a session writes the database; its -wal file is part of it. Nothing is
/// written to it. Throws InputError where the file is missing, empty, damaged, no study's, or of another version of
/// the schema; and for a row that the schema does not allow.
Dataset readDatabase(const std::string& path);

}  // namespace ocelli
