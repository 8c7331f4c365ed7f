// `ocelli device selftest --device`: the patterns on a display, one after the other, and what somebody says of them.
#pragma once

#include <filesystem>
#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "cli/command.h"
#include "display_driver/device/device.h"
#include "display_driver/selftest/test_patterns.h"

namespace ocelli {

/// What was said of a pattern last.
struct PatternVerdict {
  const TestPattern* pattern = nullptr;
  enum { kNotSeen, kRight, kWrong } verdict = kNotSeen;
  std::string note{};
};

/// Shows each pattern on the device and asks for an answer, a line of `answers`: "y" (right), "n" (wrong), either with
/// a note after it, "b" (back), "q" (quit). Any other line, an empty one too, is asked again. The end of `answers`
/// quits. `answered` gets all verdicts after each of them. Throws WorkError where a pattern is not shown within some
/// seconds.
std::vector<PatternVerdict> showPatterns(const std::vector<const TestPattern*>& patterns, Device& device,
                                         std::istream& answers, const CommandContext& context,
                                         const std::function<void(const std::vector<PatternVerdict>&)>& answered);

/// A table with a line a pattern: pattern, verdict, note. What the file says already of patterns that have not been
/// seen now stays, so that a checklist can be gone through in parts.
void writeVerdicts(const std::filesystem::path& path, const std::vector<PatternVerdict>& verdicts);

}  // namespace ocelli
