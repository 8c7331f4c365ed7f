// Cameras from JSON texts, for tests.
#pragma once

#include <functional>
#include <string>

namespace ocelli {
class JsonFields;
}

namespace ocelli::test {

/// Hands `read` the fields of the text, in which ' stands for ", and refuses those that it does not know.
void readText(std::string text, const std::function<void(JsonFields&)>& read);

/// The message of the InputError that this throws, empty for none.
std::string errorOfText(const std::string& text, const std::function<void(JsonFields&)>& read);

}  // namespace ocelli::test
