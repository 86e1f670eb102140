#include "isobench/experiments/command_line/command_line.h"

int main(int argc, char** argv) { return isobench::command_line(argc, argv); }
