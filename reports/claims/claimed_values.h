// The figure that a claim is about, for one method: measured values and how two of them compare. For the evaluation of
// claims alone.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "isobench/reports/claims/claims.h"
#include "isobench/reports/runs/run_grid.h"

namespace isobench {

/// One method's values of a claim's figure over all its seeds and repeats.
struct ClaimedValue {
  std::string name;  ///< of the method, as tables show it
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double median = std::numeric_limits<double>::quiet_NaN();
  bool open = false;   ///< one of the meshes is not closed and manifold
  std::string absent;  ///< why there is no value; "" where there is one
};

/// The published method with this printed name, which must exist.
const PublishedMethod& printed_method(const Published& published, const std::string& printed);

/// Names of our methods that can stand for a published one: first the method itself, then those that it is shown
/// beside.
std::vector<std::string> methods_for(const PublishedMethod& method);

/// The runs of the first of methods_for() that has any. Runs under the method's own name come first; variants with
/// another label are taken only where there are none. Runs that are aside (RunRequest::aside) do not count.
Runs runs_for(const Results& results, const PublishedMethod& method);

ClaimedValue claimed_value(const PublishedClaim& claim, const PublishedMethod& method, const Runs& runs);

/// "0.31"; of several different values "0.28–0.33"; with " †" where a mesh is open.
std::string range_text(const ClaimedValue& value);
/// "0.31"; of several different values "0.31 (0.28–0.33)"; with " †" where a mesh is open.
std::string median_and_range(const ClaimedValue& value);

/// Where b has no value in "a ~ b >> c", "a >> c" is tested. `stronger` gives the relation that remains of two.
Relation stronger(Relation a, Relation b);

/// Whether every value of the left method has this relation to every value of the right one.
bool holds(const PublishedClaim& claim, const ClaimedValue& left, Relation relation, const ClaimedValue& right);

/// Appends an item and, unless it is the first, the separator before it. An empty item changes nothing.
void append_to_list(std::string& list, const std::string& separator, const std::string& item);

}  // namespace isobench
