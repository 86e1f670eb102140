// The sections of the page that are mainly words: summary, failures, claims, citations.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "isobench/datasets/manifests/catalogue.h"
#include "isobench/foundation/error.h"
#include "isobench/reports/claims/claims.h"
#include "isobench/reports/page/html.h"
#include "isobench/reports/page/page.h"
#include "isobench/reports/runs/run_grid.h"
#include "isobench/reports/tables/best_methods.h"
#include "isobench/reports/tables/table_parts.h"

namespace isobench {

namespace {

// Shortens the list, because readers skip longer ones.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
  return fmt::format("{} and {} more", fmt::join(names.begin(), names.begin() + most, ", "), names.size() - most);
}

// All different values over the records, in the order of the plan; "" does not count.
template <class Of>
std::vector<std::string> distinct(const Results& results, Of&& of) {
  std::vector<std::string> all;
  for (const RunRecord& record : results.records) {
    const std::string value = of(record);
    const bool known = std::find(all.begin(), all.end(), value) != all.end();
    if (!known && !value.empty()) all.push_back(value);
  }
  return all;
}

constexpr std::size_t most_missing = 200;  // rows for runs that are not done

std::string paragraph(const std::string& text) { return "<p>" + html_escaped(text) + "</p>\n"; }

std::string compared_sentence(const Results& results, const RunGrid& runs) {
  const std::vector<std::string> labels =
      distinct(results, [](const RunRecord& r) { return r.request.aside ? "" : r.request.label; });
  std::set<std::uint64_t> seeds;
  std::size_t aside = 0;
  for (const RunRecord& record : results.records) {
    if (record.request.aside)
      ++aside;
    else
      seeds.insert(record.request.seed);
  }
  std::string text = fmt::format("Compared: {} ({}) on {} ({})", plural(labels.size(), "method"), listed(labels),
                                 plural(runs.datasets.size(), "data set"), listed(runs.datasets));
  const std::vector<std::string> sizings =
      distinct(results, [](const RunRecord& r) { return r.request.aside ? "" : sizing_name(r.request.sizing); });
  if (sizings.size() <= 12) text += fmt::format(", with the sizing {}", fmt::join(sizings, " or "));
  if (seeds.size() > 1) text += fmt::format(", {} each", plural(seeds.size(), "seed"));
  if (aside > 0) text += fmt::format(". Not compared: {}, made for single figures and claims", plural(aside, "run"));
  return text + ".";
}

std::string matched_sentence(const Results& results) {
  std::size_t asked = 0;
  std::size_t reached = 0;
  for (const RunRecord& record : results.records) {
    if (record.request.match_to.empty()) continue;
    ++asked;
    if (record.match && record.match->reason.empty()) ++reached;
  }
  if (asked == 0) {
    return "Matched: nothing. All methods got the same sizing, so their meshes have different numbers of vertices. "
           "A mesh with more vertices can be better for that reason alone: look at the numbers of vertices, too.";
  }
  return fmt::format(
      "Matched: {} of {} have the same number of vertices as the method that they are compared with, within 2 %. The "
      "others are marked ‡.",
      reached, plural(asked, "run"));
}

std::string claims_sentence(const Results& results) {
  if (!results.published || results.published->claims.empty()) return "";
  std::map<Verdict, int> verdicts;
  for (const PublishedClaim& claim : results.published->claims) ++verdicts[evaluate(claim, results).verdict];
  return fmt::format("Claims of {}: {} held, {} did not hold, {} could not be tested with these runs.",
                     results.published->short_source, verdicts[Verdict::held], verdicts[Verdict::not_held],
                     verdicts[Verdict::not_testable]);
}

std::string done_sentence(const Results& results) {
  std::map<Status, std::size_t> states;
  for (const RunRecord& record : results.records) ++states[record.status];
  std::string text = fmt::format("Runs: {} planned", results.records.size() + results.missing.size());
  for (const auto& [status, count] : states) text += fmt::format(", {} {}", count, to_string(status));
  if (!results.missing.empty()) text += fmt::format(", {} not done yet", results.missing.size());
  return text + ".";
}

const char* badge(Verdict verdict) {
  switch (verdict) {
    case Verdict::held:
      return "<span class=\"badge held\">held</span>";
    case Verdict::not_held:
      return "<span class=\"badge not-held\">not held</span>";
    case Verdict::not_testable:
      break;
  }
  return "<span class=\"badge open\">not testable</span>";
}

std::string citation_of(const DatasetInfo& info) {
  std::string words = info.title + ". " + info.source + ".";
  if (!info.licence.empty()) words += " Licence: " + info.licence + ".";
  if (!info.acknowledgement.empty()) words += " " + info.acknowledgement;
  return words;
}

std::string or_dash(const std::string& text) { return text.empty() ? "–" : html_escaped(text); }

std::string findings_html(const ClaimResult& result) {
  std::string rows;
  for (const Finding& finding : result.findings) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        html_escaped(finding.data), badge(finding.verdict),
                        or_dash(finding.ours.empty() ? finding.remark : finding.ours), or_dash(finding.published));
  }
  if (rows.empty()) return "";
  return "<div class=\"wide\"><table class=\"sortable\"><thead><tr><th scope=\"col\">Data</th><th "
         "scope=\"col\">Verdict</th>"
         "<th scope=\"col\">Measured</th><th scope=\"col\">Published</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

}  // namespace

