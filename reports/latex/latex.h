// The tables for a paper, with booktabs and siunitx, and a macro for each figure. Values are not rounded here: siunitx
// rounds them.
#pragma once

#include <string>

#include "isobench/reports/runs/results.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

/// Text as LaTeX source. LaTeX's special characters, and the Greek and mathematical ones of our tables, become
/// commands.
std::string latex_escaped(const std::string& text);

/// A table environment. A column of numbers is an S column with the rounding of our Markdown tables. With several seeds
/// or repeats it becomes three columns: median, smallest, largest. Published figures stand in a row under ours.
std::string latex(const Table& table);

/// "SkullParticlesTwoZeroZeroSeven" from parts like "skull" and "particles-2007": TeX's names have only letters.
std::string macro_name(const std::vector<std::string>& parts);

/// \newcommand{\isobench<Data><Method><Figure>}{<value>} for each figure of each dataset and variant with a finished
/// run. Several seeds or repeats give the median, with …Smallest and …Largest. If meshes that are no closed manifolds
/// are left out of the median (counted_runs()), …RunsLeftOut says how many.
std::string latex_macros(const Results& results);

/// tables.tex. A document that loads booktabs and siunitx reads it with \input.
std::string latex_tables(const Results& results);

}  // namespace isobench
