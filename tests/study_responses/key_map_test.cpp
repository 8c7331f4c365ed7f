#include "study/responses/key_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli::test {
namespace {

TEST(KeyMap, readsPairs) {
  const std::vector<KeyMapEntry> map = keyMapFromText("1=1,a=Left,0x41=-PageUp", "here");
  ASSERT_EQ(map.size(), 3u);
  EXPECT_EQ(map[0].from, "1");
  EXPECT_EQ(map[0].key, Key::k1);
  EXPECT_FALSE(map[0].releases);
  EXPECT_EQ(map[1].key, Key::kLeft);
  EXPECT_EQ(map[2].from, "0x41");
  EXPECT_EQ(map[2].key, Key::kPageUp);
  EXPECT_TRUE(map[2].releases);
  EXPECT_TRUE(keyMapFromText("", "here").empty());
}

TEST(KeyMap, saysWhatIsWrong) {
  for (const char* text : {"1", "=1", "1=", "1=left", "1=1,,2=2", "1=--1", "a=Foo"}) {
    EXPECT_THROW(keyMapFromText(text, "here"), InputError) << text;
  }
}

}  // namespace
}  // namespace ocelli::test
