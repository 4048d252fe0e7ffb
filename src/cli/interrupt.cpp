#include "cli/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <initializer_list>
#include <string_view>

#include "scanshade/base/files.hpp"

namespace scanshade {
namespace {

using Handler = void (*)(int);

volatile std::sig_atomic_t signal_that_came = 0;
bool on_terminal = false;

void install(Handler handler) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action = {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_IGN) continue;  // `nohup`, or a job in the background
        action.sa_handler = handler;
        action.sa_flags = SA_RESTART;
        ::sigaction(signal, &action, nullptr);
    }
}

/// Where nobody hears it, that is no reason to go on.
void say(std::string_view text) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// Only what a handler may call: no allocation, no stream.
void end(int signal) {
    remove_unfinished_file();
    constexpr std::string_view clear_line = "\r\033[K",
                               sentence = "scanshade: interrupted; nothing was written\n";
    if (on_terminal) say(clear_line);
    say(sentence);
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // once the handler is left
}

void note_signal(int signal) {
    signal_that_came = signal;
    install(end);
}

}  // namespace

void end_in_order_on_signals() {
    on_terminal = ::isatty(STDERR_FILENO) != 0;
    install(end);
}

Interrupt::Interrupt() { install(note_signal); }

Interrupt::~Interrupt() { install(end); }

bool Interrupt::came() { return signal_that_came != 0; }

int Interrupt::status() { return 128 + signal_that_came; }

}  // namespace scanshade
