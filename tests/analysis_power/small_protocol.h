// A protocol of few trials, for tests that simulate many studies.
#pragma once

#include "study/protocol/protocol.h"

namespace ocelli::test {

/// 8 searches, 8 counts and 8 paths in one session, balanced.
std::string smallProtocolText();
Protocol smallProtocol();

}  // namespace ocelli::test
