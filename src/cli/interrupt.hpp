// Ctrl-C and `kill`.
#pragma once

namespace scanshade {

/// From now on SIGINT, SIGTERM and SIGHUP end the program in good order: no file stays half-written,
/// and a sentence says why. It ends by the signal, as shells expect: their status is 130, 143 or 129.
/// A signal that was ignored when the program was started stays so.
void end_in_order_on_signals();

/// While it lives, the first of these signals only sets a flag; a second one ends the program.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    static bool came();
    /// As a shell says it: 130 after SIGINT, 143 after SIGTERM.
    static int status();
};

}  // namespace scanshade
