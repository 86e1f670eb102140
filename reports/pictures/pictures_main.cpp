// isobench-pictures FOLDER: draws the pictures of a results folder. `isobench run` and `isobench report` call it. It is
// a separate program because OpenGL needs much memory in every process that loads it, and because a crash in it must
// not stop the report.
#include <fmt/format.h>

#include <exception>

#include "isobench/reports/pictures/drawing.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print("isobench-pictures is called by isobench report; use that instead\n");
    return 2;
  }
  try {
    for (const std::string& sentence : isobench::draw_pictures(isobench::load_results(argv[1]), argv[1]))
      fmt::print("{}\n", sentence);
  } catch (const std::exception& error) {
    fmt::print("No pictures were drawn: {}.\n", error.what());
    return 1;
  }
  return 0;
}
