// Published figures, read from a TOML file, to be shown beside ours:
//
//   source = "who, what, where"; short = "who year"; note = "what to keep in mind when comparing"
//   [[method]]    printed = "ps", name = "particles-2007", beside = ["particles"]
//   [[quantity]]  name = "radius_ratio_min", unit = "", meaning = "…"
//   [[figures]]   table = "Table 2", method = "ps", dataset = "brain", radius_ratio_min = "0.18", …
//   [[claim]]     see reports/published/published_claim.h
//   [[plate]]     number = 6, shows = "mesh", dataset = "pelvis", caption = "…"
//
// Figures are strings exactly as printed: "0.40" is not "0.4", and "< 0.004" is a bound.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/error.h"
#include "isobench/reports/published/published_claim.h"

namespace isobench {

struct PublishedMethod {
  std::string printed;              ///< as the publication calls it
  std::string name;                 ///< ours
  std::vector<std::string> beside;  ///< further methods of ours that it is shown beside
};

struct PublishedQuantity {
  std::string name;
  std::string unit;
  std::string meaning;
};

struct PublishedFigure {
  std::string table;
  std::string method;   ///< ours: PublishedMethod::name; empty where the figure is of the dataset
  std::string dataset;  ///< "average" for a mean over the datasets
  std::string quantity;
  std::string printed;          ///< e.g. "0.40", "< 0.004"
  std::optional<double> value;  ///< empty where it is no number, e.g. a size
  int decimals = 0;             ///< digits printed after the point
  bool bound = false;           ///< printed with "<"
};

/// A figure, and what of ours is shown under its number.
struct PublishedPlate {
  int number = 0;
  std::string shows;    ///< one of plate_kinds()
  std::string dataset;  ///< whose, where it is of one
  std::string caption;  ///< in our words
};
/// "pipeline", "sizing grid", "contraction", "edges over h0", "radius ratios", "mesh", "particles", "close-ups".
const std::vector<std::string>& plate_kinds();

struct Published {
  std::string source;
  std::string short_source;
  std::string note;
  std::vector<PublishedMethod> methods;
  std::vector<PublishedQuantity> quantities;
  std::vector<PublishedFigure> figures;
  std::vector<PublishedClaim> claims;
  std::vector<PublishedPlate> plates;

  /// The figure to show beside a method of ours; nullptr where none was published.
  const PublishedFigure* find(const std::string& quantity, const std::string& dataset, const std::string& method) const;
  /// The published method shown beside one of ours; nullptr if none.
  const PublishedMethod* method_beside(const std::string& method) const;
};

/// Throws UsageError with the place for a key, method or quantity that is not declared.
Published read_published(const std::filesystem::path& path);

}  // namespace isobench
