// What an error says, in parts, for a line of states and for messages about scripts.
#pragma once

#include <string>

#include "oc_core/base/error.h"

namespace ocelli {

struct ExploreMessage {
  std::string what;  ///< where and what, one line
  std::string next;  ///< what to try; may be empty
};

inline ExploreMessage messageOf(const Error& error) {
  const std::string text = error.what();
  const std::string mark = "\n  try: ";
  const size_t at = text.find(mark);
  return {text.substr(0, text.find('\n')), at == std::string::npos ? "" : text.substr(at + mark.size())};
}

}  // namespace ocelli
