// What a publication claims, as data: a [[claim]] of the file of published figures. It has one of three forms:
//
//   words = "…", differs = "how what we test differs from what was published"
//   figure = "radius_ratio_min"                 or a list: their sum; published = "…" is what the file calls it
//
//   order = "ps > af > mc"                      on every data set, or with data = "average" on the mean over them;
//   about = 0.03, much = 1.25                   "~" within so much, relative; ">>" and "<<" by at least this factor
//
//   method = "ps", at_most = 0.008              or at_least; on every data set
//
//   method = "ps", smaller = "epsilon", gives = "smaller" or "larger"
//                                               from run to run that differ in epsilon (or delta) alone
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/toml.h"

namespace isobench {

struct Published;

enum class Relation { about, below, above, far_below, far_above };

struct PublishedClaim {
  std::string words;
  std::string differs;
  std::vector<std::string> figures;  ///< summed
  std::string quantity;              ///< as the published file calls it; "" where it gives none

  std::vector<std::string> order;   ///< methods as printed, empty where the claim is of another form
  std::vector<Relation> relations;  ///< between each of them and the next
  double about = 0.0;
  double much = 0.0;
  bool average = false;

  std::string method;  ///< as printed, for the other two forms
  std::optional<double> at_most;
  std::optional<double> at_least;

  std::string smaller;  ///< "epsilon" or "delta"
  bool gives_larger = false;
};

/// Throws UsageError with the place for an unknown figure, method or key, a form that is not whole, or two at once.
PublishedClaim claim_from(const TomlValue& table, const Published& published);

}  // namespace isobench
