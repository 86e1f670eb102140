// The page in a browser: chromium without a window. It is asked by a script that is added to a copy of the page, and
// answers in the page's own text.
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cstdlib>

#include "datasets/run_tool.h"
#include "datasets/test_folder.h"
#include "methods/mesh_checksum.h"
#include "methods/mesh_files.h"
#include "metrics/sample_meshes.h"
#include "reports/page.h"
#include "reports/report.h"
#include "reports/sample_records.h"

namespace isobench {
namespace {

constexpr const char* listener =
    "<script>const problems = [];\n"
    "window.addEventListener('error', (e) => problems.push(String(e.message)), true);\n"
    "const told = console.error; console.error = (...words) => { problems.push(words.join(' ')); told(...words); };\n"
    "</script>\n";

constexpr const char* questions = R"(<script>
const column = (table) => Array.from(table.tBodies[0].rows, (row) => row.cells[1].dataset.sort ?? row.cells[1].textContent);
const answers = {};
const ratios = Array.from(document.querySelectorAll('h3')).find((h) => h.textContent.startsWith('Table 2')).nextElementSibling
  .querySelector('table');
ratios.tHead.rows[0].cells[1].querySelector('button').click();
answers.up = column(ratios).join(' ');
ratios.tHead.rows[0].cells[1].querySelector('button').click();
answers.down = column(ratios).join(' ');
for (const image of document.images) image.loading = 'eager';
setTimeout(() => {
  answers.images = Array.from(document.images).filter((image) => image.complete && image.naturalWidth > 0).length;
  answers.requests = performance.getEntriesByType('resource').filter((r) => !r.name.startsWith('data:')).length;
  answers.problems = problems.join('; ');
  const line = document.createElement('p');
  line.textContent = 'ANSWERS' + Object.entries(answers).map(([key, value]) => ` ${key}=[${value}]`).join('');
  document.body.append(line);
}, 5000);
</script>)";

bool chromium_is_there() { return std::system("chromium --version >/dev/null 2>&1") == 0; }

// What chromium says, asked for this.
std::string seen(const TestFolder& folder, const std::string& html, const std::vector<std::string>& options) {
  const std::filesystem::path file = folder.write("seen.html", html);
  std::vector<std::string> words = {"chromium", "--headless", "--no-sandbox", "--disable-gpu",
                                    "--user-data-dir=" + (folder.path() / "browser").string()};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back("file://" + file.string());
  EXPECT_TRUE(run_tool(words, folder.path()));
  return read_text(folder.path() / "log.txt");
}

// A finished experiment with two meshes.
std::string made_page(const TestFolder& folder) {
  std::vector<RunRequest> plan;
  for (const std::string& method : {std::string("ours"), std::string("theirs")}) {
    RunRecord record = sample_record("box", method);
    record.measurement->radius_ratio.min = method == "ours" ? 0.75 : 0.5;
    TriangleMesh mesh = sample_meshes::torus(method == "ours" ? 24 : 12);
    record.mesh_checksum = checksum(mesh);
    std::filesystem::create_directories(folder.path() / record.request.run);
    write_mesh(mesh, folder.path() / record.request.run / "mesh.vtp");
    write_record(record, folder.path() / record.request.run / "run.json");
    plan.push_back(record.request);
  }
  write_text(folder.path() / "plan.json", plan_to_json(plan));
  write_report(folder.path());
  return read_text(folder.path() / "report.html");
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(SlowPageInABrowser, ShowsEverythingSortsAndAsksNoNetwork) {
  if (!chromium_is_there()) GTEST_SKIP() << "chromium is not installed";
  const TestFolder folder;
  std::string html = made_page(folder);
  const std::size_t images = count_of(html, "<img ");
  EXPECT_GT(images, 6U);  // two meshes, three pictures each, and plots
  html.insert(html.find("<style>"), listener);
  html.insert(html.rfind("</body>"), questions);
  const std::string dom = seen(folder, html, {"--virtual-time-budget=20000", "--dump-dom"});
  EXPECT_NE(dom.find("up=[0.5 0.75]"), std::string::npos);
  EXPECT_NE(dom.find("down=[0.75 0.5]"), std::string::npos);
  EXPECT_NE(dom.find("images=[" + std::to_string(images) + "]"), std::string::npos);  // and every one could be decoded
  EXPECT_NE(dom.find("requests=[0]"), std::string::npos);
  EXPECT_NE(dom.find("problems=[]"), std::string::npos)
      << dom.substr(std::min(dom.size(), dom.find("<p>ANSWERS")), 400);
}

TEST(SlowPageInABrowser, ReadsWithoutScripts) {
  if (!chromium_is_there()) GTEST_SKIP() << "chromium is not installed";
  const TestFolder folder;
  const std::filesystem::path shot = folder.path() / "shot.png";
  made_page(folder);
  // In a sandbox of no rights nothing of the page's is run.
  const std::string framed =
      "<body style=\"margin:0\"><iframe sandbox src=\"report.html\" "
      "style=\"border:0;width:1200px;height:2400px\"></iframe>";
  seen(folder, framed, {"--hide-scrollbars", "--window-size=1200,2400", "--screenshot=" + shot.string()});
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(shot.c_str());
  reader->Update();
  int size[3];
  reader->GetOutput()->GetDimensions(size);
  ASSERT_EQ(size[0], 1200);
  ASSERT_EQ(size[1], 2400);
  // Dark pixels are text; a page of tables has some in most of its rows.
  int rows_with_text = 0;
  for (int y = 0; y < size[1]; ++y) {
    int dark = 0;
    for (int x = 0; x < size[0]; ++x) {
      dark += *static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer(x, y, 0)) < 100 ? 1 : 0;
    }
    rows_with_text += dark > 3 ? 1 : 0;
  }
  EXPECT_GT(rows_with_text, size[1] / 4);
}

}  // namespace
}  // namespace isobench
