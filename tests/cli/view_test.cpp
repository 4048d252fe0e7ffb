// scanshade view: hands its arguments to the viewer beside it, or says how to get one.
#include <stdlib.h>

#include "cli/process.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

/// A copy of the program in a folder where no viewer is.
std::string copy_program(const TempFolder& folder) {
    const std::filesystem::path copy = folder.path / "scanshade";
    std::filesystem::copy_file(SCANSHADE_BINARY, copy);
    return copy;
}

}  // namespace

TEST_CASE("view starts the viewer beside it with the same arguments", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), program = copy_program(folder);
    const auto viewer = folder.write("scanshade-view", "#!/bin/sh\nprintf '<%s>' \"$@\"\nexit 7\n");
    std::filesystem::permissions(viewer, std::filesystem::perms::owner_all);
    const Finished run =
        run_scanshade({"view", in, "--exposure", "-1", "--viewer-only", "a b"}, {}, program);
    CAPTURE(run.err);
    CHECK(run.status == 7);
    CHECK(run.out == "<" + in + "><--exposure><-1><--viewer-only><a b>");
}

TEST_CASE("view says how to get the viewer where there is none", "[cli]") {
    const TempFolder folder;
    const std::string in = write_triangle(folder), program = copy_program(folder);
    const std::string path = ::getenv("PATH") ? ::getenv("PATH") : "";
    ::setenv("PATH", "/nonexistent", 1);
    const Finished run = run_scanshade({"view", in}, {}, program);
    ::setenv("PATH", path.c_str(), 1);
    CHECK(run.status == 3);
    CHECK(run.err.find("scanshade-view") != std::string::npos);
    CHECK(run.err.find("make") != std::string::npos);
}
