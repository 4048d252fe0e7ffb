// A rival in a process of its own, and the line to it.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/rival.hpp"

namespace scanshade::bench {

struct RivalInfo {
    const char* name;
    std::unique_ptr<Rival> (*make)(const Ground&);
};

/// What the rivals of one group of cells share. Each process builds the scene for itself.
struct Group {
    std::string scene;
    std::filesystem::path mesh_file;  // empty: the scene is one of ours
    Cull cull;
    int threads;  // 1: the process is bound to one core
    std::vector<Cell> cells;
};

struct Memory {
    std::uint64_t scene_bytes;  // resident with the scene loaded and nothing prepared
    std::uint64_t peak_bytes;   // the most since, above that
};

class RivalProcess {
public:
    /// Starts the process. The caller must have a single thread.
    RivalProcess(const RivalInfo& info, const Group& group);
    ~RivalProcess();
    RivalProcess(const RivalProcess&) = delete;
    RivalProcess& operator=(const RivalProcess&) = delete;

    const char* name() const { return info_.name; }

    // As Rival's. What goes wrong over there is thrown here as Error.
    std::string about();
    std::vector<std::string> prepare(std::size_t cell);
    Picture picture(std::size_t way);

    /// Draws some frames, and times the last `timed` of them: ms each.
    std::vector<double> draw(std::size_t way, int untimed, int timed);

    /// Of the cell prepared last.
    Memory memory();

private:
    RivalInfo info_;
    pid_t child_ = -1;
    int line_ = -1;
};

}  // namespace scanshade::bench
