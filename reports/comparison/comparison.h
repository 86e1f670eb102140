// Two results folders side by side, figure by figure.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "isobench/reports/runs/results.h"

namespace isobench {

/// One value that is not the same on both sides. It is "–" on a side that does not have it.
struct Difference {
  std::string run;
  std::string figure;  ///< as in results.csv, or "histogram angle", "trace energy", "counter particles/splits", …
  std::string a;
  std::string b;
  double relative = 0.0;  ///< |a − b| / max(|a|, |b|); the largest of a series; NaN if a side has no number
};

/// A run that only one side has.
struct Unmatched {
  std::string run;
  std::string why;  ///< "not planned there", "not done there", "… is there instead; they differ in …"
};

/// What one run cost on each side.
struct CostPair {
  std::string run;
  double seconds_a = 0.0;  ///< sizing + method, wall
  double seconds_b = 0.0;
  double memory_mb_a = 0.0;
  double memory_mb_b = 0.0;
};

/// A circumstance that differs in some runs: code, machine, limits, names or notes. It is not a figure.
struct CircumstanceChange {
  std::string what;  ///< "commit", "cpu", "threads", …
  std::string a;
  std::string b;
  std::size_t runs = 0;
};

struct Comparison {
  std::string name_a;
  std::string name_b;
  std::size_t matched = 0;  ///< runs that both sides have
  std::size_t undone = 0;   ///< planned by both, done by neither
  std::vector<Difference> differences;
  std::vector<Unmatched> only_a;
  std::vector<Unmatched> only_b;
  std::vector<std::string> unreadable;
  std::vector<CostPair> costs;
  std::vector<CircumstanceChange> circumstances;
  std::vector<std::string> not_deterministic;  ///< runs that differ, by methods that do not promise the same mesh
  /// Figures that the records of one side lack because they are older, and the other side has. They are not compared.
  std::set<std::string> unknown_in_a;
  std::set<std::string> unknown_in_b;

  /// Only seconds, memory and circumstances differ.
  bool same() const { return differences.empty() && only_a.empty() && only_b.empty() && unreadable.empty(); }
};

/// Compares the runs that have the same name; the name depends on everything that determines a result. Numbers may
/// differ by `tolerance`, relative to the larger one, unless the figure is declared to be compared exactly; 0 asks for
/// the same bits. A figure that was measured on one side only is a difference; one that is unknown on a side is not.
Comparison compare(const Results& a, const Results& b, double tolerance = 0.0);

enum class Detail { brief, full };

/// The comparison as Markdown. If nothing differs, it is one or two sentences; Detail::full adds the tables of costs
/// and circumstances.
std::string comparison_text(const Comparison& comparison, Detail detail = Detail::brief);

}  // namespace isobench
