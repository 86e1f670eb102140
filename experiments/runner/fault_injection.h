// Fault injection for the tests of the runner: they cause a crash, a hang, a memory hog or an invalid record, and the
// product needs no broken method for that.
#pragma once

#include <filesystem>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// The environment variable ISOBENCH_TEST_FAULT holds faults "<kind>:<glob>", joined by ";". This function does the
/// first one whose glob matches the run, and nothing if the variable is not set. Only the verb `cell` calls it. The
/// kinds:
///   crash    ends the process by SIGSEGV
///   hang     never returns
///   memory   takes memory until the process is stopped
///   silent   exits with 0 and writes nothing
///   garbage  exits with 0 and writes half a record and half a mesh
///   foreign  exits with 0 and writes a complete record of another run
///   hollow   exits with 0 and writes a record with status ok, but no mesh
void inject_fault(const RunRequest& request, const std::filesystem::path& folder);

/// The same for faults in the mesh that a method returned:
///   nan    a coordinate that is not a number
///   index  a triangle with a vertex that does not exist
///   empty  no triangles
void inject_fault(const RunRequest& request, TriangleMesh& mesh);

}  // namespace isobench
