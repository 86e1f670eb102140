// The page in a browser, as a reader uses it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_text.h"
#include "isobench/methods/mesh/mesh_checksum.h"
#include "isobench/methods/mesh/sample_meshes.h"
#include "isobench/methods/mesh_files/mesh_files.h"
#include "isobench/reports/page/test_browser.h"
#include "isobench/reports/pictures/test_pixels.h"
#include "isobench/reports/record/sample_records.h"
#include "isobench/reports/report.h"
#include "isobench/reports/survey/sample_survey.h"
#include "isobench/reports/tables/tables.h"

namespace isobench {
namespace {

constexpr const char* published_figures = R"(source = "A paper"
[[method]]
printed = "ps"
name = "ours"
[[plate]]
number = 6
shows = "mesh"
dataset = "box"
caption = "A torus."
[[plate]]
number = 9
shows = "mesh"
dataset = "vessel"
caption = "Of what was not run."
)";

// A finished experiment with two methods. The page shows one mesh as it is and a smaller copy of the other.
std::filesystem::path made_report(const TestFolder& folder) {
  std::vector<RunRequest> plan;
  for (const std::string& method : {std::string("ours"), std::string("theirs")}) {
    RunRecord record = sample_record("box", method);
    record.measurement->set("radius_ratio_min", method == "ours" ? 0.75 : 0.5);
    const TriangleMesh mesh = sample_meshes::torus(method == "ours" ? 24 : 80);
    record.mesh_checksum = checksum(mesh);
    record.measurement->set("triangles", mesh.triangles.size());
    std::filesystem::create_directories(folder.path() / record.request.run);
    write_mesh(mesh, folder.path() / record.request.run / "mesh.vtp");
    write_record(record, folder.path() / record.request.run / "run.json");
    plan.push_back(record.request);
  }
  write_text(folder.path() / "plan.json", plan_to_json(plan));
  write_text(folder.path() / "published.toml", published_figures);
  EXPECT_EQ(write_report(folder.path()).missing, std::vector<std::string>{});
  return folder.path() / "report.html";
}

// A finished experiment with many data sets, all of them tori.
std::filesystem::path made_report_of_many(const TestFolder& folder) {
  std::vector<RunRequest> plan;
  for (RunRecord& record : sample_survey::results(30).records) {
    const std::filesystem::path run = folder.path() / record.request.run;
    std::filesystem::create_directories(run);
    if (record.status == Status::ok) {
      const TriangleMesh mesh = sample_meshes::torus(record.request.label == "fast" ? 12 : 24);
      record.mesh_checksum = checksum(mesh);
      record.measurement->set("triangles", mesh.triangles.size());
      write_mesh(mesh, run / "mesh.vtp");
    }
    write_record(record, run / "run.json");
    plan.push_back(record.request);
  }
  write_text(folder.path() / "plan.json", plan_to_json(plan));
  const Report report = write_report(folder.path());
  // That not all data sets have pictures is said, and nothing else is missing.
  EXPECT_EQ(report.missing.size(), 1U);
  EXPECT_NE(report.missing.front().find("of 30 data sets"), std::string::npos);
  return folder.path() / "report.html";
}

// Number of pixels that show a mesh: neither white nor grey.
int coloured(const std::string& png) {
  return Pixels(png).count([](const Colour& c) {
    return std::max({c.red, c.green, c.blue}) - std::min({c.red, c.green, c.blue}) > 40;
  });
}

// Number of different pixels of two pictures of one size, without the frame that shows the keyboard focus.
int differing(const std::string& before, const std::string& after) {
  const Pixels a(before);
  const Pixels b(after);
  constexpr int frame = 8;
  int count = 0;
  for (int y = frame; y < a.height() - frame; ++y) {
    for (int x = frame; x < a.width() - frame; ++x) {
      const Colour p = a.at(x, y);
      const Colour q = b.at(x, y);
      count += std::abs(p.red - q.red) + std::abs(p.green - q.green) + std::abs(p.blue - q.blue) > 30 ? 1 : 0;
    }
  }
  return count;
}

class PageInABrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string missing = Browser::missing(); !missing.empty()) GTEST_SKIP() << missing;
    page_ = made_report(folder_);
    browser_ = std::make_unique<Browser>(browser_folder_.path());
  }
  void TearDown() override {
    if (!browser_) return;
    EXPECT_EQ(browser_->complaints(), std::vector<std::string>{});
    EXPECT_EQ(browser_->requests(), std::vector<std::string>{});
  }

  void see_every_table_plot_and_picture() {
    const std::string html = read_text(page_);
    const std::size_t images = count_of(html, "<img ");
    EXPECT_GT(images, 12U);  // three pictures of each of two meshes, two under Figure 6, and plots
    browser_->ask("for (const image of document.images) image.loading = 'eager';");
    EXPECT_TRUE(browser_->eventually("return Array.from(document.images).every((image) => image.complete)"));
    EXPECT_EQ(browser_->ask("return Array.from(document.images).filter((image) => image.naturalWidth > 0 && "
                            "image.clientWidth > 100).length"),
              images);
    const auto titles = browser_->ask("return Array.from(document.querySelectorAll('h3'), (h) => h.textContent)");
    for (const Table& table : all_tables(load_results(folder_.path())))
      EXPECT_NE(std::find(titles.begin(), titles.end(), table.title), titles.end()) << table.title;
    EXPECT_EQ(browser_->ask("return Array.from(document.querySelectorAll('table')).filter((t) => t.rows.length < 2 && "
                            "t.className !== 'facts').length"),
              0);
    // One figure is shown. For the other one the page says what it needs.
    EXPECT_EQ(browser_->ask("return document.querySelectorAll('#figures h3').length"), 2);
    EXPECT_NE(html.find("It needs a finished run of vessel"), std::string::npos);
  }

  void sort_a_table_by_a_click() {
    browser_->ask(
        "Array.from(document.querySelectorAll('h3')).find((h) => h.textContent.startsWith('Table "
        "2')).nextElementSibling"
        ".querySelector('table').id = 'ratios';");
    const std::string column =
        "return Array.from(document.querySelectorAll('#ratios tbody tr'), (row) => "
        "row.cells[1].dataset.sort).join(' ')";
    browser_->click("#ratios th:nth-child(2) button");
    EXPECT_EQ(browser_->ask(column), "0.5 0.75");
    browser_->click("#ratios th:nth-child(2) button");
    EXPECT_EQ(browser_->ask(column), "0.75 0.5");
    EXPECT_EQ(browser_->ask("return document.querySelector('#ratios th:nth-child(2)').ariaSort"), "descending");
  }

  void turn_a_mesh_by_a_drag() {
    EXPECT_EQ(browser_->ask("return document.querySelectorAll('canvas').length"),
              0);  // none before a button is pressed
    browser_->click("td[data-whole] button");
    const std::string before = browser_->picture(".stage canvas");
    const int size = coloured(before);
    EXPECT_GT(size, 10000);
    browser_->drag(".stage canvas", 120, 60);
    const std::string after = browser_->picture(".stage canvas");
    EXPECT_GT(coloured(after), 10000);
    EXPECT_GT(differing(before, after), 10000);
    // Keys do the same, and 0 brings the first view back.
    browser_->type(".stage canvas", "0");
    EXPECT_LT(differing(before, browser_->picture(".stage canvas")), 100);
    browser_->turn_wheel(".stage canvas", 700);
    EXPECT_LT(coloured(browser_->picture(".stage canvas")), size / 2);  // half as large: a quarter of the pixels
  }

  void turn_a_copy_of_a_large_mesh_and_its_worst_place() {
    browser_->click("td[data-worst] button:nth-of-type(1)");
    EXPECT_GT(coloured(browser_->picture(".stage canvas")), 10000);
    const std::string caption = browser_->ask("return document.querySelector('.stage figcaption').textContent");
    EXPECT_NE(caption.find("of a mesh with 25,600"), std::string::npos) << caption;
    browser_->click("td[data-worst] button:nth-of-type(2)");
    EXPECT_GT(coloured(browser_->picture(".stage canvas")), 10000);
    EXPECT_EQ(browser_->ask("return document.querySelectorAll('canvas').length"), 1);  // one at a time
  }

  TestFolder folder_;
  TestFolder browser_folder_;
  std::filesystem::path page_;
  std::unique_ptr<Browser> browser_;
};

