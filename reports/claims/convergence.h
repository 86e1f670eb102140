// Claims about orders of convergence: "the error falls as h²". Used only to evaluate claims.
#pragma once

#include <vector>

#include "isobench/reports/claims/claims.h"

namespace isobench {

/// One finding for each data set on which a method was run at several sizings: order_of_convergence() of the claim's
/// method or, if the claim names none, of all methods, each of which must keep the bounds. A method without an order is
/// left out, and the remark says why. Runs that are aside (RunRequest::aside) do not count.
std::vector<Finding> convergence_findings(const PublishedClaim& claim, const Results& results);

}  // namespace isobench
