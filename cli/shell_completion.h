// What shells complete of the command line: commands, options, and values that are one of a few words; files otherwise.
#pragma once

#include <array>
#include <string>

#include "cli/command_text.h"

namespace ocelli {

struct CompletedShell {
  const char* name;
  std::string (*script)(const CommandText& program);
};

std::string bashCompletion(const CommandText& program);
std::string zshCompletion(const CommandText& program);

inline constexpr std::array<CompletedShell, 2> kCompletedShells{{{"bash", &bashCompletion}, {"zsh", &zshCompletion}}};

}  // namespace ocelli
