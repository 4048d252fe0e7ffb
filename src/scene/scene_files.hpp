// What a scene names besides its own file: where that may be, and textures, each read once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scanshade/base/error.hpp"
#include "scanshade/image/texture.hpp"

namespace scanshade {

/// A scene comes from anywhere, so what it names is read only from its folder and what is below,
/// links followed; unless the user allows more.
class SceneFiles {
public:
    /// `folder`: of the file that the user named.
    SceneFiles(const std::filesystem::path& folder, bool allow_outside);

    /// Whether the file is inside, or all are allowed.
    bool allows(const std::filesystem::path& file) const;

    /// The file that a text in `folder` means by `name`. Throws Error(file) where that is outside.
    std::filesystem::path find(const std::filesystem::path& folder, std::string_view name) const;

    /// The picture as a texture, the same for the same file. Throws Error: that of load_image, or
    /// format where the textures of the scene would have more than max_scene_texels together.
    std::shared_ptr<const Texture> texture(const std::filesystem::path& file);

private:
    /// A texture, or why there is none: a bad file is not read again for each material.
    struct Entry {
        std::shared_ptr<const Texture> texture;
        std::optional<Error> fault;
    };
    std::shared_ptr<const Texture> read(const std::filesystem::path& file);

    std::filesystem::path root_;
    bool allow_outside_;
    std::map<std::filesystem::path, Entry> textures_;
    std::int64_t texels_ = 0;
};

}  // namespace scanshade
