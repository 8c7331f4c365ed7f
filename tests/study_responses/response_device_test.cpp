#include "study/responses/response_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

TEST(ResponseDevices, areDocumented) {
  const std::string docs = readFile(OCELLI_SOURCE_DIR "/docs/responses.md", 1'000'000);
  for (const ResponseDeviceKind& kind : responseDeviceKinds()) {
    EXPECT_THAT(docs, HasSubstr("| `" + kind.form + "` |"));
  }
}

TEST(ResponseDevices, areFoundByName) {
  for (const char* text : {"", "radio", "radio:7", "keyboard"}) {
    EXPECT_THROW(openResponseDevice(text, {}), InputError) << text;
  }
  EXPECT_THAT(responseDeviceForms(), HasSubstr("serial:DEVICE[,BAUD][,BYTE=KEY...]"));
}

}  // namespace
}  // namespace ocelli::test
