#include "base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <opencv2/core/utility.hpp>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace morphkit {
namespace {

using Bands = std::vector<std::pair<int, int>>;

/// Runs each test with 1, 2 and 5 threads and puts the default back.
class Parallel : public testing::TestWithParam<int> {
 protected:
  ProcessThreads allowed_{GetParam()};
  Workers workers_{GetParam()};
  Workers::Scope scope_{workers_};
};

INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1, 2, 5));

/// Keeps a thread busy until `done`, or until others had enough time to run.
template <typename Done>
void let_others_run(const Done& done) {
  for (int i = 0; i < 200 && !done(); ++i) std::this_thread::yield();
}

TEST(Workers, AreThoseOfTheScopeOfTheThread) {
  const int outside = threads();
  EXPECT_GE(outside, 1);
  const int other = outside + 2;
  const Workers many(other), one(1);
  many.run([&] {
    EXPECT_EQ(threads(), other);
    EXPECT_EQ(one.run([] { return threads(); }), 1);
    EXPECT_EQ(threads(), other);
    std::thread([&] { EXPECT_NE(threads(), other) << "a thread does not inherit them"; }).join();
    std::thread([&, same = Workers::current()] { same.run([&] { EXPECT_EQ(threads(), other); }); }).join();
    EXPECT_THROW(one.run([]() -> int { throw std::runtime_error("inside"); }), std::runtime_error);
    EXPECT_EQ(threads(), other);
  });
  EXPECT_EQ(threads(), outside);
  EXPECT_GE(Workers(0).run([] { return threads(); }), 1);
  EXPECT_THROW(Workers(-1), std::invalid_argument);
}

TEST(Workers, LeaveTheSettingsOfTheProcessAlone) {
  const int before = cv::getNumThreads();
  const Workers workers(before + 2);
  workers.run([&] {
    for_rows(
        100, [](int, int) {}, 1);
  });
  EXPECT_EQ(cv::getNumThreads(), before);
}

TEST(Workers, RowsOutsideOfAnyScope) {
  std::atomic<int> rows = 0;
  for_rows(100, [&](int begin, int end) { rows += end - begin; });
  EXPECT_EQ(rows, 100);
}

TEST_P(Parallel, NoMoreThreadsThanAllowed) {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  for_rows(
      200,
      [&](int, int) {
        {
          const std::scoped_lock lock(mutex);
          ids.insert(std::this_thread::get_id());
        }
        let_others_run([] { return false; });
      },
      1);
  EXPECT_LE(ids.size(), static_cast<std::size_t>(GetParam()));
}

TEST_P(Parallel, EveryRowOnceInBandsOfTheGrain) {
  for (const int height : {0, 1, 2, 7, 8, 9, 65, 67, 1080}) {
    for (const int grain : {1, 8, 64, 5000}) {
      SCOPED_TRACE(testing::Message() << "height " << height << ", grain " << grain);
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(height));
      std::mutex mutex;
      Bands bands;
      for_rows(
          height,
          [&](int begin, int end) {
            for (int y = begin; y < end; ++y) ++visits[static_cast<std::size_t>(y)];
            const std::scoped_lock lock(mutex);
            bands.emplace_back(begin, end);
          },
          grain);
      EXPECT_TRUE(std::ranges::all_of(visits, [](int n) { return n == 1; }));
      Bands expected;
      for (int y = 0; y < height; y += grain) expected.emplace_back(y, std::min(y + grain, height));
      const bool alone = grain > 1 && expected.size() > 1 && expected.back().second - expected.back().first == 1;
      if (alone) {
        expected.pop_back();
        expected.back().second = height;
      }
      std::ranges::sort(bands);
      EXPECT_EQ(bands, expected);
    }
  }
}

TEST_P(Parallel, GrainBelowOneIsRefused) {
  EXPECT_THROW(for_rows(
                   10, [](int, int) {}, 0),
               std::invalid_argument);
}

TEST_P(Parallel, ForRowsRethrowsAnException) {
  const auto failing = [](int begin, int) {
    if (begin == 40) throw std::runtime_error("row 40");
  };
  try {
    for_rows(100, failing, 8);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "row 40");
  }
  // The arena still works.
  std::atomic<int> rows = 0;
  for_rows(100, [&](int begin, int end) { rows += end - begin; });
  EXPECT_EQ(rows, 100);
}

TEST_P(Parallel, RowsWithinRows) {
  std::atomic<int> cells = 0;
  for_rows(
      20,
      [&](int, int) {
        for_rows(
            30, [&](int begin, int end) { cells += end - begin; }, 4);
      },
      1);
  EXPECT_EQ(cells, 600);
}

