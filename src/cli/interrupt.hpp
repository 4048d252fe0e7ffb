// Ctrl-C for commands that end in good order.
#pragma once

namespace scanshade {

/// While it lives, the first SIGINT or SIGTERM only sets a flag; a second one ends the program.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    static bool came();
};

}  // namespace scanshade
