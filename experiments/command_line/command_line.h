// From the words of the command line to a verb.
#pragma once

namespace isobench {

/// Parses the command line and runs the verb that it names. Returns the program's exit code: what the verb returns, 2
/// for a UsageError, 3 for a DataError, 1 for every other error; errors are printed on stderr.
int command_line(int argc, char** argv);

}  // namespace isobench
