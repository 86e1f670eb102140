#include "isobench/reports/latex/latex.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

#include "isobench/foundation/processes/run_command.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_text.h"
#include "isobench/reports/record/sample_records.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {
namespace {

Results results_for_latex() {
  Results results;
  results.title = "A test of 100 % & more_";
  results.records = {sample_record("pelvis", "particles"), sample_record("pelvis", "marching-cubes"),
                     sample_record("skull", "particles"), sample_record("skull", "marching-cubes")};
  results.records[2].measurement->set("nonmanifold_vertices", 2);
  results.records[3].status = Status::timeout;
  results.records[3].reason = "not finished after 20 minutes, at 50 %";
  results.records[3].measurement.reset();
  results.published = read_published(ISOBENCH_SOURCE "/experiments/published/meyer-2007.toml");
  return results;
}

Results with_seeds() {
  Results results = results_for_latex();
  results.records.push_back(results.records[0]);
  results.records.back().request.seed = 2;
  results.records.back().measurement->set("radius_ratio_min", 0.25);
  return results;
}

Results with_grid() {
  Results results;
  results.title = "grid";
  for (const double epsilon : {1.0, 0.5}) {
    for (const double delta : {0.5, 0.25}) {
      results.records.push_back(sample_record("box", "particles"));
      results.records.back().request.sizing.epsilon = epsilon;
      results.records.back().request.sizing.delta = delta;
      results.records.back().measurement->set("triangles", static_cast<std::size_t>(1000.0 / epsilon / delta));
    }
  }
  return results;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

// Columns that \begin{tabular}{...} declares: letters outside brackets and braces.
int declared_columns(const std::string& line) {
  int columns = 0;
  int depth = 0;
  for (const char c : line.substr(std::string("\\begin{tabular}{").size())) {
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth == 0 && (c == 'l' || c == 'r' || c == 'S')) ++columns;
  }
  return columns;
}

// Columns that a row fills: one more than the number of "&"; a \multicolumn counts as all columns that it spans.
int filled_columns(const std::string& row) {
  int columns = 1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == '&' && (i == 0 || row[i - 1] != '\\')) ++columns;
  }
  const std::string multi = "\\multicolumn{";
  for (std::size_t at = row.find(multi); at != std::string::npos; at = row.find(multi, at + 1)) {
    columns += std::stoi(row.c_str() + at + multi.size()) - 1;
  }
  return columns;
}

void expect_sound(const std::string& text) {
  for (const char* name : {"table", "tabular", "flushleft"}) {
    EXPECT_EQ(count(text, std::string("\\begin{") + name + "}"), count(text, std::string("\\end{") + name + "}"));
  }
  int columns = 0;
  for (const std::string& line : lines(text)) {
    if (line.starts_with("\\begin{tabular}")) columns = declared_columns(line);
    if (line.ends_with(" \\\\")) {
      EXPECT_EQ(filled_columns(line), columns) << line;
    }
  }
  EXPECT_GT(columns, 0);
}

std::string line_with(const std::string& text, const std::string& start) {
  for (const std::string& line : lines(text)) {
    if (line.starts_with(start)) return line;
  }
  ADD_FAILURE() << "no line " << start << " in\n" << text;
  return "";
}

TEST(Latex, EveryRowHasTheColumnsDeclared) {
  for (const Results& results : {results_for_latex(), with_seeds(), with_grid()}) expect_sound(latex_tables(results));
}

TEST(Latex, ValuesAreUnroundedAndRoundedByTheirColumn) {
  const Results results = results_for_latex();
  const std::string text = latex(radius_ratio_table(results, arrange_runs(results)));
  EXPECT_NE(text.find("S[round-mode=figures,round-precision=3]S[round-mode=places,round-precision=3]"),
            std::string::npos);
  EXPECT_EQ(line_with(text, "particles"),
            "particles & 0.30000000000000004 & 0.9449 & 0.30000000000000004 & 0.9449 &  $^\\dagger$ \\\\");
  // Published figures are neither rounded nor filled up to our number of digits.
  EXPECT_EQ(line_with(text, "\\quad published"), "\\quad published & {0.40} & {0.92} & {0.092} & {0.94} &  \\\\");
  EXPECT_NE(line_with(text, "marching-cubes").find("\\multicolumn{3}{l}{timeout}"), std::string::npos);
  EXPECT_NE(text.find("\\par marching-cubes, skull, timeout: not finished after 20 minutes, at 50 \\%"),
            std::string::npos)
      << text;
  const std::string sizes = latex(sizes_table(results, arrange_runs(results)));
  EXPECT_NE(sizes.find("& {Time / s} &"), std::string::npos);
  EXPECT_NE(sizes.find("\\caption{the data sets and their meshes}"), std::string::npos);
  EXPECT_NE(sizes.find("S[table-format=6.0]S[table-format=6.0]@{}l}"), std::string::npos) << sizes;
  EXPECT_NE(sizes.find("& {1 min} & 4992 & 9984"), std::string::npos) << sizes;
}

TEST(Latex, WholeNumbersTakeNoRoomForDecimals) {
  const std::string topology = latex(topology_table(arrange_runs(results_for_latex())));
  // χ is −14, its reference −12.
  EXPECT_NE(topology.find("S[table-format=1.0]S[table-format=-2.0]S[table-format=-2.0]"), std::string::npos)
      << topology;
}

