// Who withdrew from a database, in a form that names nobody: a salted hash of the subject's random key. It keeps a
// merge from bringing back who has gone.
#pragma once

#include <string>
#include <vector>

#include "study/trial/withdrawal.h"

namespace SQLite {
class Database;
}

namespace ocelli {

/// Of a subject with that key, as the audit trail keeps it: JSON.
std::string withdrawalDetail(const std::string& subjectKey);

/// Those that the audit trail of the database has.
std::vector<Withdrawal> withdrawalsOf(SQLite::Database& database);

/// Adds those to the audit trail that it does not have yet.
void rememberWithdrawals(SQLite::Database& database, const std::vector<Withdrawal>& withdrawals);

bool isWithdrawn(const std::vector<Withdrawal>& withdrawals, const std::string& subjectKey);

}  // namespace ocelli
