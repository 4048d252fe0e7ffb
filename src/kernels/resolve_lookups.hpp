// Where resolve finds the values of a face at a vector of samples: in the rows of a batch or of a
// record, as planes of triangles or at the corners of quadrilaterals.
#if defined(SCANSHADE_KERNELS_RESOLVE_LOOKUPS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SCANSHADE_KERNELS_RESOLVE_LOOKUPS_HPP
#undef SCANSHADE_KERNELS_RESOLVE_LOOKUPS_HPP
#else
#define SCANSHADE_KERNELS_RESOLVE_LOOKUPS_HPP
#endif

#include "kernels/record_depth.hpp"
#include "kernels/vectors.hpp"

SCANSHADE_TARGET_BEGIN;

/// One vector of samples.
struct Samples {
    Positions at;
    VecF z, inv_z;         // 1 where there is no surface
    std::uint32_t number;  // of the vector in the surface
};

/// Rows of a record: the same at every sample.
class RecordRows {
public:
    explicit RecordRows(const Record& record) : rows_(record.rows) {}
    VecF row(int r) const { return hn::Set(tag_f, rows_[r]); }

private:
    const float* rows_;
};

/// Rows of a batch at the faces that the samples' refs name.
class BatchRows {
public:
    BatchRows(const float* batch, VecI ref)
        : batch_(batch), lane_(hn::IndicesFromVec(tag_f, hn::And(ref, hn::Set(tag_i, N - 1)))) {}
    VecF row(int r) const { return hn::TableLookupLanes(hn::Load(tag_f, batch_ + r * N), lane_); }

private:
    const float* batch_;
    decltype(hn::IndicesFromVec(tag_f, VecI())) lane_;
};

/// Values that are planes from the face's origin.
template <class Rows>
class PlaneLookup {
public:
    static constexpr bool planes = true;
    SCANSHADE_INLINE PlaneLookup(const Rows& rows, const Samples& s, const Attributes& attributes)
        : at(attributes),
          rows_(rows),
          x_(hn::Sub(s.at.x, rows.row(row_origin_x))),
          y_(hn::Sub(s.at.y, rows.row(row_origin_y))) {}
    SCANSHADE_INLINE VecF row(int r) const { return rows_.row(r); }
    SCANSHADE_INLINE VecF value(int r) const {
        return fused_value(plane(r), Lanes(x_), Lanes(y_)).v;
    }
    /// With the bits of the scalar renderers.
    VecF depth() const { return plane_value(plane(row_depth), Lanes(x_), Lanes(y_)).v; }
    const Attributes& at;

private:
    SCANSHADE_INLINE ScreenPlane<Lanes> plane(int r) const {
        return {Lanes(row(r)), Lanes(row(r + 1)), Lanes(row(r + 2))};
    }

    Rows rows_;
    VecF x_, y_;
};

/// Values that stand at the corners of a quadrilateral: (C3) and (C5), as weights of the corners.
template <class Rows>
class QuadLookup {
public:
    static constexpr bool planes = false;
    SCANSHADE_INLINE QuadLookup(const Rows& rows, const Samples& s, const Attributes& attributes)
        : at(attributes), rows_(rows) {
        const VecF X = hn::Sub(s.at.x, row(row_origin_x)), Y = hn::Sub(s.at.y, row(row_origin_y));
        VecF x[4], t[4], left = hn::Zero(tag_f), right = hn::Set(tag_f, 1.0f);
        MaskF above[4], up[4], down[4];  // whether the corner is not below the row
        for (int k = 0; k < 4; ++k) {
            const VecF y = row(row_quad_y + k);
            x[k] = row(row_quad_x + k);
            t[k] = hn::Mul(hn::Sub(Y, y), row(row_quad_per_height + k));
            above[k] = hn::Le(y, Y);
        }
        for (int k = 0; k < 4; ++k) {
            const int next = (k + 1) % 4;
            const VecF cross = hn::MulAdd(hn::Sub(x[next], x[k]), t[k], x[k]);
            up[k] = hn::AndNot(above[k], above[next]);
            down[k] = hn::AndNot(above[next], above[k]);
            left = hn::IfThenElse(up[k], cross, left);
            right = hn::IfThenElse(down[k], cross, right);
        }
        const VecF one = hn::Set(tag_f, 1.0f);
        const VecF width = hn::Max(hn::Sub(right, left), hn::Set(tag_f, 0x1p-12f));
        const VecF share = hn::Mul(hn::Sub(X, left), reciprocal(Lanes(width)).v);
        const VecF from_right = hn::Min(hn::Max(share, hn::Zero(tag_f)), one);
        const VecF from_left = hn::Sub(one, from_right);
        VecF edge[4], to_next[4];
        for (int k = 0; k < 4; ++k) {
            edge[k] = hn::IfThenElse(up[k], from_left, hn::IfThenElseZero(down[k], from_right));
            to_next[k] = hn::Mul(edge[k], t[k]);
        }
        for (int k = 0; k < 4; ++k)
            weight_[k] = hn::Add(hn::Sub(edge[k], to_next[k]), to_next[(k + 3) % 4]);
    }
    SCANSHADE_INLINE VecF row(int r) const { return rows_.row(r); }
    SCANSHADE_INLINE VecF value(int r) const {
        return hn::MulAdd(
            row(r), weight_[0],
            hn::MulAdd(row(r + 1), weight_[1],
                       hn::MulAdd(row(r + 2), weight_[2], hn::Mul(row(r + 3), weight_[3]))));
    }
    const Attributes& at;

private:
    Rows rows_;
    VecF weight_[4];
};

SCANSHADE_TARGET_END;

#endif
