#include "isobench/foundation/monitor.h"

#include <gtest/gtest.h>

#include <thread>

#include "isobench/foundation/error.h"

namespace isobench {
namespace {

struct Recorder : ProgressSink {
  void show(const std::string& stage, double fraction) override { calls.emplace_back(stage, fraction); }
  std::vector<std::pair<std::string, double>> calls;
};

void sleep_ms(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

TEST(Monitor, StagesNestAndAreBookedWhenTheyEnd) {
  Monitor monitor;
  {
    const Monitor::Stage outer = monitor.stage("particles");
    { const Monitor::Stage inner = monitor.stage("seeds"); }
    { const Monitor::Stage inner = monitor.stage("relax"); }
  }
  const Monitor::Stage next = monitor.stage("delaunay");
  std::vector<std::string> names;
  for (const StageTime& stage : monitor.stages()) names.push_back(stage.name);
  EXPECT_EQ(names, (std::vector<std::string>{"particles/seeds", "particles/relax", "particles"}));
}

TEST(Monitor, AStageThatIsVisitedTwiceAddsUp) {
  Monitor monitor;
  for (int visit = 0; visit < 2; ++visit) {
    const Monitor::Stage stage = monitor.stage("wait");
    sleep_ms(20);
  }
  ASSERT_EQ(monitor.stages().size(), 1U);
  EXPECT_GE(monitor.seconds("wait"), 0.040);
  EXPECT_EQ(monitor.seconds("other"), 0.0);
}

TEST(Monitor, SleepingCostsWallTimeButNoCpuTime) {
  Monitor monitor;
  {
    const Monitor::Stage stage = monitor.stage("wait");
    sleep_ms(100);
  }
  const StageTime& time = monitor.stages().front();
  // Waking up costs microseconds; half the wall time leaves room for a loaded machine.
  EXPECT_LT(time.cpu_seconds, 0.5 * time.wall_seconds);
}

TEST(Monitor, TheCpuClockCountsAllThreads) {
  Monitor monitor;
  const auto burn = [] {
    timespec time{};
    do clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    while (time.tv_sec == 0 && time.tv_nsec < 50'000'000);
  };
  {
    const Monitor::Stage stage = monitor.stage("burn");
    std::thread first(burn);
    std::thread second(burn);
    first.join();
    second.join();
  }
  EXPECT_GE(monitor.stages().front().cpu_seconds, 0.1);
}

TEST(Monitor, AStageIsBookedEvenWhenAnErrorLeavesIt) {
  Monitor monitor;
  try {
    const Monitor::Stage stage = monitor.stage("outer");
    throw DataError("damaged");
  } catch (const DataError&) {
  }
  ASSERT_EQ(monitor.stages().size(), 1U);
  const Monitor::Stage after = monitor.stage("after");
  EXPECT_EQ(monitor.stages().front().name, "outer");
}

TEST(Monitor, ShowsProgressOfTheCurrentStageWithinBounds) {
  Recorder recorder;
  Monitor monitor(&recorder);
  const Monitor::Stage stage = monitor.stage("relax");
  monitor.progress(0.25);
  monitor.progress(1.5);
  const std::vector<std::pair<std::string, double>> expected{{"relax", -1.0}, {"relax", 0.25}, {"relax", 1.0}};
  EXPECT_EQ(recorder.calls, expected);
}

TEST(Monitor, CancellingStopsAtTheNextCheck) {
  Monitor monitor;
  EXPECT_NO_THROW(monitor.check());
  std::thread other([&] { monitor.cancel(); });
  other.join();
  EXPECT_THROW(monitor.check(), Cancelled);
  EXPECT_THROW(monitor.progress(0.5), Cancelled);
}

TEST(Monitor, KeepsFiguresTracesAndNotes) {
  Monitor monitor;
  monitor.set("vertices", 10);
  monitor.set("vertices", 20);
  monitor.add("splits", 3);
  monitor.add("splits", 4);
  monitor.trace("energy", 2.0);
  monitor.trace("energy", 1.0);
  monitor.note("Two components were dropped.");
  EXPECT_EQ(monitor.counters(), (std::map<std::string, double>{{"splits", 7.0}, {"vertices", 20.0}}));
  EXPECT_EQ(monitor.traces().at("energy"), (std::vector<double>{2.0, 1.0}));
  EXPECT_EQ(monitor.notes(), (std::vector<std::string>{"Two components were dropped."}));
}

}  // namespace
}  // namespace isobench
