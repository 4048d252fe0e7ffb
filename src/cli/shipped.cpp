#include "cli/shipped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scanshade/base/error.hpp"

namespace scanshade {
namespace fs = std::filesystem;

fs::path shipped_folder(std::string_view name, std::string_view remedy) {
    std::error_code ignored;
    std::vector<fs::path> roots{fs::path()};
    for (fs::path at = fs::read_symlink("/proc/self/exe", ignored).parent_path();
         at.has_relative_path(); at = at.parent_path())
        roots.push_back(at);
    for (const fs::path& root : roots) {
        fs::path folder = root / "models" / name;
        const auto entries = fs::directory_iterator(folder, ignored);
        if (std::any_of(begin(entries), end(entries),
                        [](const auto& entry) { return entry.path().extension() == ".toml"; }))
            return folder;
    }
    throw Error(Errc::file, fmt::format("the scenes of models/{} are neither below the working "
                                        "directory nor beside this program; {}",
                                        name, remedy));
}

}  // namespace scanshade
