#include "experiments/verbs.h"

int main(int argc, char** argv) { return isobench::command_line(argc, argv); }
