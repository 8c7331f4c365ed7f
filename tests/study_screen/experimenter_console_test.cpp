#include "study/screen/experimenter_console.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>

namespace ocelli {
namespace {

using testing::HasSubstr;
using Kind = ConsoleCommand::Kind;

/// A console whose input a test types, and whose output it reads.
class Pipes {
 public:
  Pipes() {
    EXPECT_EQ(pipe(in_.data()), 0);
    EXPECT_EQ(pipe(out_.data()), 0);
  }
  ~Pipes() {
    for (const int end : {in_[0], in_[1], out_[0], out_[1]}) {
      close(end);
    }
  }
  ConsoleStreams streams() const { return {in_[0], out_[1]}; }
  void type(const std::string& text) {
    EXPECT_EQ(write(in_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void hangUp() {
    close(in_[1]);
    in_[1] = dup(out_[0]);
  }
  /// What was printed until it holds `text`.
  std::string readUntil(const std::string& text) {
    std::string all;
    while (all.find(text) == std::string::npos) {
      std::array<char, 512> bytes{};
      const ssize_t count = read(out_[0], bytes.data(), bytes.size());
      if (count <= 0) {
        break;
      }
      all.append(bytes.data(), static_cast<size_t>(count));
    }
    return all;
  }

 private:
  std::array<int, 2> in_{};
  std::array<int, 2> out_{};
};

std::vector<ConsoleCommand> takeSoon(ExperimenterConsole& console, size_t count) {
  std::vector<ConsoleCommand> all;
  for (int i = 0; i < 500 && all.size() < count; ++i) {  // five seconds, for a busy machine
    const std::vector<ConsoleCommand> some = console.take();
    all.insert(all.end(), some.begin(), some.end());
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return all;
}

TEST(ExperimenterConsole, takesCommandsFromAPipeInTheirOrder) {
  Pipes pipes;
  ExperimenterConsole console(pipes.streams());
  pipes.type("pause\nno");
  pipes.type("te wears glasses\nhelp\nnonsense\nredo\nresu");
  const std::vector<ConsoleCommand> commands = takeSoon(console, 3);
  EXPECT_THAT(commands, testing::ElementsAre(ConsoleCommand{Kind::kPause}, ConsoleCommand{Kind::kNote, "wears glasses"},
                                             ConsoleCommand{Kind::kRedo}));
  const std::string said = pipes.readUntil("nonsense");
  EXPECT_THAT(said, HasSubstr("note TEXT")) << "the help";
  pipes.type("me\n");
  EXPECT_THAT(takeSoon(console, 1), testing::ElementsAre(ConsoleCommand{Kind::kResume}));
}

TEST(ExperimenterConsole, outlivesTheEndOfItsInput) {
  Pipes pipes;
  ExperimenterConsole console(pipes.streams());
  pipes.type("status\n");
  EXPECT_EQ(takeSoon(console, 1).size(), 1u);
  pipes.hangUp();
  console.print("still here");
  EXPECT_THAT(pipes.readUntil("still here"), HasSubstr("still here\n"));
}

TEST(ExperimenterConsole, printsALineForEachStep) {
  Pipes pipes;
  {
    ExperimenterConsole console(pipes.streams());
    console.setStatus("S01: consent", "0 of 6");
    EXPECT_EQ(pipes.readUntil("consent\n"), "S01: consent\n");
    console.setStatus("S01: consent", "1 of 6");
    console.setStatus("S01: trial 1", "1 of 6");
    EXPECT_EQ(pipes.readUntil("trial 1\n"), "S01: trial 1\n") << "figures alone are no news";
    console.print("last words");
  }
  EXPECT_EQ(pipes.readUntil("words\n"), "last words\n");
}

}  // namespace
}  // namespace ocelli
