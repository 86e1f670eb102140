#include "isobench/experiments/command_line/help_formatter.h"

#include <algorithm>

#include "isobench/experiments/terminal/terminal.h"

namespace isobench {

namespace {

// Help, unlike lists, is not searched by `grep`, so its lines stay short in a file, too.
std::size_t help_width() { return std::min<std::size_t>(output_width(), 100); }

}  // namespace

HelpFormatter::HelpFormatter() {
  label("Positionals", "Arguments");
  label("OPTIONS", "options");
  label("SUBCOMMAND", "verb");
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return wrapped(app->get_description(), 0, help_width()) + "\n\n";
}

std::string HelpFormatter::make_group(std::string group, bool is_positional,
                                      std::vector<const CLI::Option*> options) const {
  std::vector<std::vector<std::string>> rows;
  for (const CLI::Option* option : options) {
    rows.push_back(
        {"  " + make_option_name(option, is_positional) + make_option_opts(option), option->get_description()});
  }
  return "\n" + group + ":\n" + aligned_rows(rows, help_width());
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  return option->get_option_text().empty() ? "" : " " + option->get_option_text();
}

std::string HelpFormatter::make_subcommands(const CLI::App* app, CLI::AppFormatMode) const {
  std::vector<std::vector<std::string>> rows;
  for (const CLI::App* verb : app->get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); })) {
    rows.push_back({"  " + verb->get_name(), verb->get_description()});
  }
  return rows.empty() ? "" : "\nVerbs:\n" + aligned_rows(rows, help_width());
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
  const std::string footer = app->get_footer();
  return footer.empty() ? "" : wrapped(footer, 0, help_width()) + "\n";
}

}  // namespace isobench
