#include "study/store/withdrawals.h"

#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <set>

#include "oc_core/base/sha256.h"
#include "study/store/sqlite_connection.h"

namespace ocelli {
namespace {

constexpr const char* kWithdrawn = "withdrawn";

}  // namespace

std::string withdrawalDetail(const std::string& subjectKey) {
  const std::string salt = randomKey();
  return jsonText(Withdrawal{salt, sha256(salt + subjectKey)});
}

std::vector<Withdrawal> withdrawalsOf(SQLite::Database& database) {
  std::vector<Withdrawal> withdrawals;
  SQLite::Statement row(database, kWithdrawalQuery);
  while (row.executeStep()) {
    if (const std::optional<Withdrawal> one = withdrawalOf(textOf(row, 0))) {
      withdrawals.push_back(*one);
    }
  }
  return withdrawals;
}

void rememberWithdrawals(SQLite::Database& database, const std::vector<Withdrawal>& withdrawals) {
  std::set<std::string> known;
  for (const Withdrawal& one : withdrawalsOf(database)) {
    known.insert(one.salt);
  }
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  for (const Withdrawal& one : withdrawals) {
    if (known.insert(one.salt).second) {
      addAudit(database, kWithdrawn, jsonText(one));
    }
  }
  transaction.commit();
}

bool isWithdrawn(const std::vector<Withdrawal>& withdrawals, const std::string& subjectKey) {
  return std::any_of(withdrawals.begin(), withdrawals.end(),
                     [&](const Withdrawal& one) { return one.isOf(subjectKey); });
}

}  // namespace ocelli
