#include <fmt/format.h>

#include "isobench/experiments/plan/config.h"

namespace isobench {

namespace {

std::string toml(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') result += '\\';
    if (code < 0x20U || code == 0x7FU)
      result += fmt::format("\\u{:04x}", code);
    else
      result += c;
  }
  return result + "\"";
}
std::string toml(std::uint64_t value) { return fmt::format("{}", value); }
std::string toml(double value) { return fmt::format("{}", value); }
std::string toml(const ParameterValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return toml(*number);
  return toml(std::get<std::string>(value));
}

template <class Element>
std::string toml_list(const std::vector<Element>& values) {
  if (values.size() == 1) return toml(values.front());
  std::string text;
  for (const Element& value : values) text += (text.empty() ? "" : ", ") + toml(value);
  return "[" + text + "]";
}

// A thousand names stay readable: as many to a line as have room.
std::string toml_names(const std::vector<std::string>& names) {
  constexpr std::size_t width = 100;
  std::string short_text = toml_list(names);
  if (short_text.size() <= width) return short_text;
  std::string text = "[";
  std::string line;
  for (const std::string& name : names) {
    if (line.size() + name.size() > width || line.empty()) {
      text += line + "\n ";
      line.clear();
    }
    line += " " + toml(name) + ",";
  }
  return text + line + "\n]";
}

std::vector<std::string> sampling_lines(const Sampling& sampling) {
  std::vector<std::string> lines;
  const auto add = [&lines](const char* key, const std::vector<double>& values) {
    if (!values.empty()) lines.push_back(fmt::format("{} = {}", key, toml_list(values)));
  };
  add("epsilon", sampling.epsilon);
  add("delta", sampling.delta);
  add("edge_length", sampling.edge_length);
  add("vertices", sampling.vertices);
  add("floor", sampling.floor);
  return lines;
}

std::vector<std::string> limit_lines(const Limits& limits) {
  std::vector<std::string> lines;
  if (limits.minutes) lines.push_back("minutes = " + toml(*limits.minutes));
  if (limits.memory_gb) lines.push_back("memory_gb = " + toml(*limits.memory_gb));
  return lines;
}

std::string block(const std::string& header, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string text = "\n" + header + "\n";
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string inline_table(const std::string& key, const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : ", ") + line;
  return key + " = { " + text + " }";
}

std::string override_block(const Override& change) {
  std::vector<std::string> lines;
  if (!change.datasets.empty()) lines.push_back("dataset = " + toml_names(change.datasets));
  if (!change.methods.empty()) lines.push_back("method = " + toml_list(change.methods));
  const std::vector<std::string> sampling = sampling_lines(change.sampling);
  const std::vector<std::string> limits = limit_lines(change.limits);
  if (!sampling.empty()) lines.push_back(inline_table("sampling", sampling));
  if (!limits.empty()) lines.push_back(inline_table("limits", limits));
  if (change.artefacts) lines.push_back(fmt::format("artefacts = {}", *change.artefacts));
  return block("[[override]]", lines);
}

std::string vary_block(const Variation& variation) {
  const std::string key =
      variation.table + "." + (variation.method.empty() ? "" : variation.method + ".") + variation.name;
  return block("[[vary]]", {"key = " + toml(key), "values = " + toml_list(variation.values)});
}

std::string method_block(const MethodEntry& entry, const std::string& header = "[[method]]") {
  std::vector<std::string> lines = {"name = " + toml(entry.name)};
  if (entry.label != entry.name) lines.push_back("label = " + toml(entry.label));
  if (!entry.datasets.empty()) lines.push_back("dataset = " + toml_names(entry.datasets));
  for (const auto& [name, values] : entry.parameters) lines.push_back(name + " = " + toml_list(values));
  return block(header, lines);
}

std::string aside_block(const Aside& aside) {
  std::string text = block("[[also]]", {"dataset = " + toml_names(aside.datasets), "seed = " + toml_list(aside.seeds),
                                        inline_table("sampling", sampling_lines(aside.sampling))});
  for (const MethodEntry& entry : aside.methods) text += method_block(entry, "[[also.method]]");
  return text;
}

}  // namespace

std::string to_toml(const Config& config, const std::string& published) {
  std::string text = "title = " + toml(config.title) + "\n";
  text += "dataset = " + toml_names(config.datasets) + "\n";
  text += "seed = " + toml_list(config.seeds) + "\n";
  if (config.repeats > 1) text += fmt::format("repeats = {}\n", config.repeats);
  // Needed only if it is not the default, which depends on the repeats.
  if (config.timing != (config.repeats > 1)) text += fmt::format("timing = {}\n", config.timing);
  if (config.match) text += "match = \"vertices\"\nmatch_to = " + toml(config.match->to) + "\n";
  if (config.artefacts) text += "artefacts = true\n";
  if (config.metrics_of_use) text += "metrics_of_use = true\n";
  if (config.min_component > 0.0) text += fmt::format("min_component = {}\n", toml(config.min_component));
  text += block("[sampling]", sampling_lines(config.sampling));
  for (const Override& change : config.overrides) text += override_block(change);
  for (const Variation& variation : config.variations) text += vary_block(variation);
  for (const MethodEntry& entry : config.methods) text += method_block(entry);
  for (const Aside& aside : config.also) text += aside_block(aside);
  text += block("[limits]", limit_lines(config.limits));
  if (config.published) text += block("[published]", {"source = " + toml(published)});
  return text;
}

std::string identity(const Config& config) {
  Config plain = config;
  plain.title.clear();
  plain.limits = {};
  plain.artefacts = false;
  plain.metrics_of_use = false;
  plain.published.reset();
  for (Override& change : plain.overrides) {
    change.limits = {};
    change.artefacts.reset();
    // Labels make no difference, but an override may name its method by one.
    for (std::string& target : change.methods) {
      for (const MethodEntry& entry : config.methods) {
        if (entry.label == target) target = entry.name;
      }
    }
  }
  std::erase_if(plain.overrides, [](const Override& change) { return sampling_lines(change.sampling).empty(); });
  // An entry is replaced by its number: two entries of one method may differ in nothing but their labels.
  for (std::size_t i = 0; config.match && i < config.methods.size(); ++i) {
    if (config.methods[i].label == config.match->to) plain.match->to = fmt::format("#{}", i);
  }
  for (Variation& variation : plain.variations) {
    if (variation.table != "method") continue;
    std::string entries;
    for (std::size_t i = 0; i < config.methods.size(); ++i) {
      if (variation.changes(config.methods[i])) entries += fmt::format("#{}", i);
    }
    variation.method = entries;
  }
  for (MethodEntry& entry : plain.methods) entry.label = entry.name;
  for (Aside& aside : plain.also) {
    for (MethodEntry& entry : aside.methods) entry.label = entry.name;
  }
  return to_toml(plain, "");
}

}  // namespace isobench
