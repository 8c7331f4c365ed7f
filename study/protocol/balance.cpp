#include "study/protocol/balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace ocelli {
namespace {

/// Counts subjects in cells. Cells of one group are to be alike.
class Table {
 public:
  explicit Table(std::string factors, bool ofTrials = false) {
    table_.factors = std::move(factors);
    table_.ofTrials = ofTrials;
  }

  void declare(int group, const std::string& levels) {
    if (index_.emplace(levels, table_.cells.size()).second) {
      table_.cells.push_back({levels, 0});
      groups_.push_back(group);
    }
  }
  void count(const std::string& levels) { ++table_.cells.at(index_.at(levels)).subjects; }

  BalanceTable finish() {
    std::map<int, std::pair<int, int>> ranges;
    for (size_t i = 0; i < table_.cells.size(); ++i) {
      const int subjects = table_.cells[i].subjects;
      const auto [range, isNew] = ranges.emplace(groups_[i], std::pair(subjects, subjects));
      range->second = {std::min(range->second.first, subjects), std::max(range->second.second, subjects)};
      table_.difference = std::max(table_.difference, range->second.second - range->second.first);
    }
    return std::move(table_);
  }

 private:
  BalanceTable table_;
  std::map<std::string, size_t> index_{};
  std::vector<int> groups_{};
};

std::string orderName(const Protocol& protocol, const std::vector<int>& order) {
  std::string name;
  for (const int block : order) {
    name += fmt::format("{}{}", name.empty() ? "" : ", ", protocol.blocks[static_cast<size_t>(block)].name);
  }
  return name;
}

std::string firstName(const Protocol& protocol, TrialView view) {
  return fmt::format("{} first", protocol.nameOf(view));
}

/// The view in which the subject sees each case of the block first.
std::vector<TrialView> viewsOfCases(const Protocol& protocol, const SessionSchedule& schedule, int block) {
  const int cases = protocol.blocks[static_cast<size_t>(block)].task->caseCount();
  std::vector<TrialView> views(static_cast<size_t>(cases), TrialView::kReference);
  for (auto trial = schedule.trials.rbegin(); trial != schedule.trials.rend(); ++trial) {
    if (trial->block == block) {
      views[static_cast<size_t>(trial->caseIndex)] = trial->view;
    }
  }
  return views;
}

using Orders = std::vector<std::vector<int>>;
using Schedules = std::vector<SessionSchedule>;

void addSessionTables(const Protocol& protocol, const Schedules& schedules, const Orders& orders,
                      std::vector<BalanceTable>& tables) {
  Table first("first view");
  Table order("block order");
  Table both("first view x block order");
  Table places("block x place in the session");
  for (const TrialView view : protocol.conditions.names.all()) {
    first.declare(0, firstName(protocol, view));
    for (const std::vector<int>& each : orders) {
      order.declare(0, orderName(protocol, each));
      both.declare(0, fmt::format("{}; {}", firstName(protocol, view), orderName(protocol, each)));
    }
  }
  const auto placeName = [&](int block, size_t place) {
    return fmt::format("{} in place {}", protocol.blocks[static_cast<size_t>(block)].name, place + 1);
  };
  for (const int block : orders.front()) {
    for (size_t place = 0; place < orders.front().size(); ++place) {
      places.declare(0, placeName(block, place));
    }
  }
  for (const SessionSchedule& schedule : schedules) {
    first.count(firstName(protocol, schedule.firstView));
    order.count(orderName(protocol, schedule.blockOrder));
    both.count(
        fmt::format("{}; {}", firstName(protocol, schedule.firstView), orderName(protocol, schedule.blockOrder)));
    for (size_t place = 0; place < schedule.blockOrder.size(); ++place) {
      places.count(placeName(schedule.blockOrder[place], place));
    }
  }
  tables.push_back(first.finish());
  if (orders.size() > 1) {
    tables.push_back(order.finish());
    tables.push_back(both.finish());
    tables.push_back(places.finish());
  }
}

void addBlockTables(const Protocol& protocol, const Schedules& schedules, const Orders& orders, int index,
                    std::vector<BalanceTable>& tables) {
  const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(index)];
  const char* seen = block.views == ViewsOfCases::kOne ? "view" : "view that shows it first";
  const std::string title = fmt::format("{}: case x {}", block.name, seen);
  Table views(title);
  Table withFirst(fmt::format("{} x first view", title));
  Table withOrder(fmt::format("{} x block order", title));
  const auto name = [&](int caseIndex, TrialView view) {
    return fmt::format("{} in {}", block.task->caseInfo(caseIndex).label, protocol.nameOf(view));
  };
  const int cases = block.task->caseCount();
  const ViewConditions& conditions = protocol.conditions.names;
  for (int i = 0; i < cases; ++i) {
    for (const TrialView view : conditions.all()) {
      views.declare(i, name(i, view));
      for (const TrialView firstView : conditions.all()) {
        // Of a pair the last of an odd number of cases always has the first view.
        if (!conditions.isPair() || cases % 2 == 0 || i != cases - 1 || firstView == view) {
          withFirst.declare(i, fmt::format("{}, {}", name(i, view), firstName(protocol, firstView)));
        }
      }
      for (const std::vector<int>& order : orders) {
        withOrder.declare(i, fmt::format("{}; {}", name(i, view), orderName(protocol, order)));
      }
    }
  }
  for (const SessionSchedule& schedule : schedules) {
    const std::vector<TrialView> seenIn = viewsOfCases(protocol, schedule, index);
    for (int i = 0; i < cases; ++i) {
      const std::string cell = name(i, seenIn[static_cast<size_t>(i)]);
      views.count(cell);
      withFirst.count(fmt::format("{}, {}", cell, firstName(protocol, schedule.firstView)));
      withOrder.count(fmt::format("{}; {}", cell, orderName(protocol, schedule.blockOrder)));
    }
  }
  tables.push_back(views.finish());
  tables.push_back(withFirst.finish());
  if (orders.size() > 1) {
    tables.push_back(withOrder.finish());
  }
}

