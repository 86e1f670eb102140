// Claims of the form "a smaller epsilon gives more triangles". Used only to evaluate claims.
#pragma once

#include <vector>

#include "isobench/reports/claims/claims.h"

namespace isobench {

/// One finding for each series of runs that differ only in `claim.smaller`, seed and repeat. It compares the medians
/// over the seeds at each value of the parameter and the next smaller one.
///
/// The runs come from the first method in methods_for() that gives a series: those with the method's name as label and
/// those that are aside (RunRequest::aside), because sweeps are often kept out of the tables. Variants with another
/// label are taken only if these give no series.
///
/// Without any series, there is a single finding that says why the claim cannot be tested.
std::vector<Finding> trend_findings(const PublishedClaim& claim, const Results& results);

}  // namespace isobench
