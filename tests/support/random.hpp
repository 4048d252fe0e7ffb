// Random numbers for tests: from fixed seeds, the same on every machine.
#pragma once

#include <cstdint>
#include <span>

namespace scanshade {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Rng {
public:
    explicit Rng(std::uint64_t seed) : state_(seed) {}
    /// The first numbers are the tape's, two bytes each: so a fuzzer chooses what follows from them.
    explicit Rng(std::span<const std::uint8_t> tape) : state_(tape.size()), tape_(tape) {}

    std::uint64_t bits() {
        if (tape_.size() >= 2) {
            const auto word = std::uint64_t(tape_[0]) << 8 | tape_[1];
            tape_ = tape_.subspan(2);
            return word * 0x0001000100010001u;
        }
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [low, high).
    double real(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }
    /// In [low, high].
    std::int64_t integer(std::int64_t low, std::int64_t high) {
        return low + static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double probability) { return real(0, 1) < probability; }

private:
    std::uint64_t state_;
    std::span<const std::uint8_t> tape_{};
};

}  // namespace scanshade
