#include "display_driver/serial/serial_frame.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"

namespace ocelli::serial {
namespace {

std::vector<Packet> packetsOf(std::span<const uint8_t> line, PacketReader* reader = nullptr) {
  PacketReader own;
  std::vector<Packet> packets;
  (reader != nullptr ? *reader : own).read(line, [&](const Packet& packet) { packets.push_back(packet); });
  return packets;
}

std::vector<uint8_t> randomContent(Random& random, size_t most = 249) {
  std::vector<uint8_t> content(random.below(most + 1));
  for (uint8_t& byte : content) {
    byte = random.below(3) == 0 ? 0 : static_cast<uint8_t>(random.below(256));
  }
  return content;
}

TEST(SerialFrame, isWhatThePageOfTheProtocolSays) {
  std::vector<uint8_t> line;
  addPacket(line, PacketType::kOpen, std::vector<uint8_t>{0x44, 0x33, 0, 0x11});
  // The CRC-32C of 01 44 33 00 11 by a plain loop over the polynomial.
  uint32_t crc = 0xffffffff;
  for (const unsigned byte : {0x01u, 0x44u, 0x33u, 0x00u, 0x11u}) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = crc >> 1 ^ ((crc & 1) != 0 ? 0x82f63b78u : 0);
    }
  }
  crc = ~crc;
  std::vector<uint8_t> body{0x11};
  for (int i = 0; i < 4; ++i) {
    body.push_back(static_cast<uint8_t>(crc >> 8 * i));
    ASSERT_NE(body.back(), 0) << "the case is chosen so";
  }
  std::vector<uint8_t> expected{4, 0x01, 0x44, 0x33, 6};
  expected.insert(expected.end(), body.begin(), body.end());
  expected.push_back(0);
  EXPECT_EQ(line, expected);
}

TEST(SerialFrame, everyContentComesBackAndHasNoZeroOnTheWay) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<uint8_t> content = randomContent(random);
    std::vector<uint8_t> line;
    addPacket(line, PacketType::kEvents, content);
    EXPECT_EQ(std::find(line.begin(), line.end(), 0), line.end() - 1);
    EXPECT_LE(line.size(), kMaxBody + 2);
    const std::vector<Packet> packets = packetsOf(line);
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0].type, PacketType::kEvents);
    EXPECT_EQ(packets[0].content, content);
  }
}

TEST(SerialFrame, aDamagedPacketIsPassedOverAndTheNextOneIsRead) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    std::vector<uint8_t> line;
    addPacket(line, PacketType::kData, randomContent(random));
    const size_t end = line.size();
    addPacket(line, PacketType::kHeard, std::vector<uint8_t>{1, 2, 3});
    line.push_back(0);
    // Not the 0 between them: without it both are lost.
    const size_t at = random.below(end - 1);
    if (random.below(2) == 0) {
      line.erase(line.begin() + static_cast<std::ptrdiff_t>(at));
    } else {
      line[at] = static_cast<uint8_t>(line[at] ^ 1 << random.below(8));
    }
    PacketReader reader;
    const std::vector<Packet> packets = packetsOf(line, &reader);
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0].content, (std::vector<uint8_t>{1, 2, 3}));
    EXPECT_GE(reader.damaged(), 1u);
  }
}

TEST(SerialFrame, anyBytesAreReadWithoutMemoryGrowing) {
  Random random(3);
  PacketReader reader;
  for (int i = 0; i < 1000; ++i) {
    std::vector<uint8_t> noise(1000);
    for (uint8_t& byte : noise) {
      byte = static_cast<uint8_t>(i % 2 == 0 ? 1 + random.below(255) : random.below(4));
    }
    EXPECT_TRUE(packetsOf(noise, &reader).empty());
  }
  std::vector<uint8_t> line{0};
  addPacket(line, PacketType::kOpen, {});
  EXPECT_EQ(packetsOf(line, &reader).size(), 1u);
}

}  // namespace
}  // namespace ocelli::serial
