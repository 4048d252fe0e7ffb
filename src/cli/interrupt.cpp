#include "cli/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace scanshade {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void handle(int signal) {
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, handle);
}

Interrupt::~Interrupt() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
}

bool Interrupt::came() { return interrupted != 0; }

}  // namespace scanshade
