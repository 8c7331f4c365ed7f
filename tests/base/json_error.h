// What a reader of JSON says.
#pragma once

#include <string>

#include "oc_core/base/error.h"

namespace ocelli::test {

template <class Call>
std::string jsonErrorOf(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace ocelli::test
