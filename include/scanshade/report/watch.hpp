// How a measurement that takes minutes talks to whoever started it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace scanshade {

struct Watch {
    /// What is measured now, and how many of all measurements are done.
    std::function<void(const std::string& what, std::size_t done, std::size_t all)> tell =
        [](const std::string&, std::size_t, std::size_t) {};
    /// True: end soon, with what there is.
    std::function<bool()> stopped = [] { return false; };
};

/// Where a measurement stands among all of them.
struct Steps {
    const Watch& watch;
    std::size_t done = 0, all = 0;

    void tell(const std::string& what) const { watch.tell(what, done, all); }
};

}  // namespace scanshade
