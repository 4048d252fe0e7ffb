// The files around the one that is shown.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "scanshade/scene/scene.hpp"

namespace scanshade::viewer {

/// `folder`/`model`_N.`extension` with the first number from 1 on that no file has.
/// Throws Error(file) where the first million are taken.
std::filesystem::path next_free_path(const std::filesystem::path& folder, std::string_view model,
                                     std::string_view extension);

/// The scene file or mesh that comes `step` after `file` in its folder, by name, around the end;
/// `file` itself where there is no other.
std::filesystem::path neighbour(const std::filesystem::path& file, int step);

/// Notices that a scene's files change.
class FileWatch {
public:
    /// The input itself, and the meshes and textures that it names.
    void watch(const std::filesystem::path& input, const Scene& scene);

    /// True once after a change, as soon as two looks have found the same: a file that is being
    /// written is left alone.
    bool changed();

private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size;
        bool operator==(const Stamp&) const = default;
    };
    std::vector<std::optional<Stamp>> look() const;

    std::vector<std::filesystem::path> files_;
    std::vector<std::optional<Stamp>> known_, last_;
};

}  // namespace scanshade::viewer
