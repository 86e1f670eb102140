// The tables for a paper: booktabs and siunitx, values unrounded, rounding left to siunitx, and a macro for each
// figure.
#pragma once

#include <string>

#include "isobench/reports/runs/results.h"
#include "isobench/reports/tables/table.h"

namespace isobench {

/// Text as LaTeX prints it: its special characters, and the Greek and mathematical ones of our tables, in LaTeX's
/// words.
std::string latex_escaped(const std::string& text);

/// A table environment. A column of numbers is an S column with the rounding of our Markdown tables; several seeds or
/// repeats make it three: median, smallest, largest. Published figures stand in a row of their own under ours.
std::string latex(const Table& table);

/// "SkullParticlesTwoZeroZeroSeven" from parts like "skull" and "particles-2007": letters only, as TeX wants its names.
std::string macro_name(const std::vector<std::string>& parts);

/// \newcommand{\isobench<Data><Method><Figure>}{<value>} for each figure of each dataset and variant with a finished
/// run. Of several seeds or repeats it is the median, and …Smallest and …Largest stand beside it; where the median
/// leaves out meshes that are no closed manifolds (counted_runs()), …RunsLeftOut says how many.
std::string latex_macros(const Results& results);

/// tables.tex: to be read with \input by a document that loads booktabs and siunitx.
std::string latex_tables(const Results& results);

}  // namespace isobench
