// Protocols whose tasks only count their cases: for what is between the trials.
#pragma once

#include "study/protocol/protocol.h"

namespace ocelli::test {

/// A task of so many cases, which take 10 s and 30 s at the longest.
std::shared_ptr<const TaskBlock> shamTask(int cases);
ProtocolBlock shamBlock(const std::string& name, int cases, TrialOrder order, ViewsOfCases views);
Protocol shamProtocol(std::vector<ProtocolBlock> blocks, bool shuffle = true, int sessions = 3);

}  // namespace ocelli::test
