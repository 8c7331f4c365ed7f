// A client's messages in and out, without sockets.
#include "oc_core/remote/server/client_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/remote_server/fake_images.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr int64_t kSecond = 1'000'000'000;

std::string textOf(const OutgoingMessage& message) {
  return {reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()};
}

TEST(SlowLink, sendsOneMessageAfterTheOtherAndAllOfThemLater) {
  SlowLink link({.bytesPerSecond = 1000, .delayMilliseconds = 200});
  EXPECT_TRUE(link.isSlow());
  EXPECT_EQ(link.leavesAt(500, 0), kSecond / 2 + kSecond / 5);
  EXPECT_EQ(link.leavesAt(500, 0), kSecond + kSecond / 5) << "the delay does not add up";
  EXPECT_EQ(link.leavesAt(100, 5 * kSecond), 5 * kSecond + kSecond / 10 + kSecond / 5) << "it was idle";
  EXPECT_FALSE(SlowLink({}).isSlow());
  EXPECT_EQ(SlowLink({}).leavesAt(500, 7), 7);
}

TEST(ClientOutbox, sendsTextsThenTheImageInPieces) {
  ClientOutbox outbox;
  EXPECT_TRUE(outbox.isEmpty());
  EXPECT_FALSE(outbox.next());
  outbox.addImage(fakeImage({}, 5, 70'000, 10), 1);
  EXPECT_EQ(outbox.heldBytes(), 70'010u);
  outbox.addText(ClientOutbox::Kind::kQueued, "old", 2);
  outbox.addText(ClientOutbox::Kind::kHello, "hello", 2);
  outbox.addText(ClientOutbox::Kind::kQueued, "new", 3);
  EXPECT_EQ(textOf(*outbox.next()), "hello");
  EXPECT_EQ(textOf(*outbox.next()), "new") << "one text of a kind";
  RemoteAssembly assembly(remoteImageHeaderFromJson(textOf(*outbox.next())));
  size_t pieces = 0;
  while (const auto message = outbox.next()) {
    EXPECT_FALSE(message->isText);
    EXPECT_LE(message->bytes.size(), RemotePiece::kMaxMessageBytes);
    EXPECT_EQ(message->readyAt, 1);
    assembly.add(pieceOf(message->bytes));
    ++pieces;
    if (pieces == 1) {
      outbox.addText(ClientOutbox::Kind::kError, "between", 4);
      EXPECT_EQ(textOf(*outbox.next()), "between");
    }
  }
  EXPECT_EQ(pieces, 4u) << "three of colours, one of depths";
  EXPECT_TRUE(assembly.hasColor() && assembly.hasDepth());
  EXPECT_EQ(outbox.imagesSent(), 1u);
  EXPECT_EQ(outbox.heldBytes(), 0u);
  EXPECT_FALSE(outbox.hasImage());
}

TEST(ClientOutbox, sendsImagesWithoutDepthOrBytes) {
  ClientOutbox outbox;
  outbox.addImage(fakeImage({}, 1, 10, 0), 0);
  EXPECT_TRUE(outbox.next()->isText);
  EXPECT_EQ(outbox.next()->bytes.size(), RemotePiece::kHeaderBytes + 10);
  EXPECT_FALSE(outbox.hasImage());
  RemoteImage nothing;
  nothing.headerJson = "{}";
  outbox.addImage(nothing, 0);
  EXPECT_TRUE(outbox.next()->isText);
  EXPECT_FALSE(outbox.hasImage());
}

class ClientSessionTest : public testing::Test {
 protected:
  ClientSession::Received say(const std::string& text, int64_t now) { return session_.receive(text, false, true, now); }

  RemoteLimits limits_{
      .clients = 1, .looksPerSecond = 3, .messageBytes = 1000, .handshakeSeconds = 5, .idleSeconds = 60};
  ClientSession session_{limits_, {}, 0};
};

TEST_F(ClientSessionTest, PutsMessagesTogether) {
  const std::string text = lookText(4);
  EXPECT_FALSE(session_.receive(text.substr(0, 5), false, false, 0).look);
  EXPECT_FALSE(session_.receive("", false, false, 0).look);
  const auto received = session_.receive(text.substr(5), false, true, 0);
  ASSERT_TRUE(received.look);
  EXPECT_EQ(received.look->sequence, 4u);
  EXPECT_TRUE(say(lookText(5), 0).look) << "the next one begins anew";
  EXPECT_EQ(session_.looks(), 2u);
}

TEST_F(ClientSessionTest, TakesSoManyMessagesASecond) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(say(lookText(1), 0).look);
  }
  EXPECT_TRUE(say(lookText(1), kSecond / 3 + 1).look) << "one more each third of a second";
  const auto received = say(lookText(1), kSecond / 3 + 2);
  ASSERT_TRUE(received.close);
  EXPECT_EQ(received.close->code, 1008);
}

TEST_F(ClientSessionTest, EndsAtMessagesThatAreTooLongOrBinary) {
  EXPECT_EQ(session_.receive("x", true, true, 0).close->code, 1003);
  EXPECT_FALSE(session_.receive(std::string(600, ' '), false, false, 0).close);
  EXPECT_EQ(session_.receive(std::string(600, ' '), false, false, 0).close->code, 1009) << "also in parts";
}

TEST_F(ClientSessionTest, AnswersWhatItCannotRead) {
  for (const char* text : {"", "{", "[]", "null", "{\"type\":\"look\"}", "{\"type\":\"shout\"}"}) {
    ClientSession session(RemoteLimits{}, {}, 0);
    const auto received = session.receive(text, false, true, 0);
    EXPECT_FALSE(received.look || received.close) << text;
    EXPECT_THAT(textOf(*session.nextDue(0)), HasSubstr("\"type\":\"error\"")) << text;
  }
}

TEST_F(ClientSessionTest, KnowsWhenItsTimeIsOver) {
  EXPECT_FALSE(session_.outOfTime(60 * kSecond));
  EXPECT_TRUE(session_.outOfTime(60 * kSecond + 1)) << "idle";
  EXPECT_TRUE(say(lookText(1), 50 * kSecond).look);
  EXPECT_FALSE(session_.outOfTime(100 * kSecond));
  session_.receive("{", false, false, 100 * kSecond);
  EXPECT_FALSE(session_.outOfTime(105 * kSecond));
  EXPECT_TRUE(session_.outOfTime(105 * kSecond + 1)) << "the rest of a message";
}

TEST(ClientSession, holdsMessagesForItsLink) {
  ClientSession session(RemoteLimits{}, {.bytesPerSecond = 1'000'000, .delayMilliseconds = 100}, 0);
  session.outbox().addImage(fakeImage({}, 1, 3 * RemotePiece::kMaxBytes, 0), 0);
  int64_t now = 0;
  size_t bytes = 0;
  size_t messages = 0;
  while (!session.outbox().isEmpty() || session.leavesAt()) {
    if (const auto message = session.nextDue(now)) {
      bytes += message->bytes.size();
      ++messages;
      // As fast as the link, and after the delay: within a nanosecond of rounding a message.
      EXPECT_NEAR(static_cast<double>(now), static_cast<double>(bytes) * 1000 + 1e8, 5);
    } else {
      ASSERT_GT(*session.leavesAt(), now);
      now = *session.leavesAt();
    }
  }
  EXPECT_EQ(messages, 4u);
  EXPECT_EQ(session.bytesSent(), bytes);
}

/// A delay makes images come later, not fewer of them: the next one may be drawn when the last byte of this one has
/// begun its way.
TEST(ClientSession, ADelayCostsNoThroughput) {
  constexpr size_t kBytes = 100'000;  // a tenth of a second each
  ClientSession session(RemoteLimits{}, {.bytesPerSecond = 1'000'000, .delayMilliseconds = 1000}, 0);
  int64_t now = 0;
  size_t most = 0;
  uint32_t images = 0;
  while (session.outbox().imagesSent() < 20) {
    const bool isSent = session.nextDue(now).has_value();
    if (!session.outbox().hasImage()) {
      session.outbox().addImage(fakeImage({}, ++images, kBytes, 0), now);  // drawn in no time
    } else if (!isSent) {
      ASSERT_TRUE(session.leavesAt());
      ASSERT_GT(*session.leavesAt(), now);
      now = *session.leavesAt();
    }
    most = std::max(most, session.heldBytes());
  }
  EXPECT_LT(now, 3 * kSecond) << "20 images took 2 s at their rate, and with the delay of each 22";
  EXPECT_LE(most, 1'000'000 + 2 * RemotePiece::kMaxMessageBytes) << "what is on its way in a second, and one piece";
}

/// Where nothing but the delay holds them, not all that there is goes into memory.
TEST(ClientSession, HoldsSoMuchAndNoMore) {
  ClientSession session(RemoteLimits{}, {.delayMilliseconds = 60'000}, 0);
  for (uint32_t id = 1; id <= 40; ++id) {
    if (!session.outbox().hasImage()) {
      session.outbox().addImage(fakeImage({}, id, 1'000'000, 0), 0);
    }
    EXPECT_FALSE(session.nextDue(0));
  }
  EXPECT_TRUE(session.outbox().hasImage());
  EXPECT_LE(session.heldBytes(), (size_t{16} << 20) + RemotePiece::kMaxMessageBytes);
  ASSERT_EQ(session.leavesAt(), 60 * kSecond);
  EXPECT_TRUE(session.nextDue(60 * kSecond));
}

}  // namespace
}  // namespace ocelli::test
