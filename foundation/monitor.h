// What a long computation tells the outside while it runs: stages with their clocks, progress, counters and traces.
// Libraries never print; whoever runs them gives them a Monitor, and may give the Monitor a ProgressSink.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace isobench {

/// Receives progress as it happens; implemented where output goes to a person.
class ProgressSink {
 public:
  virtual ~ProgressSink() = default;
  /// `fraction` is in [0, 1], or negative where the stage cannot tell how far it is.
  virtual void show(const std::string& stage, double fraction) = 0;
};

struct StageTime {
  std::string name;           ///< nested stages read "outer/inner"
  double wall_seconds = 0.0;  ///< summed over all visits
  double cpu_seconds = 0.0;   ///< of the whole process, all threads, and of programs that it ran to their end
};

/// Points with data, for someone to look at: an intermediate result that a run leaves behind where it is asked to.
struct Artefact {
  std::vector<Eigen::Vector3d> points;              ///< lattice frame, mm
  std::map<std::string, std::vector<double>> data;  ///< one value a point
};

class Monitor {
 public:
  Monitor() = default;
  explicit Monitor(ProgressSink* sink) : sink_(sink) {}
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  /// Ends its stage when it goes out of scope. Stages nest; open and close them on one thread.
  class Stage {
   public:
    Stage(Monitor& monitor, const std::string& name);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

   private:
    Monitor& monitor_;
    std::string name_;
    std::string outer_;
    std::chrono::steady_clock::time_point wall_start_;
    double cpu_start_;
  };

  [[nodiscard]] Stage stage(const std::string& name) { return {*this, name}; }

  /// Says how far the current stage is (0..1) and throws Cancelled if cancel() was called.
  void progress(double fraction);
  /// Throws Cancelled if cancel() was called; cheap.
  void check() const;
  /// For what must not be left by an exception.
  bool is_cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  /// May be called from a signal handler or another thread.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

  /// A figure for the run's record, e.g. "particles/splits"; add() sums, set() replaces.
  void set(const std::string& name, double value) { booked_.counters[name] = value; }
  void add(const std::string& name, double value) { booked_.counters[name] += value; }
  /// One more point of a curve for the run's record, e.g. "energy" once a sweep.
  void trace(const std::string& name, double value) { booked_.traces[name].push_back(value); }
  /// A sentence for the run's log and record.
  void note(const std::string& sentence) { booked_.notes.push_back(sentence); }

  /// Artefacts are kept while keep_artefacts() asks for them; a later one of the same name takes the place of the
  /// earlier. Where making one costs anything, ask keeps_artefacts() first.
  void keep_artefacts(bool keep) { keeps_artefacts_ = keep; }
  bool keeps_artefacts() const { return keeps_artefacts_; }
  void artefact(const std::string& name, Artefact artefact) {
    if (keeps_artefacts_) booked_.artefacts[name] = std::move(artefact);
  }

  /// The folder that the run leaves behind, where there is one: a place for files of a computation, such as the log of
  /// a program that it runs. Scratch folders in it begin with a dot. Empty: there is none.
  void keep_files_in(const std::filesystem::path& folder) { files_ = folder; }
  const std::filesystem::path& files() const { return files_; }

  /// The memory that a program that was run for this computation took at its peak, MB (10⁶ bytes); of several the most.
  void book_program_memory(double peak_mb) { booked_.program_memory_mb = std::max(booked_.program_memory_mb, peak_mb); }
  double program_memory_mb() const { return booked_.program_memory_mb; }

  /// All that has been booked so far, for the record.
  struct Bookings {
    std::vector<StageTime> stages;
    std::map<std::string, double> counters;
    std::map<std::string, std::vector<double>> traces;
    std::vector<std::string> notes;
    std::map<std::string, Artefact> artefacts;
    double program_memory_mb = 0.0;
  };
  const Bookings& bookings() const { return booked_; }
  /// Puts earlier bookings in the place of the present ones, as if what happened since had not: for an attempt that is
  /// not kept. Call outside all stages.
  void restore(Bookings bookings) { booked_ = std::move(bookings); }

  const std::vector<StageTime>& stages() const { return booked_.stages; }
  const std::map<std::string, double>& counters() const { return booked_.counters; }
  const std::map<std::string, std::vector<double>>& traces() const { return booked_.traces; }
  const std::vector<std::string>& notes() const { return booked_.notes; }
  const std::map<std::string, Artefact>& artefacts() const { return booked_.artefacts; }
  /// Wall seconds of one stage by its full name; 0 if it never ran.
  double seconds(const std::string& name) const;

 private:
  void book(const std::string& name, double wall, double cpu);

  ProgressSink* sink_ = nullptr;
  std::atomic<bool> cancelled_{false};
  std::string current_;
  bool keeps_artefacts_ = false;
  std::filesystem::path files_;
  Bookings booked_;
};

}  // namespace isobench
