// Figures of a publication, read from a TOML file and shown beside ours:
//
//   source = "authors, title, journal"; short = "authors year"; note = "what to consider when comparing"
//   [[method]]    printed = "ps", name = "particles-2007", beside = ["particles"]
//   [[quantity]]  name = "radius_ratio_min", unit = "", meaning = "…"
//   [[figures]]   table = "Table 2", method = "ps", dataset = "brain", radius_ratio_min = "0.18", …
//   [[claim]]     see reports/published/published_claim.h
//   [[plate]]     number = 6, shows = "mesh", dataset = "pelvis", caption = "…"
//
// Figures are strings, exactly as printed: "0.40" has another precision than "0.4", and "< 0.004" is a bound.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/foundation/error.h"
#include "isobench/reports/published/published_claim.h"

namespace isobench {

struct PublishedMethod {
  std::string printed;              ///< name in the publication
  std::string name;                 ///< name of our implementation
  std::vector<std::string> beside;  ///< other methods of ours; its figures are shown beside theirs, too
};

struct PublishedQuantity {
  std::string name;
  std::string unit;
  std::string meaning;
};

struct PublishedFigure {
  std::string table;
  std::string method;   ///< PublishedMethod::name; "" for a figure of the data set itself
  std::string dataset;  ///< "average" for the mean over the data sets
  std::string quantity;
  std::string printed;          ///< e.g. "0.40", "< 0.004"
  std::optional<double> value;  ///< empty if it is not a number, e.g. "149 × 188 × 148"
  int decimals = 0;             ///< digits after the point, as printed
  bool bound = false;           ///< printed with "<"
};

/// A figure (picture or plot) of the publication, and what we show under its number.
struct PublishedPlate {
  int number = 0;
  std::string shows;    ///< one of plate_kinds()
  std::string dataset;  ///< "" if the figure is not about a single data set
  std::string caption;  ///< written by us
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

  /// The published figure to show beside our method; nullptr if there is none.
  const PublishedFigure* find(const std::string& quantity, const std::string& dataset, const std::string& method) const;
  /// The published method that is shown beside our method; nullptr if there is none.
  const PublishedMethod* method_beside(const std::string& method) const;
};

/// Throws UsageError with the place for an unknown key, method, quantity or figure.
Published read_published(const std::filesystem::path& path);

}  // namespace isobench
