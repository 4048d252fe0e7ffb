#include "scene/scene_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scanshade/image/png.hpp"
#include "scene/limits.hpp"

namespace scanshade {
namespace fs = std::filesystem;
namespace {

/// Without links, dots and double slashes, as far as the path exists.
fs::path plain(const fs::path& path) {
    std::error_code reason;
    const fs::path absolute = fs::absolute(path, reason);
    fs::path out = fs::weakly_canonical(absolute, reason);
    if (reason)
        throw Error(Errc::file, fmt::format("the file cannot be read ({})", reason.message()))
            .at(path.string());
    return out.has_filename() ? out : out.parent_path();
}

bool is_below(const fs::path& folder, const fs::path& path) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
}

}  // namespace

SceneFiles::SceneFiles(const fs::path& folder, bool allow_outside)
    : root_(plain(folder.empty() ? "." : folder)), allow_outside_(allow_outside) {}

bool SceneFiles::allows(const fs::path& file) const {
    return allow_outside_ || is_below(root_, plain(file));
}

fs::path SceneFiles::find(const fs::path& folder, std::string_view name) const {
    if (name.size() > max_path_bytes)
        throw Error(Errc::file, fmt::format("the name of a file has {} bytes; at most {} are taken",
                                            name.size(), max_path_bytes));
    // The system would read such a name only up to there: another one than was checked.
    if (name.find('\0') != std::string_view::npos)
        throw Error(Errc::file, "the name of a file has a byte of value 0");
    const fs::path path = folder / name;
    if (!allows(path))
        throw Error(Errc::file, fmt::format("the file is outside the scene's folder '{}'; move it "
                                            "there or give --allow-outside",
                                            root_.string()))
            .at(path.string());
    return path;
}

std::shared_ptr<const Texture> SceneFiles::texture(const fs::path& file) {
    const auto [at, is_new] = textures_.try_emplace(plain(file));
    Entry& entry = at->second;
    if (is_new) {
        try {
            entry.texture = read(file);
        } catch (const Error& fault) {
            entry.fault = fault;
        }
    }
    if (entry.fault) throw Error(*entry.fault);
    return entry.texture;
}

std::shared_ptr<const Texture> SceneFiles::read(const fs::path& file) {
    const Image image = load_image(file, max_texels);
    texels_ += std::int64_t(image.width) * image.height;
    if (texels_ > max_scene_texels)
        throw Error(Errc::format, fmt::format("with this one the textures of the scene have {} "
                                              "texels; at most {} are taken together",
                                              texels_, max_scene_texels))
            .at(file.string());
    return std::make_shared<Texture>(make_texture(image, file.string()));
}

}  // namespace scanshade
