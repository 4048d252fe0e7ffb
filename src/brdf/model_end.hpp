// Closes a model file: makes its evaluators, its vector kernel and its row of the registry from
// the class that the file defines.

/// The vector kernel of this target: two vectors at once, then what is left.
static SpanEvents illuminate_lanes(const SurfaceSpan<float>& span, const Lighting<float>& lighting,
                                   const MaterialParams<float>& material) {
    constexpr std::size_t width = RealTraits<LanesPair>::width;
    const std::size_t paired = span.count / width * width;
    SpanEvents events;
    if (paired > 0)
        events += illuminate_span<SCANSHADE_MODEL, LanesPair>(part_of(span, 0, paired), lighting,
                                                              material);
    if (paired < span.count)
        events += illuminate_span<SCANSHADE_MODEL, Lanes>(
            part_of(span, paired, span.count - paired), lighting, material);
    return events;
}

SCANSHADE_TARGET_END;

#if HWY_ONCE
namespace scanshade {
namespace {

HWY_EXPORT(illuminate_lanes);

SpanEvents illuminate_dispatched(const SurfaceSpan<float>& span, const Lighting<float>& lighting,
                                 const MaterialParams<float>& material) {
    return HWY_DYNAMIC_DISPATCH(illuminate_lanes)(span, lighting, material);
}

using Model = HWY_NAMESPACE::SCANSHADE_MODEL;

float plain(float x) { return x; }
double plain(double x) { return x; }
long double plain(long double x) { return x; }

/// The model in the number type R; T is R as plain data.
template <class R, class T>
std::array<T, 3> f_cos(const Cosines<T>& c,
                       const MaterialParams<HWY_NAMESPACE::Scalar<R>>& material) {
    const R one(1);
    const auto params = HWY_NAMESPACE::param_pack<Model, R>(material, {one, one, one});
    const auto f = Model::f_cos(cosines_as<R>(c), params);
    return {plain(f.r), plain(f.g), plain(f.b)};
}

template <class T>
SpanEvents illuminate(const SurfaceSpan<T>& span, const Lighting<T>& lighting,
                      const MaterialParams<T>& material) {
    return HWY_NAMESPACE::illuminate_span<Model, T>(span, lighting, material);
}

template <class T>
void report(const SurfaceSpan<T>& span, const Lighting<T>& lighting,
            const MaterialParams<T>& material, PointReport<T>& into) {
    HWY_NAMESPACE::illuminate_span<Model, T>(span, lighting, material,
                                             HWY_NAMESPACE::Witness<Model, T>(into));
}

template <class M>
void derive(MaterialParams<double>& params) {
    if constexpr (requires { M::derive(params); }) M::derive(params);
}

// What a model may say of itself.
template <class Model>
constexpr bool ignores_view() {
    return requires { Model::ignores_view; };
}
template <class Model>
constexpr auto most_of() -> double (*)(const MaterialParams<double>&, int) {
    if constexpr (requires { Model::most; })
        return Model::most;
    else
        return nullptr;
}
template <class Model>
constexpr bool reads_matt() {
    return requires { Model::reads_matt; };
}

}  // namespace

#define SCANSHADE_ROW_(model) brdf_##model
#define SCANSHADE_ROW(model) SCANSHADE_ROW_(model)
extern const BrdfInfo SCANSHADE_ROW(SCANSHADE_MODEL);
const BrdfInfo SCANSHADE_ROW(SCANSHADE_MODEL) = {
    .name = Model::name,
    .title = Model::title,
    .equation = Model::equation,
    .source = Model::source,
    .params = Model::params,
    .promises = Model::promises,
    .most = most_of<Model>(),
    .reads_matt = reads_matt<HWY_NAMESPACE::SCANSHADE_MODEL>(),
    .ignores_view = ignores_view<Model>(),
    .derive = derive<Model>,
    .f_cos_f64 = f_cos<double, double>,
    .f_cos_f32 = f_cos<float, float>,
    .f_cos_f80 = f_cos<long double, long double>,
    .f_cos_interval = f_cos<HWY_NAMESPACE::Interval, PlainInterval>,
    .f_cos_dual = f_cos<HWY_NAMESPACE::Dual, PlainDual>,
    .illuminate_f32 = illuminate<float>,
    .illuminate_f64 = illuminate<double>,
    .illuminate_simd = illuminate_dispatched,
    .report_f32 = report<float>,
    .report_f64 = report<double>,
};
#undef SCANSHADE_ROW
#undef SCANSHADE_ROW_

}  // namespace scanshade
#endif