TEST_P(Parallel, PipelineDeliversAllInOrderWithinTheBound) {
  for (const int in_flight : {1, 2, 3, 8}) {
    SCOPED_TRACE(testing::Message() << in_flight << " in flight");
    std::atomic<int> alive = 0;
    std::atomic<int> most_alive = 0;
    std::atomic<int> delivering = 0;
    std::vector<std::int64_t> order;
    const auto make = [&](std::int64_t index) {
      const int now = ++alive;
      int most = most_alive;
      while (now > most && !most_alive.compare_exchange_weak(most, now)) {
      }
      // Unequal work, so that items overtake each other.
      let_others_run([&] { return index % 3 != 0; });
      return std::shared_ptr<void>(new std::int64_t(index), [&alive](void* p) {
        delete static_cast<std::int64_t*>(p);
        --alive;
      });
    };
    const auto deliver = [&](std::int64_t index, const std::shared_ptr<void>& item) {
      EXPECT_EQ(++delivering, 1);
      EXPECT_EQ(*static_cast<const std::int64_t*>(item.get()), index);
      order.push_back(index);
      --delivering;
    };
    EXPECT_EQ(run_pipeline(100, in_flight, make, deliver), 100);
    ASSERT_EQ(order.size(), 100U);
    EXPECT_TRUE(std::ranges::is_sorted(order));
    EXPECT_LE(most_alive, in_flight);
    EXPECT_EQ(alive, 0);
  }
}

TEST_P(Parallel, RowsWithinThePipeline) {
  std::int64_t sum = 0;
  const auto make = [](std::int64_t index) {
    std::atomic<std::int64_t> rows = 0;
    for_rows(
        257, [&](int begin, int end) { rows += end - begin; }, 2);
    return rows * index;
  };
  const auto deliver = [&](std::int64_t, std::int64_t item) {
    std::atomic<std::int64_t> rows = 0;
    for_rows(
        10, [&](int begin, int end) { rows += end - begin; }, 2);
    sum += item * rows;
  };
  EXPECT_EQ(run_pipeline(50, 4, make, deliver), 50);
  EXPECT_EQ(sum, std::int64_t{257} * 10 * 49 * 50 / 2);
}

TEST_P(Parallel, WithoutItemsNothingIsCalled) {
  const auto make = [](std::int64_t) -> std::int64_t { throw std::logic_error("called"); };
  const auto deliver = [](std::int64_t, std::int64_t) {};
  EXPECT_EQ(run_pipeline(0, 4, make, deliver), 0);
  EXPECT_THROW(run_pipeline(1, 0, make, deliver), std::invalid_argument);
}

TEST_P(Parallel, TheFirstFailingItemIsReportedAndEarlierOnesAreDelivered) {
  for (int round = 0; round < 20; ++round) {
    std::vector<std::int64_t> order;
    std::atomic<std::int64_t> made = 0;
    const auto make = [&](std::int64_t index) {
      ++made;
      // The first failing item in order is the last one in time.
      if (index == 20) let_others_run([] { return false; });
      if (index >= 20) throw std::runtime_error(std::to_string(index));
      return index;
    };
    const auto deliver = [&](std::int64_t index, std::int64_t) { order.push_back(index); };
    try {
      run_pipeline(1000, 4, make, deliver);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "20");
    }
    ASSERT_EQ(order.size(), 20U);
    EXPECT_TRUE(std::ranges::is_sorted(order));
    EXPECT_LE(made, 24);
  }
}

TEST_P(Parallel, RowsFailingWithinThePipeline) {
  const auto make = [](std::int64_t index) {
    for_rows(
        64,
        [&](int begin, int) {
          if (index == 3 && begin == 32) throw std::runtime_error("row 32");
        },
        8);
    return index;
  };
  const auto deliver = [](std::int64_t, std::int64_t) {};
  EXPECT_THROW(run_pipeline(10, 2, make, deliver), std::runtime_error);
}

TEST_P(Parallel, FailingDeliveryStopsThePipeline) {
  std::atomic<int> alive = 0;
  std::int64_t last = -1;
  const auto make = [&](std::int64_t) {
    ++alive;
    return std::shared_ptr<void>(nullptr, [&alive](void*) { --alive; });
  };
  const auto deliver = [&](std::int64_t index, const std::shared_ptr<void>&) {
    last = index;
    if (index == 7) throw std::runtime_error("disk full");
  };
  EXPECT_THROW(run_pipeline(1000, 3, make, deliver), std::runtime_error);
  EXPECT_EQ(last, 7);
  EXPECT_EQ(alive, 0);
}

TEST_P(Parallel, CancellingDeliversTheItemsAlreadyBegun) {
  std::atomic<std::int64_t> made = 0;
  std::vector<std::int64_t> order;
  int asked = 0;
  const auto make = [&](std::int64_t index) {
    ++made;
    return index;
  };
  const auto deliver = [&](std::int64_t index, std::int64_t) { order.push_back(index); };
  // True from the eleventh call on: ten items have begun.
  const std::int64_t delivered = run_pipeline(1000, 4, make, deliver, [&] { return ++asked > 10; });
  EXPECT_EQ(delivered, 10);
  EXPECT_EQ(made, 10);
  ASSERT_EQ(order.size(), 10U);
  EXPECT_TRUE(std::ranges::is_sorted(order));
  EXPECT_EQ(run_pipeline(1000, 4, make, deliver, [] { return true; }), 0);
}

TEST_P(Parallel, AnExceptionFromCancelledIsRethrownAfterDelivery) {
  int asked = 0;
  std::int64_t delivered = 0;
  const auto make = [](std::int64_t index) { return index; };
  const auto deliver = [&](std::int64_t, std::int64_t) { ++delivered; };
  const auto cancelled = [&] {
    if (++asked > 5) throw std::runtime_error("no answer");
    return false;
  };
  EXPECT_THROW(run_pipeline(100, 4, make, deliver, cancelled), std::runtime_error);
  EXPECT_EQ(delivered, 5);
}

}  // namespace
}  // namespace morphkit
