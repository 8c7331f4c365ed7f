#include "study/protocol/balance.h"

#include <gtest/gtest.h>

#include "tests/study_protocol/sham_protocol.h"

namespace ocelli::test {
namespace {

constexpr auto kBalanced = TrialOrder::kBalanced;
constexpr auto kBoth = ViewsOfCases::kAll;
constexpr auto kOne = ViewsOfCases::kOne;

/// So many blocks, of even and odd numbers of cases, in both views and in one.
Protocol protocolOf(int blocks, bool shuffle) {
  std::vector<ProtocolBlock> list;
  for (int i = 0; i < blocks; ++i) {
    list.push_back(shamBlock(std::string("block ").append(1, static_cast<char>('a' + i)), 3 + i % 4, kBalanced,
                             i % 2 == 0 ? kBoth : kOne));
  }
  return shamProtocol(list, shuffle);
}

void expectBalanced(const Protocol& protocol, bool twoOrders = false) {
  for (int session = 1; session <= protocol.sessions; ++session) {
    for (int subjects = 1; subjects <= 60; ++subjects) {
      for (const BalanceTable& table : balanceOf(protocol, subjects, session, 5)) {
        const bool mayDifferByTwo = twoOrders && table.factors.ends_with("x first view");
        EXPECT_LE(table.difference, mayDifferByTwo ? 2 : 1) << table.factors << " over " << subjects;
      }
    }
  }
}

TEST(Balance, HasCellsThatDifferByAtMostOneForOneToSixtySubjects) {
  expectBalanced(protocolOf(1, false));
  expectBalanced(protocolOf(4, false));
  expectBalanced(protocolOf(3, true));
  expectBalanced(protocolOf(4, true));
  expectBalanced(protocolOf(5, true));
}

TEST(Balance, HasOnePairThatDiffersByTwoWithTwoOrders) {
  expectBalanced(protocolOf(2, true), true);
}

TEST(Balance, CountsEverySubjectInEveryTable) {
  for (const BalanceTable& table : balanceOf(protocolOf(3, true), 7, 2, 5)) {
    int sum = 0;
    for (const BalanceCell& cell : table.cells) {
      sum += cell.subjects;
    }
    EXPECT_EQ(sum % 7, 0) << table.factors;
    EXPECT_GT(sum, 0) << table.factors;
  }
}

TEST(Balance, SeesWhatIsNotBalanced) {
  // Of one subject, one of two cells is full. Of three over six orders no cell may have two.
  const std::vector<BalanceTable> tables = balanceOf(protocolOf(3, true), 1, 1, 5);
  ASSERT_FALSE(tables.empty());
  for (const BalanceTable& table : tables) {
    EXPECT_EQ(table.difference, 1) << table.factors;
  }
}

TEST(Balance, SaysNothingOfBlocksThatAreTheSameForEveryone) {
  EXPECT_TRUE(balanceOf(shamProtocol({shamBlock("a", 4, TrialOrder::kAlternating, kBoth)}, false), 10, 1, 5).empty());
}

}  // namespace
}  // namespace ocelli::test
