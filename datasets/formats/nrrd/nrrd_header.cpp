#include "isobench/datasets/formats/nrrd/nrrd_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "isobench/datasets/formats/reading/data_files.h"
#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20U;

/// The fields that the format has, without blanks, and other names of some.
constexpr std::pair<std::string_view, std::string_view> nrrd_fields[] = {
    {"dimension", ""},
    {"type", ""},
    {"blocksize", ""},
    {"encoding", ""},
    {"endian", ""},
    {"content", ""},
    {"min", ""},
    {"max", ""},
    {"oldmin", ""},
    {"oldmax", ""},
    {"datafile", ""},
    {"lineskip", ""},
    {"byteskip", ""},
    {"number", ""},
    {"sampleunits", ""},
    {"sizes", ""},
    {"spacings", ""},
    {"thicknesses", ""},
    {"axismins", ""},
    {"axismaxs", ""},
    {"centerings", "centers"},
    {"labels", ""},
    {"units", ""},
    {"kinds", ""},
    {"space", ""},
    {"spacedimension", ""},
    {"spaceunits", ""},
    {"spaceorigin", ""},
    {"spacedirections", ""},
    {"measurementframe", ""},
};

using NrrdField = std::pair<std::string_view, std::string_view>;

/// The field with this name, which may be written in either case and with blanks; nullptr if the format has none.
const NrrdField* field_named(const std::string& name) {
  std::string key = lower_case(trimmed(name));
  key.erase(std::remove(key.begin(), key.end(), ' '), key.end());
  const auto* const known = std::find_if(std::begin(nrrd_fields), std::end(nrrd_fields), [&](const NrrdField& field) {
    return key == field.first || (!key.empty() && key == field.second);
  });
  return known == std::end(nrrd_fields) ? nullptr : known;
}

/// A field that the format does not have is most likely misspelt.
void note_unknown_field(NrrdHeader& header, const std::string& name) {
  std::vector<std::string> names;
  for (const NrrdField& field : nrrd_fields) names.emplace_back(field.first);
  const std::string nearest = nearest_name(lower_case(trimmed(name)), names);
  header.note(fmt::format("its header's field '{}' is not known and was not used{}", trimmed(name).substr(0, 60),
                          nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

void add_field(NrrdHeader& header, const std::string& name, const std::string& value) {
  const NrrdField* const known = field_named(name);
  if (known == nullptr) return note_unknown_field(header, name);
  if (!header.fields.emplace(known->first, trimmed(value)).second) {
    throw DataError(fmt::format("{}: its header has the field '{}' twice; correct the header", header.path.string(),
                                trimmed(name)));
  }
}

/// The format writes a line end as \n and a backslash as \\.
std::string without_escapes(const std::string& text) {
  std::string plain;
  for (std::size_t n = 0; n < text.size(); ++n) {
    if (text[n] != '\\' || n + 1 == text.size()) {
      plain.push_back(text[n]);
      continue;
    }
    const char next = text[++n];
    if (next != 'n' && next != '\\') plain.push_back('\\');
    plain.push_back(next == 'n' ? '\n' : next);
  }
  return plain;
}

void add_line(NrrdHeader& header, const std::string& line) {
  if (line[0] == '#') return;
  const std::size_t colon = line.find(':');
  if (colon == std::string::npos || line.find('\0') != std::string::npos) {
    throw DataError(
        fmt::format("{}: '{}' in its header is neither a field nor a comment; an empty line must end the header",
                    header.path.string(), line.substr(0, 60)));
  }
  // Keys of pairs may have colons, too, so a field is known by its name.
  const std::size_t equals = line.find(":=");
  const bool is_field = equals != colon && field_named(line.substr(0, colon)) != nullptr;
  if (equals != std::string::npos && !is_field)
    header.pairs[without_escapes(line.substr(0, equals))] = without_escapes(line.substr(equals + 2));
  else
    add_field(header, line.substr(0, colon), line.substr(colon + 1));
}

bool is_list(const NrrdHeader& header) {
  const std::string files = header.text("datafile");
  return files.starts_with("LIST") && (files.size() == 4 || files[4] == ' ' || files[4] == '\t');
}

}  // namespace

std::vector<double> NrrdHeader::numbers(const std::string& key, std::size_t count) const {
  return numbers_in(text(key), count, path, key);
}

double NrrdHeader::number(const std::string& key, double otherwise) const {
  return has(key) ? numbers(key, 1).front() : otherwise;
}

std::vector<std::string> NrrdHeader::words(const std::string& key, std::size_t count) const {
  if (!has(key)) return {};
  const std::string value = text(key);
  std::vector<std::string> words;
  for (std::size_t at = value.find_first_not_of(" \t"); at < value.size(); at = value.find_first_not_of(" \t", at)) {
    std::string word;
    if (value[at] == '"') {
      for (++at; at < value.size() && value[at] != '"'; ++at) {
        if (value[at] == '\\' && at + 1 < value.size()) ++at;
        word.push_back(value[at]);
      }
      ++at;
    } else {
      while (at < value.size() && value[at] != ' ' && value[at] != '\t') word.push_back(value[at++]);
    }
    words.push_back(word);
  }
  if (words.size() != count) {
    throw DataError(fmt::format("{}: '{}' is '{}', but {} entr{} expected; correct its header", path.string(), key,
                                value.substr(0, 60), count, count == 1 ? "y is" : "ies are"));
  }
  return words;
}

NrrdHeader read_nrrd_header(ByteReader& reader) {
  NrrdHeader header;
  header.path = reader.path();
  std::string line;
  if (!reader.read_line(line, 64) || !line.starts_with("NRRD000") || trimmed(line).size() != 8) {
    throw DataError(header.path.string() + ": not an NRRD file; give it the ending of its own format");
  }
  if (line[7] < '1' || line[7] > '5')
    throw DataError(header.path.string() + ": versions 1 to 5 of NRRD can be read; export it as NRRD0005");
  while (!is_list(header) && reader.read_line(line, longest_line) && !line.empty()) {
    if (line.size() == longest_line)
      throw DataError(header.path.string() + ": a line of its header has no end; copy or export it again");
    add_line(header, line);
  }
  for (const char* key : {"dimension", "sizes", "type", "encoding"}) {
    if (!header.has(key)) {
      throw DataError(fmt::format("{}: its header has no '{}'; copy or export it again", header.path.string(), key));
    }
  }
  if (is_list(header)) header.list = names_of_list(reader);
  return header;
}

}  // namespace isobench
