// Through a Monitor a long computation reports stages and their times, progress, counters and traces. Libraries never
// print: their caller gives them a Monitor, and may give the Monitor a ProgressSink.
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

/// Receives progress while a computation runs; implemented by code that shows it to the user.
class ProgressSink {
 public:
  virtual ~ProgressSink() = default;
  /// `fraction` is in [0, 1], or negative if the stage does not know how far it is.
  virtual void show(const std::string& stage, double fraction) = 0;
};

struct StageTime {
  std::string name;           ///< nested stages read "outer/inner"
  double wall_seconds = 0.0;  ///< summed over all visits
  double cpu_seconds = 0.0;   ///< of all threads of this process and of the programs whose end it waited for
};

/// An intermediate result for people to look at, which a run keeps if it is asked to: points with data.
struct Artefact {
  std::vector<Eigen::Vector3d> points;              ///< lattice frame, mm
  std::map<std::string, std::vector<double>> data;  ///< one value per point
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

  /// Reports how far the current stage is (0 to 1). Throws Cancelled if cancel() was called.
  void progress(double fraction);
  /// Throws Cancelled if cancel() was called; cheap.
  void check() const;
  /// The same question for code that must not throw.
  bool is_cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  /// May be called from a signal handler or another thread.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

  /// A counter of the run's record, such as "particles/splits": set() replaces it, add() adds to it.
  void set(const std::string& name, double value) { booked_.counters[name] = value; }
  void add(const std::string& name, double value) { booked_.counters[name] += value; }
  /// Appends a value to a curve of the run's record, such as the "energy" after each sweep.
  void trace(const std::string& name, double value) { booked_.traces[name].push_back(value); }
  /// A sentence for the run's log and record.
  void note(const std::string& sentence) { booked_.notes.push_back(sentence); }

  /// Artefacts are kept only while keep_artefacts(true) holds; a later one replaces an earlier one of the same name.
  /// Ask keeps_artefacts() before making one that takes time.
  void keep_artefacts(bool keep) { keeps_artefacts_ = keep; }
  bool keeps_artefacts() const { return keeps_artefacts_; }
  void artefact(const std::string& name, Artefact artefact) {
    if (keeps_artefacts_) booked_.artefacts[name] = std::move(artefact);
  }

  /// The folder in which the run keeps files, such as the log of a program that it calls; empty: it keeps none. Names
  /// of scratch folders in it begin with a dot.
  void keep_files_in(const std::filesystem::path& folder) { files_ = folder; }
  const std::filesystem::path& files() const { return files_; }

  /// Books the peak memory of a program that the computation called, MB (10⁶ bytes). The largest of several counts.
  void book_program_memory(double peak_mb) { booked_.program_memory_mb = std::max(booked_.program_memory_mb, peak_mb); }
  double program_memory_mb() const { return booked_.program_memory_mb; }

  /// Everything that was reported so far and belongs in the record.
  struct Bookings {
    std::vector<StageTime> stages;
    std::map<std::string, double> counters;
    std::map<std::string, std::vector<double>> traces;
    std::vector<std::string> notes;
    std::map<std::string, Artefact> artefacts;
    double program_memory_mb = 0.0;
  };
  const Bookings& bookings() const { return booked_; }
  /// Returns to earlier bookings, as if nothing had been reported since. For an attempt whose result is not kept. Call
  /// it outside all stages.
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
