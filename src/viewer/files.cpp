#include "viewer/files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scanshade/base/error.hpp"

namespace scanshade::viewer {
namespace fs = std::filesystem;

fs::path next_free_path(const fs::path& folder, std::string_view model,
                        std::string_view extension) {
    constexpr int max_number = 1'000'000;
    for (int n = 1; n <= max_number; ++n) {
        const fs::path path = folder / fmt::format("{}_{}.{}", model, n, extension);
        std::error_code unreadable;  // saving there will say what is wrong
        if (!fs::exists(path, unreadable)) return path;
    }
    throw Error(Errc::file, fmt::format("the names {0}_1.{2} to {0}_{1}.{2} are all taken; move "
                                        "some files elsewhere",
                                        model, max_number, extension));
}

fs::path neighbour(const fs::path& file, int step) {
    const fs::path folder = file.parent_path().empty() ? fs::path(".") : file.parent_path();
    std::vector<fs::path> files;
    std::error_code unreadable;
    for (const auto& entry : fs::directory_iterator(folder, unreadable)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".obj" || extension == ".toml" || extension == ".OBJ")
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    const auto named = [&](const fs::path& p) { return p.filename() == file.filename(); };
    const auto now = std::find_if(files.begin(), files.end(), named);
    if (now == files.end()) return file;
    const auto count = static_cast<int>(files.size());
    const auto at = static_cast<int>(now - files.begin());
    return files[static_cast<std::size_t>(((at + step) % count + count) % count)];
}

void FileWatch::watch(const fs::path& input, const Scene& scene) {
    files_ = {input};
    for (const Object& object : scene.objects)
        if (!object.mesh_file.empty()) files_.push_back(object.mesh_file);
    for (const Material& material : scene.materials)
        if (!material.map_file.empty()) files_.push_back(material.map_file);
    std::sort(files_.begin() + 1, files_.end());
    files_.erase(std::unique(files_.begin() + 1, files_.end()), files_.end());
    known_ = last_ = look();
}

std::vector<std::optional<FileWatch::Stamp>> FileWatch::look() const {
    std::vector<std::optional<Stamp>> stamps;
    for (const fs::path& file : files_) {
        std::error_code gone;
        const Stamp stamp{fs::last_write_time(file, gone), fs::file_size(file, gone)};
        stamps.push_back(gone ? std::nullopt : std::optional(stamp));
    }
    return stamps;
}

bool FileWatch::changed() {
    const auto now = look();
    const bool settled = now == last_ && now != known_;
    last_ = now;
    if (settled) known_ = now;
    return settled;
}

}  // namespace scanshade::viewer
