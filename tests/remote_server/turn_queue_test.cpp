#include "oc_core/remote/server/turn_queue.h"

#include <gtest/gtest.h>

#include <map>

namespace ocelli::test {
namespace {

RemoteRequest requestOf(uint32_t sequence) {
  RemoteRequest request;
  request.sequence = sequence;
  return request;
}

TEST(TurnQueue, takesClientsInTheOrderInWhichTheyAsked) {
  TurnQueue queue;
  queue.ask(3, requestOf(30));
  queue.ask(1, requestOf(10));
  queue.ask(2, requestOf(20));
  EXPECT_EQ(queue.turnsBefore(3), 0u);
  EXPECT_EQ(queue.turnsBefore(2), 2u);
  for (const uint64_t client : {3, 1, 2}) {
    const auto turn = queue.next();
    ASSERT_TRUE(turn);
    EXPECT_EQ(turn->client, client);
    EXPECT_EQ(turn->request.sequence, 10 * client);
  }
  EXPECT_FALSE(queue.next());
}

TEST(TurnQueue, aNewerRequestTakesThePlaceOfOneThatWaits) {
  TurnQueue queue;
  queue.ask(1, requestOf(1));
  queue.ask(2, requestOf(2));
  queue.ask(1, requestOf(3));
  const auto turn = queue.next();
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->client, 1u) << "its place in the queue stays";
  EXPECT_EQ(turn->request.sequence, 3u);
  EXPECT_EQ(queue.next()->client, 2u);
  EXPECT_FALSE(queue.next());
}

TEST(TurnQueue, aClientHasOneTurnAtATime) {
  TurnQueue queue;
  queue.ask(1, requestOf(1));
  ASSERT_TRUE(queue.next());
  queue.ask(1, requestOf(2));
  EXPECT_FALSE(queue.next());
  queue.finish(1, 1);
  EXPECT_EQ(queue.next()->request.sequence, 2u);
}

TEST(TurnQueue, waitsForClientsThatAreNotReady) {
  TurnQueue queue;
  queue.ask(1, requestOf(1));
  queue.setReady(1, false);
  queue.ask(2, requestOf(2));
  EXPECT_EQ(queue.turnsBefore(2), 0u) << "who is not ready is in nobody's way";
  EXPECT_EQ(queue.next()->client, 2u);
  EXPECT_FALSE(queue.next());
  queue.setReady(1, true);
  EXPECT_EQ(queue.next()->client, 1u);
}

TEST(TurnQueue, forgetsClientsThatLeave) {
  TurnQueue queue;
  queue.ask(1, requestOf(1));
  queue.leave(1);
  EXPECT_FALSE(queue.next());
  queue.ask(2, requestOf(2));
  ASSERT_TRUE(queue.next());
  queue.leave(2);
  queue.finish(2, 1);
  EXPECT_EQ(queue.size(), 0u);
}

/// Clients that ask again as soon as their turn ends, whose turns take as long as `cost` says: the time that each has
/// had.
std::map<uint64_t, double> sharesOf(TurnQueue& queue, const std::map<uint64_t, double>& cost, double total) {
  std::map<uint64_t, double> had;
  for (const auto& [client, seconds] : cost) {
    queue.ask(client, requestOf(1));
  }
  for (double time = 0; time < total;) {
    const auto turn = queue.next();
    const double seconds = cost.at(turn->client);
    time += seconds;
    had[turn->client] += seconds;
    queue.ask(turn->client, requestOf(1));
    queue.finish(turn->client, seconds);
  }
  return had;
}

TEST(TurnQueue, sharesAreEqualWithinOneTurn) {
  TurnQueue queue;
  // Four clients, one of which asks for images that take nine times as long as those of another.
  const std::map<uint64_t, double> cost{{1, 1}, {2, 3}, {3, 9}, {4, 2}};
  for (int round = 0; round < 3; ++round) {
    const auto had = sharesOf(queue, cost, 400);
    for (const auto& [a, secondsOfA] : had) {
      for (const auto& [b, secondsOfB] : had) {
        // The bound of start-time fair queueing for two clients that always wait.
        EXPECT_LE(std::abs(secondsOfA - secondsOfB), cost.at(a) + cost.at(b)) << a << " and " << b;
      }
    }
  }
}

TEST(TurnQueue, nobodySavesUpTurns) {
  TurnQueue queue;
  sharesOf(queue, {{1, 1}}, 100);
  // One that comes later shares from then on; the other does not pay for the time alone.
  TurnQueue later = queue;
  const auto had = sharesOf(later, {{1, 1}, {2, 1}}, 50);
  EXPECT_NEAR(had.at(1), had.at(2), 2);
}

}  // namespace
}  // namespace ocelli::test
