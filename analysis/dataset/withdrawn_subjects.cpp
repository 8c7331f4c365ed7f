#include "analysis/dataset/withdrawn_subjects.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

namespace ocelli {
namespace {

struct KnownWithdrawal {
  Withdrawal withdrawal;
  std::string path;  ///< of the database that tells of it
};

std::vector<KnownWithdrawal> withdrawalsOf(const std::vector<Dataset>& parts) {
  std::vector<KnownWithdrawal> known;
  for (const Dataset& part : parts) {
    for (const DataSource& source : part.sources) {
      for (const Withdrawal& withdrawal : source.withdrawals) {
        known.push_back({withdrawal, source.path});
      }
    }
  }
  return known;
}

}  // namespace

void removeWithdrawn(std::vector<Dataset>& parts) {
  const std::vector<KnownWithdrawal> known = withdrawalsOf(parts);
  for (Dataset& part : parts) {
    std::set<std::string> gone;
    std::string from;
    for (const Subject& subject : part.subjects) {
      const auto found = std::find_if(known.begin(), known.end(), [&](const KnownWithdrawal& each) {
        return !subject.key.empty() && each.withdrawal.isOf(subject.key);
      });
      if (found != known.end()) {
        gone.insert(subject.id);
        from = found->path;
      }
    }
    if (gone.empty()) {
      continue;
    }
    const auto isGone = [&](const auto& row) { return gone.contains(row.subject); };
    std::erase_if(part.subjects, [&](const Subject& subject) { return gone.contains(subject.id); });
    std::erase_if(part.sessions, isGone);
    std::erase_if(part.consents, isGone);
    std::erase_if(part.answers, isGone);
    std::erase_if(part.runs, isGone);
    std::erase_if(part.otherAttempts, isGone);
    const size_t trials = std::erase_if(part.trials, isGone);
    part.notes.push_back(fmt::format(
        "{} still has subjects who withdrew, as {} tells: they are left out (subjects: {}, trials: {}). `ocelli study "
        "withdraw` deletes them there too.",
        part.sources.front().path, from, gone.size(), trials));
  }
}

}  // namespace ocelli
