// Fault injection for the tests of the runner: the only way to see what a crash, a hang, a memory hog or nonsense does
// without keeping a broken method in the product.
#pragma once

#include <filesystem>

#include "isobench/methods/mesh/triangle_mesh.h"
#include "isobench/reports/record/record.h"

namespace isobench {

/// Does what the environment variable ISOBENCH_TEST_FAULT says, "<kind>:<glob>" or several of them joined by ";", to
/// the runs that a glob names:
///   crash    ends the process by SIGSEGV;
///   hang     never returns;
///   memory   takes memory until somebody stops it;
///   silent   exits with 0 and leaves nothing;
///   garbage  exits with 0 and leaves half a record and half a mesh;
///   foreign  exits with 0 and leaves the whole record of another run;
///   hollow   exits with 0 and leaves a record that says ok, but no mesh.
/// Nothing where the variable is not set. Called by the verb `cell` alone.
void inject_fault(const RunRequest& request, const std::filesystem::path& folder);

/// Likewise spoils what a method returned: nan, a coordinate that is no number; index, a corner that is no vertex;
/// empty, no triangles.
void inject_fault(const RunRequest& request, TriangleMesh& mesh);

}  // namespace isobench
