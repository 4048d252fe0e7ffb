// Errors in units of the last place.
#pragma once

#include <limits>
#include <span>

#include "scanshade/report/equation_stability.hpp"

namespace scanshade {

/// What an ulp depends on.
struct Precision {
    double epsilon;     // ulp of 1
    double min_normal;  // below it ulps do not shrink further
};

template <class F>
Precision precision_of() {
    using Limits = std::numeric_limits<F>;
    return {double(Limits::epsilon()), double(Limits::min())};
}

/// One component of a result.
struct Component {
    double value, error, exact;  // error = value − exact, taken before rounding to double
};

/// Counts one result: the length of its error in ulp of the exact length. An exact result that is no
/// number has no error: it only asks for a number. `may_be_zero`: an answer of 0 is allowed.
void add_error(std::span<const Component> result, const Precision& precision, double x,
               double bound, bool may_be_zero, SweepErrors& into);

}  // namespace scanshade
