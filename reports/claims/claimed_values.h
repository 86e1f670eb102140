// The figure that a claim is about, for one method: measured values and how two of them compare. Used only to evaluate
// claims.
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
  std::string absent;  ///< why there is no value; "" if there is one
};

/// Methods are compared on one data set at one sizing.
struct ClaimCell {
  std::string dataset;
  std::string sizing;  ///< sizing_name()
  bool operator==(const ClaimCell&) const = default;
};
ClaimCell claim_cell_of(const RunRecord& record);
/// Those of all runs that are not aside (RunRequest::aside), in the order of the plan.
std::vector<ClaimCell> claim_cells(const Results& results);
bool several_sizings(const std::vector<ClaimCell>& cells, const std::string& dataset);
/// The data set, and the sizing if the data set has several.
std::string name_among(const std::vector<ClaimCell>& cells, const ClaimCell& cell);

/// The published method with this printed name, which must exist.
const PublishedMethod& printed_method(const Published& published, const std::string& printed);

/// Names of our methods that can represent a published one: first PublishedMethod::name, then those in
/// PublishedMethod::beside.
std::vector<std::string> methods_for(const PublishedMethod& method);

/// The runs of the first method in methods_for() that has any. Variants with a label other than the method's name are
/// taken only if there are no runs without such a label. Runs that are aside (RunRequest::aside) do not count.
Runs runs_for(const Results& results, const PublishedMethod& method);

ClaimedValue claimed_value(const PublishedClaim& claim, const PublishedMethod& method, const Runs& runs);

/// "0.31"; for several different values "0.28–0.33"; with " †" if a mesh is open.
std::string range_text(const ClaimedValue& value);
/// "0.31"; for several different values "0.31 (0.28–0.33)"; with " †" if a mesh is open.
std::string median_and_range(const ClaimedValue& value);

/// If b has no value in "a ~ b >> c", "a >> c" is tested: the stronger one of the two relations around b.
Relation stronger(Relation a, Relation b);

/// Whether every value of the left method has this relation to every value of the right one.
bool holds(const PublishedClaim& claim, const ClaimedValue& left, Relation relation, const ClaimedValue& right);

/// Appends an item and, unless it is the first, the separator before it. An empty item changes nothing.
void append_to_list(std::string& list, const std::string& separator, const std::string& item);

}  // namespace isobench
