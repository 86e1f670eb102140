// Claims of the form "a smaller epsilon gives more triangles". For the evaluation of claims alone.
#pragma once

#include <vector>

#include "isobench/reports/claims/claims.h"

namespace isobench {

/// One finding for each series of runs that differ in `claim.smaller` alone (and in seed and repeat). Of two values of
/// the parameter the medians over the seeds are compared.
///
/// Which runs are looked at: those of the published method, with its own name as label, and those that are aside
/// (RunRequest::aside), since a sweep often stands beside the tables that compare. Variants under another label are
/// looked at only where these give no series; a method that the published one is shown beside, only where the method
/// itself gives none.
///
/// Without any series: a single finding that says why the claim cannot be tested.
std::vector<Finding> trend_findings(const PublishedClaim& claim, const Results& results);

}  // namespace isobench
