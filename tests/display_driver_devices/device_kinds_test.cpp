#include "display_driver/devices/device_kinds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/display_driver_devices/test_devices.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    openDevice(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DeviceKindsTest, namesAreDifferentAndSayWhatTheyAre) {
  std::map<std::string, int> names;
  for (const DeviceKind& kind : deviceKinds()) {
    EXPECT_EQ(++names[kind.name], 1) << kind.name;
    EXPECT_FALSE(kind.help.empty());
    EXPECT_EQ(kind.restName.empty(), kind.rest == DeviceKind::Rest::kNone);
  }
}

/// The recipe at the top of device.h: a new kind is one line in the table, and these tests find it.
TEST(DeviceKindsTest, everyKindIsTested) {
  for (const DeviceKind& kind : deviceKinds()) {
    ASSERT_TRUE(test::testDevices().contains(kind.name))
        << kind.name << ": add it to tests/display_driver_devices/test_devices.h";
    EXPECT_EQ(test::testDevices().at(kind.name).rest == nullptr, std::string(kind.name) == "usb");
  }
}

TEST(DeviceKindsTest, unknownNamesAreAnsweredWithTheKnownOnes) {
  for (const char* text : {"", ":", "usb3", "NULL", "nul", "null "}) {
    for (const DeviceKind& kind : deviceKinds()) {
      EXPECT_THAT(refusal(text), HasSubstr(kind.usage())) << text;
    }
  }
}

TEST(DeviceKindsTest, whatFollowsTheNameIsChecked) {
  EXPECT_THAT(refusal("null:x"), HasSubstr("nothing follows"));
  EXPECT_THAT(refusal("null:"), HasSubstr("nothing follows"));
  EXPECT_THAT(refusal("file"), HasSubstr("PATH.svol"));
  EXPECT_THAT(refusal("file:"), HasSubstr("PATH.svol"));
  EXPECT_THAT(refusal("file:picture.png"), HasSubstr(".svol"));
}

// A kind that may be registered would be one too many for the other tests: examples/add_a_device registers one.
TEST(RegisterDevice, refusesWhatNobodyCouldOpen) {
  const auto refusalOf = [](DeviceKind kind) -> std::string {
    try {
      registerDevice(std::move(kind));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto open = [](const std::string&, const DeviceOptions&) { return std::unique_ptr<Device>(); };
  const size_t before = deviceKinds().size();
  for (const DeviceKind& kind : deviceKinds()) {
    EXPECT_THAT(refusalOf({.name = kind.name, .open = open}), HasSubstr(kind.name));
  }
  EXPECT_THAT(refusalOf({.name = "my:display", .open = open}), HasSubstr("my:display"));
  EXPECT_NE(refusalOf({.name = "", .open = open}), "");
  EXPECT_THAT(refusalOf({.name = "mine"}), HasSubstr("mine"));
  EXPECT_EQ(deviceKinds().size(), before);
}

}  // namespace
}  // namespace ocelli
