// The sides of a claim: what each method has to say on one data set. For the evaluation of claims alone.
#pragma once

#include <limits>
#include <string>

#include "isobench/reports/claims/claims.h"
#include "isobench/reports/runs/run_grid.h"

namespace isobench {

/// The figures of all seeds and repeats of one method on one data set, as a range.
struct ClaimedValue {
  std::string name;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double median = std::numeric_limits<double>::quiet_NaN();
  bool open = false;   ///< one of the meshes is not closed and manifold
  std::string absent;  ///< why there is no figure; "" where there is one
};

/// `printed` must be one of the published methods.
const PublishedMethod& printed_method(const Published& published, const std::string& printed);

/// The runs that stand for a published method: those of the method itself or, where there are none, of one that it is
/// shown beside. An entry with a label of its own is a variant, and speaks only where there is no plain one.
Runs runs_for(const Results& results, const PublishedMethod& method);

ClaimedValue claimed_value(const PublishedClaim& claim, const PublishedMethod& method, const Runs& runs);

/// "0.31", "0.28–0.33 †".
std::string text_of(const ClaimedValue& side);
/// "0.31", "0.31 (0.28–0.33) †".
std::string median_text(const ClaimedValue& side);

/// Of "a ~ b >> c" follows "a >> c": where a method in between is absent, the strongest relation on the way is asked.
Relation stronger(Relation a, Relation b);

/// Whether each figure of the left side stands in this relation to each of the right.
bool holds(const PublishedClaim& claim, const ClaimedValue& left, Relation relation, const ClaimedValue& right);

/// Appends words to a list in words.
void add_words(std::string& text, const std::string& separator, const std::string& words);

}  // namespace isobench
