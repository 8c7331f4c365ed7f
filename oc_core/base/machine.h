// What this machine has that the toolkit cares for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace ocelli {

struct MachineInfo {
  std::string processor;  ///< its name, empty where the system does not tell
  int threads = 0;        ///< that the toolkit uses
  bool hasAvx2 = false;
  uint64_t memoryBytes = 0;     ///< 0 where the system does not tell, here and below
  uint64_t availableBytes = 0;  ///< of it, without swapping
};

MachineInfo machineInfo();

/// Its name in the network; empty where the system does not tell.
std::string computerName();

/// Keeps memory that is given back for what is asked for next, instead of handing it to the system: for work that makes
/// and drops many images. Does nothing where the library of the system cannot be told so.
void keepFreedMemory();

/// Where the shell would find a program; nothing where it would not.
std::optional<std::filesystem::path> findProgram(const std::string& name);

}  // namespace ocelli
