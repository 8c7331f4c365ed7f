// A small protocol with one block of each task, for tests to change.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace ocelli::test {

/// Has all fields that hold other objects.
nlohmann::json smallProtocol();
/// The message of the InputError that reading this protocol gives; empty where it is read.
std::string protocolError(const nlohmann::json& json);

}  // namespace ocelli::test