/// Conditions by place in the block, and by the condition of the trial before.
void addOrderTables(const Protocol& protocol, const Schedules& schedules, int index,
                    std::vector<BalanceTable>& tables) {
  const ViewConditions& conditions = protocol.conditions.names;
  const std::string& block = protocol.blocks[static_cast<size_t>(index)].name;
  Table places(fmt::format("{}: view x place in the block", block));
  Table neighbors(fmt::format("{}: view x view of the trial before", block), true);
  const auto placeName = [&](size_t place, TrialView view) {
    return fmt::format("{} in place {}", conditions.nameOf(view), place + 1);
  };
  const auto pairName = [&](TrialView before, TrialView after) {
    return fmt::format("{} after {}", conditions.nameOf(after), conditions.nameOf(before));
  };
  const auto viewsOf = [&](const SessionSchedule& schedule) {
    std::vector<TrialView> views;
    for (const TrialPlan& trial : schedule.trials) {
      if (trial.block == index) {
        views.push_back(trial.view);
      }
    }
    return views;
  };
  const size_t length = schedules.empty() ? 0 : viewsOf(schedules.front()).size();
  for (const TrialView view : conditions.all()) {
    for (size_t place = 0; place < length; ++place) {
      places.declare(0, placeName(place, view));
    }
    for (const TrialView other : conditions.all()) {
      if (other != view) {
        neighbors.declare(0, pairName(view, other));
      }
    }
  }
  for (const SessionSchedule& schedule : schedules) {
    const std::vector<TrialView> views = viewsOf(schedule);
    for (size_t place = 0; place < views.size(); ++place) {
      places.count(placeName(place, views[place]));
      if (place > 0 && views[place] != views[place - 1]) {
        neighbors.count(pairName(views[place - 1], views[place]));
      }
    }
  }
  tables.push_back(places.finish());
  tables.push_back(neighbors.finish());
}

}  // namespace

std::vector<BalanceTable> balanceOf(const Protocol& protocol, int subjects, int session, uint64_t seed) {
  Schedules schedules;
  for (int slot = 0; slot < subjects; ++slot) {
    schedules.push_back(scheduleOf(protocol, slot, session, seed));
  }
  const Orders orders = blockOrdersOf(protocol, session);
  const auto isBalanced = [&](int block) {
    return protocol.blocks[static_cast<size_t>(block)].order == TrialOrder::kBalanced;
  };
  std::vector<BalanceTable> tables;
  const std::vector<int>& blocks = orders.front();
  if (protocol.conditions.names.size() == 1 && orders.size() == 1) {
    return tables;
  }
  if (orders.size() > 1 || std::any_of(blocks.begin(), blocks.end(), isBalanced)) {
    addSessionTables(protocol, schedules, orders, tables);
  }
  for (const int block : blocks) {
    if (isBalanced(block)) {
      if (!protocol.blocks[static_cast<size_t>(block)].staircase) {  // a staircase chooses its cases
        addBlockTables(protocol, schedules, orders, block, tables);
      }
      if (protocol.conditions.names.size() > 2) {
        addOrderTables(protocol, schedules, block, tables);
      }
    }
  }
  return tables;
}

}  // namespace ocelli
