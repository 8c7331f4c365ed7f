#include "study/store/withdrawals.h"

#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "oc_core/base/sha256.h"
#include "study/store/sqlite_connection.h"

namespace ocelli {
namespace {

constexpr const char* kSalt = "salt";
constexpr const char* kKeySha256 = "subject_key_sha256";
constexpr const char* kWithdrawn = "withdrawn";

std::string detailOf(const Withdrawal& withdrawal) {
  const nlohmann::ordered_json detail = {{kSalt, withdrawal.salt}, {kKeySha256, withdrawal.keySha256}};
  return detail.dump();
}

}  // namespace

std::string withdrawalDetail(const std::string& subjectKey) {
  const std::string salt = randomKey();
  return detailOf({salt, sha256(salt + subjectKey)});
}

std::vector<Withdrawal> withdrawalsOf(SQLite::Database& database) {
  std::vector<Withdrawal> withdrawals;
  SQLite::Statement row(database, "SELECT detail_json FROM audit WHERE action = 'withdrawn'");
  while (row.executeStep()) {
    const auto detail = nlohmann::json::parse(textOf(row, 0), nullptr, false);
    if (detail.is_object() && detail.contains(kSalt) && detail.contains(kKeySha256)) {
      withdrawals.push_back({detail.value(kSalt, ""), detail.value(kKeySha256, "")});
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
      addAudit(database, kWithdrawn, detailOf(one));
    }
  }
  transaction.commit();
}

bool isWithdrawn(const std::vector<Withdrawal>& withdrawals, const std::string& subjectKey) {
  return std::any_of(withdrawals.begin(), withdrawals.end(),
                     [&](const Withdrawal& one) { return sha256(one.salt + subjectKey) == one.keySha256; });
}

}  // namespace ocelli
