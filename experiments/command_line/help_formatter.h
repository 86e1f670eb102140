// The layout of `isobench --help` and `isobench VERB --help`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace isobench {

/// Aligned columns, wrapped to the width of the terminal. An option shows only its names and its option_text():
/// its description must state range and default.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();
  std::string make_description(const CLI::App* app) const override;
  std::string make_group(std::string group, bool is_positional, std::vector<const CLI::Option*> options) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const override;
  std::string make_footer(const CLI::App* app) const override;
};

}  // namespace isobench
