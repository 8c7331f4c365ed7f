#include "oc_core/checksum/crc32c.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace ocelli {
namespace {

uint32_t sumOf(std::string_view text, uint32_t before = 0) {
  return crc32c({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, before);
}

// RFC 3720, section B.4, and the check value of the catalogue of CRCs.
TEST(Crc32c, IsCastagnolis) {
  EXPECT_EQ(sumOf("123456789"), 0xe3069283u);
  EXPECT_EQ(crc32c(std::vector<uint8_t>(32, 0)), 0x8a9136aau);
  EXPECT_EQ(crc32c(std::vector<uint8_t>(32, 0xff)), 0x62a8ab43u);
  EXPECT_EQ(sumOf(""), 0u);
}

TEST(Crc32c, GoesOnFromWhatCameBefore) {
  EXPECT_EQ(sumOf("56789", sumOf("1234")), sumOf("123456789"));
}

}  // namespace
}  // namespace ocelli
