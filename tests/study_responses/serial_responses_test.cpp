#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"
#include "tests/study_responses/pseudo_box.h"

namespace ocelli::test {
namespace {

std::unique_ptr<ResponseDevice> openBox(const PseudoBox& box, const std::string& more = "") {
  return openResponseDevice("serial:" + box.device() + more, {});
}

TEST(SerialResponses, takesDigitsAndLettersForKeys) {
  const PseudoBox box;
  const auto device = openBox(box);
  box.send("1a\r");
  EXPECT_EQ(textOf(awaitChanges(*device, 6)), "+1 -1 +A -A +Enter -Enter");
  EXPECT_EQ(device->counts().presses, 3);
}

TEST(SerialResponses, giveEachPressTheTimeWhenItCame) {
  const PseudoBox box;
  const auto device = openBox(box, ",9600");
  const int64_t before = steadyNanoseconds();
  box.send("2");
  const std::vector<KeyChange> changes = awaitChanges(*device, 2);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_GE(changes.front().nanoseconds, before);
  EXPECT_LE(changes.front().nanoseconds, steadyNanoseconds());
}

TEST(SerialResponses, followTheMapAndHoldKeysUntilTheirRelease) {
  const PseudoBox box;
  const auto device = openBox(box, ",115200,A=Left,a=-Left,0x01=Enter");
  box.send("A");
  EXPECT_EQ(textOf(awaitChanges(*device, 1)), "+Left");
  box.send("x\x01");
  EXPECT_EQ(textOf(awaitChanges(*device, 2)), "+Enter -Enter");
  box.send("a");
  EXPECT_EQ(textOf(awaitChanges(*device, 1)), "-Left");
  EXPECT_EQ(device->counts().unknown, 1) << "x";
  EXPECT_EQ(device->counts().presses, 2);
}

TEST(SerialResponses, releaseWhatWasHeldWhenTheBoxIsPulledOut) {
  PseudoBox box;
  const auto device = openBox(box, ",A=Left,a=-Left");
  box.send("A");
  EXPECT_EQ(textOf(awaitChanges(*device, 1)), "+Left");
  EXPECT_TRUE(device->isConnected());
  box.unplug();
  EXPECT_EQ(textOf(awaitChanges(*device, 1)), "-Left");
  EXPECT_FALSE(device->isConnected());
}

TEST(SerialResponses, sendBytesForATestOfLatency) {
  const PseudoBox box;
  const auto device = openBox(box);
  EXPECT_TRUE(device->send('U'));
  char byte = 0;
  EXPECT_EQ(read(box.master(), &byte, 1), 1);
  EXPECT_EQ(byte, 'U');
}

TEST(SerialResponses, sayWhatIsWrong) {
  const PseudoBox box;
  for (const char* more : {",7", ",ab=1", ",1=Foo", ",0x100=1", ",115200,1"}) {
    EXPECT_THROW(openBox(box, more), InputError) << more;
  }
  EXPECT_THROW(openResponseDevice("serial:/dev/no such box", {}), WorkError);
  EXPECT_THROW(openResponseDevice("serial:/dev/null", {}), InputError);
}

}  // namespace
}  // namespace ocelli::test
