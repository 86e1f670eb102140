// The reports of a results folder, made from what is stored.
#pragma once

#include <filesystem>
#include <string>

namespace isobench {

/// Writes tables.md, tables.tex, results.csv and results.columns.md, which says what its columns are, into the folder
/// and gives the text of tables.md. Throws DataError where `folder` is no results folder.
std::string write_report(const std::filesystem::path& folder);

}  // namespace isobench
