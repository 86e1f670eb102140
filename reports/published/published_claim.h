// A claim of a publication, as data: one [[claim]] of the file of published figures. Every claim has
//
//   words = "…"                                 the claim in a sentence
//   differs = "…"                               how our test differs from what was published; optional
//   figure = "radius_ratio_min"                 a figure of results.csv, or a list of figures, which are added up
//   published = "…"                             the file's name for this quantity, if the figure has another name
//
// and one of five forms:
//
//   order = "ps > af > mc"                      methods in order, on every data set or, with data = "average", for the
//                                               mean over the data sets
//   about = 0.03, much = 1.25                   what "~" means: the values differ by at most this share; what ">>" and
//                                               "<<" mean: the values differ by at least this factor
//
//   method = "ps", at_most = 0.008              a bound on every data set; also at_least, or both
//
//   method = "ps", smaller = "epsilon", gives = "smaller" or "larger"
//                                               a trend: where runs differ in epsilon (or delta) alone, a smaller
//                                               epsilon gives a smaller (or larger) figure
//
//   across_methods = { larger = "angle_max", gives = "larger", tau = 0.5 }
//                                               over all methods on a data set, a larger angle_max goes with a larger
//                                               (or "smaller") figure: Kendall's rank correlation τ of the two is at
//                                               least 0.5 (at most −0.5). With gives = "neither" it is between −0.5
//                                               and 0.5. A method is left out if it has not both figures, or if
//                                               its number of vertices could not be matched
//
//   convergence = { at_least = 1.8, at_most = 2.5 }
//                                               the order at which the figure falls with h, over three sizings or more
//                                               of a method on a data set; one of the bounds, or both. Of every
//                                               method, or with method = "ps" of that one
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/toml.h"

namespace isobench {

struct Published;

enum class Relation { about, below, above, far_below, far_above };

enum class Tendency { larger, smaller, neither };

struct AcrossMethods {
  std::string larger;  ///< a figure
  Tendency gives = Tendency::larger;
  double tau = 0.5;  ///< 0 < tau ≤ 1
};

struct Convergence {
  std::optional<double> at_least;
  std::optional<double> at_most;
};

struct PublishedClaim {
  std::string words;
  std::string differs;
  std::vector<std::string> figures;  ///< added up
  std::string quantity;              ///< the published file's name for it; "" if the file gives no values

  // An order.
  std::vector<std::string> order;   ///< methods as printed; empty in a claim of another form
  std::vector<Relation> relations;  ///< between each method and the next
  double about = 0.0;               ///< meaning of "~"; 0 if it is not used
  double much = 0.0;                ///< meaning of ">>" and "<<"; 0 if they are not used
  bool average = false;             ///< tested for the mean over the data sets

  // A bound, a trend or an order of convergence.
  std::string method;  ///< as printed; "" for all methods
  std::optional<double> at_most;
  std::optional<double> at_least;

  std::string smaller;  ///< "epsilon" or "delta"
  bool gives_larger = false;

  std::optional<AcrossMethods> across_methods;
  std::optional<Convergence> convergence;
};

/// "~", "<", ">", "<<", ">>".
std::string to_string(Relation relation);

/// Throws UsageError with the place for an unknown figure, method or key, and unless the claim has exactly one form.
PublishedClaim claim_from(const TomlValue& table, const Published& published);

}  // namespace isobench
