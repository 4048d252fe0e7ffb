// Closes a model file: makes its evaluators, its vector kernel and its row of the registry from
// the class that the file defines.

/// The vector kernel of this target.
static SpanEvents illuminate_lanes(const SurfaceSpan<float>& span, const Lighting<float>& lighting,
                                   const MaterialParams<float>& material) {
    return illuminate_span<SCANSHADE_MODEL, Lanes>(span, lighting, material);
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

template <class T>
std::array<T, 3> f_cos(const Cosines<T>& c, const MaterialParams<T>& material) {
    using namespace HWY_NAMESPACE;
    using Model = HWY_NAMESPACE::SCANSHADE_MODEL;
    const Rgb<T> f = Model::f_cos(c, ParamPack<T>{material, nullptr, diffuse_index<Model>()});
    return {f.r, f.g, f.b};
}

/// A model that reads cosθ_i alone says so.
template <class Model>
constexpr bool ignores_view() {
    return requires { Model::ignores_view; };
}

}  // namespace

#define SCANSHADE_ROW_(model) brdf_##model
#define SCANSHADE_ROW(model) SCANSHADE_ROW_(model)
extern const BrdfInfo SCANSHADE_ROW(SCANSHADE_MODEL);
const BrdfInfo SCANSHADE_ROW(SCANSHADE_MODEL) = {
    .name = HWY_NAMESPACE::SCANSHADE_MODEL::name,
    .title = HWY_NAMESPACE::SCANSHADE_MODEL::title,
    .equation = HWY_NAMESPACE::SCANSHADE_MODEL::equation,
    .source = HWY_NAMESPACE::SCANSHADE_MODEL::source,
    .params = HWY_NAMESPACE::SCANSHADE_MODEL::params,
    .promises = HWY_NAMESPACE::SCANSHADE_MODEL::promises,
    .ignores_view = ignores_view<HWY_NAMESPACE::SCANSHADE_MODEL>(),
    .f_cos_f64 = f_cos<double>,
    .f_cos_f32 = f_cos<float>,
    .illuminate_f32 = HWY_NAMESPACE::illuminate_span<HWY_NAMESPACE::SCANSHADE_MODEL, float>,
    .illuminate_f64 = HWY_NAMESPACE::illuminate_span<HWY_NAMESPACE::SCANSHADE_MODEL, double>,
    .illuminate_simd = illuminate_dispatched,
};
#undef SCANSHADE_ROW
#undef SCANSHADE_ROW_

}  // namespace scanshade
#endif
