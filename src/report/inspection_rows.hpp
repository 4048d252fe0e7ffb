// Rows of an inspection: what the float and the double renderer have for one quantity.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "scanshade/report/inspection.hpp"

namespace scanshade {

template <class T>
std::vector<double> numbers(const std::array<T, 3>& v) {
    return {double(v[0]), double(v[1]), double(v[2])};
}
inline std::vector<double> numbers(double v) { return {v}; }
inline std::vector<double> numbers(float v) { return {double(v)}; }

/// Adds rows to a section: what `get` takes from the numbers in float and from those in double.
template <class F32, class F64>
class Rows {
public:
    Rows(InspectionSection& section, const F32& f32, const F64& f64)
        : section_(section), f32_(f32), f64_(f64) {}

    template <class Get>
    void add(std::string symbol, std::string meaning, Get get) {
        section_.rows.push_back(
            {std::move(symbol), std::move(meaning), numbers(get(f32_)), numbers(get(f64_)), false});
    }
    template <class Get>
    void add_rgb(std::string symbol, std::string meaning, Get get) {
        add(std::move(symbol), std::move(meaning), get);
        section_.rows.back().is_rgb = true;
    }

private:
    InspectionSection& section_;
    const F32& f32_;
    const F64& f64_;
};

template <class T>
std::array<T, 3> array_of(const T (&v)[3]) {
    return {v[0], v[1], v[2]};
}

/// All sections of a point that is lit: the point, its lights, the sum. `where` is it, as a title
/// goes on after "C7 ".
void add_lit_point(const Inspection& inspection, const InspectedSample& s, std::size_t number,
                   const std::string& where, std::vector<InspectionSection>& out);

}  // namespace scanshade
