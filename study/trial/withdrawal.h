// Who withdrew from a study, in a form that names nobody: a salted hash of the random key that the subject had.
#pragma once

#include <optional>
#include <string>

namespace ocelli {

struct Withdrawal {
  std::string salt;
  std::string keySha256;  ///< of the salt and the subject's key, one after the other; 64 hexadecimal digits

  bool isOf(const std::string& subjectKey) const;
};

/// As the audit trail keeps it: JSON.
std::string jsonText(const Withdrawal& withdrawal);
/// Nothing where the text is of something else.
std::optional<Withdrawal> withdrawalOf(const std::string& detailJson);

/// Rows of the audit trail that tell of withdrawals: their `detail_json`, in their order.
inline constexpr const char* kWithdrawalQuery =
    "SELECT detail_json FROM audit WHERE action = 'withdrawn' ORDER BY audit_id";

}  // namespace ocelli
