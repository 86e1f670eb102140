// isobench-pictures FOLDER: draws the pictures of a results folder; called by `isobench run` and `isobench report`. A
// program of its own because OpenGL takes memory from every process that loads it, and a crash in it costs no report.
#include <fmt/format.h>

#include <exception>

#include "isobench/reports/pictures/drawing.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print("isobench-pictures draws for isobench report; call that\n");
    return 2;
  }
  try {
    for (const std::string& sentence : isobench::draw_pictures(isobench::load_results(argv[1]), argv[1]))
      fmt::print("{}\n", sentence);
  } catch (const std::exception& error) {
    fmt::print("There are no pictures: {}.\n", error.what());
    return 1;
  }
  return 0;
}
