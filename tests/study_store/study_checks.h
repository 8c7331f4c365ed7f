// What tests of databases ask again and again.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace ocelli::test {

/// The message of the error that `work` throws; fails the test where it throws none of that kind.
template <class Kind, class Work>
std::string messageOf(const Work& work) {
  try {
    work();
  } catch (const Kind& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

}  // namespace ocelli::test
