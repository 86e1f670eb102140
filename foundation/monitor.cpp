#include "isobench/foundation/monitor.h"

#include <sys/resource.h>

#include <algorithm>
#include <ctime>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double process_cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  rusage programs{};
  getrusage(RUSAGE_CHILDREN, &programs);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec) + seconds_of(programs.ru_utime) +
         seconds_of(programs.ru_stime);
}

}  // namespace

Monitor::Stage::Stage(Monitor& monitor, const std::string& name)
    : monitor_(monitor),
      name_(monitor.current_.empty() ? name : monitor.current_ + "/" + name),
      outer_(monitor.current_),
      wall_start_(std::chrono::steady_clock::now()),
      cpu_start_(process_cpu_seconds()) {
  monitor_.current_ = name_;
  if (monitor_.sink_ != nullptr) monitor_.sink_->show(name_, -1.0);
}

Monitor::Stage::~Stage() {
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start_;
  monitor_.book(name_, wall.count(), process_cpu_seconds() - cpu_start_);
  monitor_.current_ = outer_;
}

void Monitor::progress(double fraction) {
  check();
  if (sink_ != nullptr) sink_->show(current_, std::clamp(fraction, 0.0, 1.0));
}

void Monitor::check() const {
  if (is_cancelled()) throw Cancelled();
}

double Monitor::seconds(const std::string& name) const {
  const auto found = std::find_if(booked_.stages.begin(), booked_.stages.end(),
                                  [&](const StageTime& stage) { return stage.name == name; });
  return found == booked_.stages.end() ? 0.0 : found->wall_seconds;
}

void Monitor::book(const std::string& name, double wall, double cpu) {
  auto found = std::find_if(booked_.stages.begin(), booked_.stages.end(),
                            [&](const StageTime& stage) { return stage.name == name; });
  if (found == booked_.stages.end()) found = booked_.stages.insert(booked_.stages.end(), StageTime{name, 0.0, 0.0});
  found->wall_seconds += wall;
  found->cpu_seconds += cpu;
}

}  // namespace isobench
