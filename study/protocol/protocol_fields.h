// Parts of a protocol file: pages, forms, screen, timing and rules of exclusion. All throw InputError naming the field.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace ocelli {

class JsonFields;

/// Characters of a title.
inline constexpr size_t kMaxTitle = 200;

/// In the field `name`.
ProtocolPage readPage(JsonFields& fields, const std::string& name);
/// Nothing where the field is missing.
std::vector<ProtocolPage> readPages(JsonFields& fields, const std::string& name);
ProtocolForm readForm(JsonFields& fields, const std::string& name, const ViewConditions& conditions);

/// The fields "screen", "timing" and "exclusions"; defaults where they are missing.
ScreenGeometry readScreen(JsonFields& fields);
TimingLimits readTiming(JsonFields& fields);
std::vector<ExclusionRule> readExclusions(JsonFields& fields, const Protocol& protocol);

}  // namespace ocelli
