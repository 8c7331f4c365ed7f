#include "cli/device_selftest_show.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>

#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

constexpr std::chrono::seconds kShownWithin(5);

void show(const TestPattern& pattern, Device& device) {
  const auto fence = device.submit(pattern.volume(device.profile()));
  device.present(fence->number(), {});
  const FrameState state = fence->wait(FrameStage::kShown, kShownWithin);
  if (state.stage != FrameStage::kShown) {
    const std::string why = state.problem.empty() ? device.telemetry().lastProblem : state.problem;
    throw WorkError("the display did not show the pattern " + pattern.name + (why.empty() ? "" : ": " + why),
                    device.info().name, "see `ocelli device info`, and whether its screen turns");
  }
}

std::string questionOf(const TestPattern& pattern, size_t number, size_t count) {
  std::string text = fmt::format("\n{}/{}  {}\n{}\n", number, count, pattern.title, pattern.shows);
  for (const std::string& look : pattern.lookFor) {
    text += "  - " + look + "\n";
  }
  return text + "Does it look so? [y, n, either with a note; b back, q quit] ";
}

struct Answer {
  char key = 'q';  ///< one of y, n, b, q
  std::string note;
};

/// "y", "yes", "N too dim"; nothing for what is no answer.
std::optional<Answer> answerFrom(const std::string& line) {
  constexpr std::string_view kSpace = " \t\r";
  const size_t begin = std::min(line.find_first_not_of(kSpace), line.size());
  const size_t end = std::min(line.find_first_of(kSpace, begin), line.size());
  std::string word = line.substr(begin, end - begin);
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string_view known : {"yes", "no", "back", "quit"}) {
    if (word == known || word == known.substr(0, 1)) {
      const size_t note = std::min(line.find_first_not_of(kSpace, end), line.size());
      return Answer{known.front(), line.substr(note, line.find_last_not_of(kSpace) + 1 - note)};
    }
  }
  return std::nullopt;
}

/// What is no answer, such as an empty line, is asked again. The end of the answers quits.
Answer ask(const std::string& question, std::istream& answers, const CommandContext& context) {
  context.print(question);
  for (std::string line;;) {
    flushStandardOutput();
    if (!std::getline(answers, line)) {
      return {};
    }
    if (std::optional<Answer> answer = answerFrom(line)) {
      return *answer;
    }
    context.print("Please answer with y (it looks so), n (it does not), b (back) or q (quit): ");
  }
}

std::string nameOf(const PatternVerdict& verdict) {
  switch (verdict.verdict) {
    case PatternVerdict::kNotSeen:
      return "not seen";
    case PatternVerdict::kRight:
      return "right";
    case PatternVerdict::kWrong:
      return "wrong";
  }
  return "";
}

std::string quoted(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) {
    field += c == '"' ? "\"\"" : std::string(1, c);
  }
  return field + "\"";
}

/// Of a file that writeVerdicts() wrote, by the pattern; empty where there is none.
std::map<std::string, std::string> linesOf(const std::filesystem::path& path) {
  std::map<std::string, std::string> lines;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    lines[line.substr(0, line.find(','))] = line;
  }
  return lines;
}

}  // namespace

std::vector<PatternVerdict> showPatterns(const std::vector<const TestPattern*>& patterns, Device& device,
                                         std::istream& answers, const CommandContext& context,
                                         const std::function<void(const std::vector<PatternVerdict>&)>& answered) {
  std::vector<PatternVerdict> verdicts;
  for (const TestPattern* pattern : patterns) {
    verdicts.push_back({.pattern = pattern});
  }
  for (size_t i = 0; i < patterns.size();) {
    show(*patterns[i], device);
    const Answer answer = ask(questionOf(*patterns[i], i + 1, patterns.size()), answers, context);
    if (answer.key == 'q') {
      return verdicts;
    }
    if (answer.key == 'b') {
      i = i == 0 ? 0 : i - 1;
      continue;
    }
    verdicts[i].verdict = answer.key == 'n' ? PatternVerdict::kWrong : PatternVerdict::kRight;
    verdicts[i].note = answer.note;
    answered(verdicts);
    ++i;
  }
  return verdicts;
}

void writeVerdicts(const std::filesystem::path& path, const std::vector<PatternVerdict>& verdicts) {
  std::map<std::string, std::string> lines = linesOf(path);
  for (const PatternVerdict& verdict : verdicts) {
    const std::string& name = verdict.pattern->name;
    if (verdict.verdict != PatternVerdict::kNotSeen || !lines.contains(name)) {
      lines[name] = fmt::format("{},{},{}", name, nameOf(verdict), quoted(verdict.note));
    }
  }
  OutputFile file(path);
  file.write("pattern,verdict,note\n");
  for (const TestPattern& pattern : testPatterns()) {
    if (const auto line = lines.find(pattern.name); line != lines.end()) {
      file.write(line->second + "\n");
    }
  }
  file.commit();
}

}  // namespace ocelli