// All in one browser, because its start takes longer than all of these checks.
TEST_F(PageInABrowser, ShowsAllSortsAndTurns) {
  browser_->open(page_);
  see_every_table_plot_and_picture();
  sort_a_table_by_a_click();
  turn_a_mesh_by_a_drag();
  turn_a_copy_of_a_large_mesh_and_its_worst_place();
}

TEST_F(PageInABrowser, OfManyDataSetsShowsTheOverviewFirst) {
  const TestFolder many;
  browser_->open(made_report_of_many(many));
  browser_->ask("for (const image of document.images) image.loading = 'eager';");
  EXPECT_TRUE(browser_->eventually("return Array.from(document.images).every((image) => image.complete)"));
  // The close-ups stand side by side at the top, then the plots and tables over all data sets.
  EXPECT_EQ(browser_->ask("const tops = new Set(Array.from(document.querySelectorAll('#opening img'), (image) => "
                          "image.getBoundingClientRect().top)); return tops.size"),
            1);
  EXPECT_EQ(browser_->ask("return document.querySelectorAll('#opening img').length"), 3);
  EXPECT_GE(browser_->ask("return document.querySelectorAll('#plots img').length").get<int>(), 15);
  EXPECT_EQ(browser_->ask("return document.querySelectorAll('#worst img').length"), 3);
  const auto top = [this](const std::string& selector) {
    return browser_->ask("return document.querySelector('" + selector + "').getBoundingClientRect().top").get<double>();
  };
  EXPECT_LT(top("#opening"), top("#summary"));
  EXPECT_LT(top("#plots"), top("#tables"));
  EXPECT_LT(top("#tables"), top("#details"));
  // Rows of single data sets are folded until a click.
  EXPECT_EQ(browser_->ask("return document.querySelector('#details table').checkVisibility()"), false);
  browser_->click("#details summary");
  EXPECT_EQ(browser_->ask("return document.querySelector('#details h3').checkVisibility()"), true);
}

TEST_F(PageInABrowser, ReadsWithoutScripts) {
  browser_->forbid_scripts();
  browser_->open(page_);
  // No script of the page has run, and all text is there.
  EXPECT_EQ(browser_->ask("return document.querySelectorAll('button').length"), 0);
  const std::string text = browser_->ask("return document.body.innerText");
  for (const std::string part : {"Compared: 2 methods", "Worst triangle", "Figure 6", "A torus.", "How to cite"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  for (const Table& table : all_tables(load_results(folder_.path())))
    EXPECT_NE(text.find(table.title), std::string::npos) << table.title;
  EXPECT_GE(browser_->ask("return document.querySelectorAll('a[href$=\"/mesh.vtp\"]').length").get<int>(), 2);
  browser_->click("details summary");  // folds need no script
  EXPECT_EQ(browser_->ask("return document.querySelectorAll('details[open]').length"), 1);
}

}  // namespace
}  // namespace isobench
