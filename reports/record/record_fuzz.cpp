// The files of a results folder: records, plans and published figures, and the tables that are made from them.
#include <filesystem>

#include "isobench/foundation/names.h"
#include "isobench/foundation/testing/fuzz_target.h"
#include "isobench/reports/claims/claims.h"
#include "isobench/reports/csv/results_csv.h"
#include "isobench/reports/latex/latex.h"
#include "isobench/reports/tables/tables.h"
#include "isobench/reports/tables_document.h"

namespace isobench {

namespace {

void check_request(const RunRequest& request) {
  require(is_plain_name(request.run, 240), "a run's folder stays where it is");
}

/// Makes the tables of three runs: the record, the same with another seed, and the same as a failed run.
void check_tables(const RunRecord& record) {
  Results results;
  results.records = {record, record, record};
  ++results.records[1].request.seed;
  results.records[2].measurement.reset();
  results.records[2].status = Status::failed;
  require(!markdown_tables(results).empty() && !latex_tables(results).empty(), "a record can be shown");
  require(!results_csv(results.records).empty(), "a record has a row");
}

}  // namespace

bool fuzz_record(std::string_view bytes) {
  return accepts([&] {
    const RunRecord record = record_from_json(std::string(bytes), "run.json");
    check_request(record.request);
    const std::string text = to_json(record);
    require(to_json(record_from_json(text, "again")) == text, "written and read, a record is the same");
    check_tables(record);
    return true;
  });
}

bool fuzz_plan(std::string_view bytes) {
  return accepts([&] {
    const std::vector<RunRequest> plan = plan_from_json(std::string(bytes), "plan.json");
    for (const RunRequest& request : plan) check_request(request);
    const std::string text = plan_to_json(plan);
    require(plan_to_json(plan_from_json(text, "again")) == text, "written and read, a plan is the same");
    return true;
  });
}

bool fuzz_published(std::string_view bytes) {
  return accepts([&] {
    Results results;
    results.published = read_published(fuzz_file("published.toml", bytes));
    for (const PublishedClaim& claim : results.published->claims) {
      require(!rule_text(claim).empty(), "a claim can be said");
      require(!evaluate(claim, results).summary.empty(), "a claim can be judged");
    }
    markdown_tables(results);
    return true;
  });
}

}  // namespace isobench
