#include "isobench/experiments/command_line/verbs.h"

int main(int argc, char** argv) { return isobench::command_line(argc, argv); }