TEST(Latex, SeveralSeedsAreThreeColumns) {
  const Results results = with_seeds();
  const std::string text = latex(seed_table(arrange_runs(results)));
  EXPECT_NE(text.find("{median} & {smallest} & {largest}"), std::string::npos) << text;
  EXPECT_NE(text.find("0.275 & 0.25 & 0.30000000000000004"), std::string::npos) << text;
}

TEST(Latex, AColumnOfDifferentFiguresRoundsEachByItself) {
  const std::string text = latex_tables(with_grid());
  EXPECT_NE(text.find("\\num[round-mode=places,round-precision=3]{0.9449}"), std::string::npos);
  EXPECT_NE(text.find("\\num{8000}"), std::string::npos);
}

TEST(Latex, TextIsEscaped) {
  EXPECT_EQ(latex_escaped("50 % of a_b & {c} $d #e ^f ~g \\h"),
            "50 \\% of a\\_b \\& \\{c\\} \\$d \\#e \\textasciicircum{}f \\textasciitilde{}g \\textbackslash{}h");
  EXPECT_EQ(latex_escaped("ε ≤ 2 × |κ|…"), "$\\varepsilon$ $\\le$ 2 $\\times$ \\textbar{}$\\kappa$\\textbar{}\\dots{}");
  EXPECT_EQ(latex_escaped("§ 3 µs"), "\\S{} 3 $\\mu$s");
  EXPECT_EQ(latex_escaped("Müller"), "Müller");
  EXPECT_EQ(latex_escaped("Δu, D⁻½, τ"), "$\\Delta$u, D$^-$$\\frac{1}{2}$, $\\tau$");
  // All text of the tables becomes ASCII.
  for (const Results& results : {results_for_latex(), with_seeds(), with_grid()}) {
    for (const Table& table : all_tables(results)) {
      for (const char c : latex(table)) EXPECT_LT(static_cast<unsigned char>(c), 0x80U) << table.title;
    }
  }
}

TEST(Latex, AFigureHasAMacro) {
  EXPECT_EQ(macro_name({"skull-small", "particles-2007, ε 0.5"}),
            "SkullSmallParticlesTwoZeroZeroSevenEpsilonZeroPointFive");
  Results results = with_seeds();
  results.records[1].measurement->set("edge_over_h0_max", std::numeric_limits<double>::quiet_NaN());
  const std::string macros = latex_macros(results);
  for (const char* line : {"\\newcommand{\\isobenchSkullParticlesRadiusRatioMin}{0.30000000000000004}\n",
                           "\\newcommand{\\isobenchPelvisParticlesRadiusRatioMinSmallest}{0.25}\n",
                           "\\newcommand{\\isobenchPelvisMarchingCubesEdgeOverHZeroMax}{{--}}\n",
                           "\\newcommand{\\isobenchSkullParticlesSecondsTotal}{5.25}\n"}) {
    EXPECT_NE(macros.find(line), std::string::npos) << line;
  }
  EXPECT_EQ(macros.find("SkullMarchingCubes"), std::string::npos);  // it has no figures
  // Names consist of letters only, and no name occurs twice.
  results.records.push_back(sample_record("skull", "particles", "par ticles"));
  results.records.push_back(sample_record("skull", "particles", "par-ticles"));
  std::set<std::string> names;
  for (const std::string& line : lines(latex_macros(results))) {
    const std::size_t start = std::string("\\newcommand{\\").size();
    const std::string name = line.substr(start, line.find('}') - start);
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"), std::string::npos)
        << name;
    EXPECT_TRUE(names.insert(name).second) << name;
  }
}

TEST(Latex, CompilesWhereThereIsALatex) {
  if (!has_program("pdflatex") || !run_command({"kpsewhich", "siunitx.sty", "booktabs.sty"}).exit.succeeded()) {
    GTEST_SKIP() << "no pdflatex with siunitx and booktabs here (Debian: texlive-latex-base, texlive-science)";
  }
  const TestFolder test_folder;
  const std::filesystem::path& folder = test_folder.path();
  const std::string head = "\\documentclass{article}\\usepackage{booktabs}\\usepackage{siunitx}\n\\begin{document}\n";
  const auto compiles = [&folder](const std::string& document) {
    write_text(folder / "document.tex", document);
    return run_tool({"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "document.tex"}, folder);
  };
  for (const Results& results : {results_for_latex(), with_seeds(), with_grid()}) {
    write_text(folder / "tables.tex", latex_tables(results));
    EXPECT_TRUE(compiles(head + "\\input{tables}\\end{document}\n")) << read_text(folder / "log.txt");
  }
  EXPECT_TRUE(
      compiles(head + "\\input{tables}\\num[round-mode=figures,round-precision=3]{\\isobenchBoxParticlesEpsilonOneDelta"
                      "ZeroPointFiveRadiusRatioMin}\\end{document}\n"))
      << read_text(folder / "log.txt");
  EXPECT_FALSE(compiles(head + "\\begin{tabular}{l} a & b \\\\ \\end{tabular}\\end{document}\n"));
}

}  // namespace
}  // namespace isobench
