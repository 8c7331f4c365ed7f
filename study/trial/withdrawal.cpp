#include "study/trial/withdrawal.h"

#include <nlohmann/json.hpp>

#include "oc_core/base/sha256.h"

namespace ocelli {
namespace {

constexpr const char* kSalt = "salt";
constexpr const char* kKeySha256 = "subject_key_sha256";

}  // namespace

bool Withdrawal::isOf(const std::string& subjectKey) const {
  return sha256(salt + subjectKey) == keySha256;
}

std::string jsonText(const Withdrawal& withdrawal) {
  const nlohmann::ordered_json detail = {{kSalt, withdrawal.salt}, {kKeySha256, withdrawal.keySha256}};
  return detail.dump();
}

std::optional<Withdrawal> withdrawalOf(const std::string& detailJson) {
  const auto detail = nlohmann::json::parse(detailJson, nullptr, false);
  const auto hasText = [&](const char* name) { return detail.contains(name) && detail[name].is_string(); };
  if (!detail.is_object() || !hasText(kSalt) || !hasText(kKeySha256)) {
    return std::nullopt;
  }
  return Withdrawal{detail[kSalt].get<std::string>(), detail[kKeySha256].get<std::string>()};
}

}  // namespace ocelli