std::string summary_html(const Results& results) {
  const RunGrid runs = arrange_runs(results);
  std::string text = "<section id=\"summary\"><h2>Summary</h2>\n";
  if (results.records.empty()) return text + paragraph("No run is finished yet.") + "</section>\n";
  for (const std::string& sentence : {compared_sentence(results, runs), matched_sentence(results),
                                      done_sentence(results), claims_sentence(results)}) {
    if (!sentence.empty()) text += paragraph(sentence);
  }
  const std::vector<std::string> sentences = best_sentences(runs);
  if (!sentences.empty()) {
    text += "<h3>Where each method is best (in a tie, all are named)</h3>\n<ul class=\"findings\">\n";
    for (const std::string& sentence : sentences) text += "<li>" + html_escaped(sentence) + "</li>\n";
    text += "</ul>\n";
  }
  text += html(methods_table(runs));
  // It has a column for each data set.
  if (!has_many_datasets(runs)) text += html(best_table(runs));
  return text + "</section>\n";
}

std::string gaps_html(const Results& results) {
  constexpr std::size_t most_rows = 1000;
  std::string rows;
  std::size_t gaps = 0;
  for (const RunRecord& record : results.records) {
    if (record.status == Status::ok || ++gaps > most_rows) continue;
    rows += fmt::format("<tr><th scope=\"row\">{}</th><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>\n",
                        html_escaped(record.request.dataset), html_escaped(record.request.label),
                        to_string(record.status), html_escaped(record.reason));
  }
  const std::size_t shown = std::min(most_missing, results.missing.size());
  for (std::size_t n = 0; n < shown; ++n) {
    const RunRequest& request = results.missing[n];
    rows += fmt::format("<tr><th scope=\"row\">{}</th><th scope=\"row\">{}</th><td>not done yet</td><td></td></tr>\n",
                        html_escaped(request.dataset), html_escaped(request.label));
  }
  std::string text;
  for (const std::string& sentence : results.unreadable) text += paragraph(sentence);
  if (rows.empty() && text.empty()) return "";
  if (!rows.empty()) {
    text +=
        "<div class=\"wide\"><table class=\"sortable\"><thead><tr><th scope=\"col\">Data</th><th "
        "scope=\"col\">Method</th>"
        "<th scope=\"col\">State</th><th scope=\"col\">Why</th></tr></thead>\n<tbody>\n" +
        rows + "</tbody></table></div>\n";
  }
  if (gaps > most_rows)
    text += paragraph(fmt::format("And {} more runs that failed or were skipped.", gaps - most_rows));
  if (shown < results.missing.size())
    text += paragraph(fmt::format("And {} more runs that are not done yet.", results.missing.size() - shown));
  return "<section id=\"gaps\"><h2>Failed, skipped or not done yet</h2>\n" + text + "</section>\n";
}

std::string claims_html(const Results& results) {
  if (!results.published || results.published->claims.empty()) return "";
  const Published& published = *results.published;
  std::string text =
      fmt::format("<section id=\"claims\"><h2>Claims of {}</h2>\n", html_escaped(published.short_source));
  text += paragraph(published.note);
  if (const std::string names = printed_names(published); !names.empty()) text += paragraph(names);
  std::size_t number = 0;
  for (const PublishedClaim& claim : published.claims) {
    const ClaimResult result = evaluate(claim, results);
    text += fmt::format("<details class=\"claim\"><summary>{} {}. {}</summary>\n<p><b>{}</b></p>\n",
                        badge(result.verdict), ++number, html_escaped(claim.words), html_escaped(result.summary));
    text += findings_html(result) + "<p class=\"remark\">Tested: " + html_escaped(rule_text(claim)) + ".";
    if (!claim.differs.empty()) text += " What differs: " + html_escaped(claim.differs);
    text += "</p></details>\n";
  }
  return text + "</section>\n";
}

std::string citations_html(const Results& results) {
  std::map<std::string, DatasetInfo> known;
  try {
    for (DatasetInfo& info : list_datasets()) known[info.name] = std::move(info);
  } catch (const Error&) {
    // The program was moved away from its catalogue. The page then does not describe the data sets.
  }
  std::string text = "<section id=\"cite\"><h2>How to cite</h2>\n<dl>\n<dt>This software</dt>\n";
  for (const std::string& version : distinct(results, [](const RunRecord& r) {
         return fmt::format("isobench {}, commit {}{}", r.environment.version, r.environment.commit.substr(0, 12),
                            r.environment.dirty ? " with local changes" : "");
       })) {
    text += "<dd>" + html_escaped(version) + "; see CITATION.cff</dd>\n";
  }
  if (results.published)
    text += std::string("<dt>") + (results.published->figures.empty() ? "Publications" : "Published figures") +
            "</dt>\n<dd>" + html_escaped(results.published->source) + "</dd>\n";
  // Data sets with the same words share an entry; a thousand generated ones need no thousand entries.
  std::vector<std::pair<std::string, std::vector<std::string>>> entries;
  for (const std::string& dataset : distinct(results, [](const RunRecord& r) { return r.request.dataset; })) {
    const auto info = known.find(dataset);
    const std::string words = info == known.end() ? "see the manifest of the data set" : citation_of(info->second);
    auto entry =
        std::find_if(entries.begin(), entries.end(), [&words](const auto& each) { return each.first == words; });
    if (entry == entries.end()) entry = entries.insert(entry, {words, {}});
    entry->second.push_back(dataset);
  }
  for (const auto& [words, datasets] : entries)
    text += "<dt>Data: " + html_escaped(listed(datasets)) + "</dt>\n<dd>" + html_escaped(words) + "</dd>\n";
  return text + "</dl></section>\n";
}

}  // namespace isobench
