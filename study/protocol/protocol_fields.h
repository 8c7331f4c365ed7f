// Parts of a protocol file that only a study reads, or more strictly than an analysis: pages, forms and rules of
// exclusion. All throw InputError naming the field.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace ocelli {

class JsonFields;

/// In the field `name`.
ProtocolPage readPage(JsonFields& fields, const std::string& name, const std::string& language);
/// Nothing where the field is missing.
std::vector<ProtocolPage> readPages(JsonFields& fields, const std::string& name, const std::string& language);
ProtocolForm readForm(JsonFields& fields, const std::string& name, const FormSetting& setting);

/// Defaults where fields are missing.
ScreenGeometry screenGeometry(const StatedScreen& stated);
/// The field "exclusions".
std::vector<ExclusionRule> readExclusions(JsonFields& fields, const Protocol& protocol);

}  // namespace ocelli
