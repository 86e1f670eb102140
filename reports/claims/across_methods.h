// Claims of the form "over the methods on a data set, a larger angle_max goes with a larger gradient_max". Used only to
// evaluate claims.
#pragma once

#include <vector>

#include "isobench/reports/claims/claims.h"

namespace isobench {

/// One finding for each data set and sizing: Kendall's τ of the medians of the two figures over all methods there (one
/// for each label). A method without one of the figures, or whose number of vertices could not be matched, is left out,
/// and the remark says so. With fewer than four
/// methods nothing is testable: even three put in order have it by chance in one case of six. Runs that are aside
/// (RunRequest::aside) do not count.
std::vector<Finding> across_methods_findings(const PublishedClaim& claim, const Results& results);

}  // namespace isobench
