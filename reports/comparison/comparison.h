// Two results folders side by side, figure by figure.
#pragma once

#include <string>
#include <vector>

#include "isobench/reports/runs/results.h"

namespace isobench {

/// One value that is not the same on both sides; "–" where a side does not have it.
struct Difference {
  std::string run;
  std::string figure;  ///< as in results.csv, or "histogram angle", "trace energy", "counter particles/splits", …
  std::string a;
  std::string b;
  double relative = 0.0;  ///< |a − b| / max(|a|, |b|); for a series the largest of it; NaN where it says nothing
};

/// A run that one side alone has.
struct Unmatched {
  std::string run;
  std::string why;  ///< "not planned", "not done", "differs in method_revision: 3 and 4"
};

/// What one run cost on each side.
struct CostPair {
  std::string run;
  double seconds_a = 0.0;  ///< sizing + method, wall
  double seconds_b = 0.0;
  double memory_mb_a = 0.0;
  double memory_mb_b = 0.0;
};

/// A circumstance that differs in some runs: code, machine, limits, names and notes. None of them is a figure.
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
  std::vector<std::string> not_deterministic;  ///< runs that differ by a method that does not promise the same mesh

  /// Nothing differs but seconds, memory and circumstances.
  bool same() const { return differences.empty() && only_a.empty() && only_b.empty() && unreadable.empty(); }
};

/// Compares the runs that have the same name, which covers all that determines a result. Numbers may differ by
/// `tolerance`, relative to the larger one; 0 asks for the same bits. What is not a number never equals a number.
Comparison compare(const Results& a, const Results& b, double tolerance = 0.0);

enum class Detail { brief, full };

/// For a person, as Markdown. Where nothing differs it is one sentence, unless Detail::full asks for the tables of
/// costs and circumstances as well.
std::string comparison_text(const Comparison& comparison, Detail detail = Detail::brief);

}  // namespace isobench
