#include "oc_core/base/error.h"

namespace ocelli {
namespace {

std::string sentence(const std::string& what, const std::string& where, const std::string& next) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!next.empty()) {
    text += "\n  try: " + next;
  }
  return text;
}

}  // namespace

Error::Error(const std::string& what, const std::string& where, const std::string& next)
    : std::runtime_error(sentence(what, where, next)) {}

}  // namespace ocelli
