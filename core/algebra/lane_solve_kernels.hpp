#pragma once

/// @file
/// The triangular solves of a supernode for all lanes at once, over any pack type `P` (one value per lane).
/// Forward: x_c = L_cc^-1 x_c, x_r -= L_rc x_c. Backward: x_c = L_cc^-T (x_c - L_rc' x_r).
/// `P` needs: P::load(const double*), store(double*), P = double broadcast, -, *, and `x -= a * b`.
///
/// A row of x is `Lanes` wide, one or several packs. Where it is several, each panel of L is gone through once for
/// each of them while it is in the first cache: the accumulators of a panel of six rows are to stay in registers.
/// No lane's arithmetic depends on that.

#include <algorithm>
#include <cstddef>

#include "core/algebra/supernodes.hpp"
#include "core/lanes/lane_packs.hpp"

namespace unbruised::kernels {

/// The row of x with this number.
template <int Lanes, class Double>
Double* row_of(Double* x, int row) {
  return x + static_cast<std::size_t>(row) * Lanes;
}

template <class P, int Lanes, int Height>
struct ForwardPanel {
  /// acc[r] -= sum_k L[r, k] x[k] for one panel, k in [0, columns).
  static void update(const double* L, const double* x, int columns, P (&acc)[Height]) {
    for (int k = 0; k < columns; ++k) {
      const P xk = P::load(row_of<Lanes>(x, k));
      for (int r = 0; r < Height; ++r) acc[r] -= P(L[r]) * xk;
      L += Height;
    }
  }
  /// Diagonal panel: columns before it, then its own triangle (reciprocals on the diagonal).
  static void diagonal(const double* L, double* x, int first) {
    P acc[Height];
    double* own = row_of<Lanes>(x, first);
    for (int r = 0; r < Height; ++r) acc[r] = P::load(row_of<Lanes>(own, r));
    update(L, x, first, acc);
    const double* T = L + static_cast<std::size_t>(first) * Height;
#pragma GCC unroll 6  // so that they stay in registers here too
    for (int k = 0; k < Height; ++k) {
      acc[k] = acc[k] * P(T[k * Height + k]);
#pragma GCC unroll 6
      for (int r = k + 1; r < Height; ++r) acc[r] -= P(T[k * Height + r]) * acc[k];
      acc[k].store(row_of<Lanes>(own, k));
    }
  }
  static void below(const double* L, const double* x_columns, int columns, const int* rows, double* x) {
    P acc[Height];
    for (int r = 0; r < Height; ++r) acc[r] = P::load(row_of<Lanes>(x, rows[r]));
    update(L, x_columns, columns, acc);
    for (int r = 0; r < Height; ++r) acc[r].store(row_of<Lanes>(x, rows[r]));
  }
};

/// Calls `f.template operator()<H>()` with the run-time height 1..kPanelRows as a constant.
template <class F>
inline void with_height(int height, F&& f) {
  static_assert(kPanelRows == 6);
  switch (height) {
    case 6:
      f.template operator()<6>();
      break;
    case 5:
      f.template operator()<5>();
      break;
    case 4:
      f.template operator()<4>();
      break;
    case 3:
      f.template operator()<3>();
      break;
    case 2:
      f.template operator()<2>();
      break;
    default:
      f.template operator()<1>();
      break;
  }
}

template <class P, int Lanes = P::size>
void forward_supernode(const SupernodalFactor& F, const Supernode& s, double* x,
                       const Packs<P, Lanes>& packs = {}) {
  double* columns = row_of<Lanes>(x, s.first_column);
  const double* L = F.value.data() + s.value_offset;
  for (int first = 0; first < s.column_count; first += kPanelRows) {
    const int height = std::min(kPanelRows, s.column_count - first);
    with_height(height, [&]<int H>() {
      packs.each([&](int lane) { ForwardPanel<P, Lanes, H>::diagonal(L, columns + lane, first); });
    });
    L += static_cast<std::size_t>(height) * (first + height);
  }
  L = F.value.data() + s.below_offset;
  const int* rows = F.row.data() + s.row_offset;
  for (int first = 0; first < s.row_count; first += kPanelRows) {
    const int height = std::min(kPanelRows, s.row_count - first);
    with_height(height, [&]<int H>() {
      packs.each([&](int lane) {
        ForwardPanel<P, Lanes, H>::below(L, columns + lane, s.column_count, rows + first, x + lane);
      });
    });
    L += static_cast<std::size_t>(height) * s.column_count;
  }
}

template <class P, int Width>
struct BackwardColumns {
  /// acc[c] -= sum_r L[r, c] x[r] over one panel of `height` rows; L points at (row 0, column c = 0).
  template <int Height, class RowAddress>
  static void panel(const double* L, RowAddress&& address, P (&acc)[Width]) {
    for (int r = 0; r < Height; ++r) {
      const P xr = P::load(address(r));
      for (int c = 0; c < Width; ++c) acc[c] -= P(L[c * Height + r]) * xr;
    }
  }
};

/// x_k -= sum_r L[r, k] x[r] for the columns k of a panel of rows below the diagonal, the rows held in registers.
template <class P, int Lanes, int Height>
void subtract_below(const double* L, int columns, const int* rows, double* x_columns, const double* x) {
  P xr[Height];
  for (int r = 0; r < Height; ++r) xr[r] = P::load(row_of<Lanes>(x, rows[r]));
  for (int k = 0; k < columns; ++k) {
    double* const xk = row_of<Lanes>(x_columns, k);
    P acc = P::load(xk);
    for (int r = 0; r < Height; ++r) acc -= P(L[r]) * xr[r];
    acc.store(xk);
    L += Height;
  }
}

/// One pack of lanes of the block of `Width` columns of the triangle that begins at `first`, once all rows below
/// the triangle are subtracted. @param columns first row of the pack in the supernode
template <class P, int Lanes, int Width>
void backward_columns(const double* diagonal, int column_count, int first, double* columns) {
  P acc[Width];
  for (int c = 0; c < Width; ++c) acc[c] = P::load(row_of<Lanes>(columns, first + c));
  for (int p = first + Width; p < column_count; p += kPanelRows) {
    with_height(std::min(kPanelRows, column_count - p), [&]<int H>() {
      const double* L = diagonal + diagonal_panel_offset(p) + static_cast<std::size_t>(first) * H;
      BackwardColumns<P, Width>::template panel<H>(
          L, [&](int i) { return row_of<Lanes>(columns, p + i); }, acc);
    });
  }
  const double* T = diagonal + diagonal_panel_offset(first) + static_cast<std::size_t>(first) * Width;
#pragma GCC unroll 6
  for (int k = Width - 1; k >= 0; --k) {
    acc[k] = acc[k] * P(T[k * Width + k]);
#pragma GCC unroll 6
    for (int c = 0; c < k; ++c) acc[c] -= P(T[c * Width + k]) * acc[k];
    acc[k].store(row_of<Lanes>(columns, first + k));
  }
}

template <class P, int Lanes = P::size>
void backward_supernode(const SupernodalFactor& F, const Supernode& s, double* x,
                        const Packs<P, Lanes>& packs = {}) {
  double* columns = row_of<Lanes>(x, s.first_column);
  const double* L = F.value.data() + s.below_offset;
  const int* rows = F.row.data() + s.row_offset;
  // Panel after panel as they lie in memory: each entry of L and each row of x is read once.
  for (int first = 0; first < s.row_count; first += kPanelRows) {
    const int height = std::min(kPanelRows, s.row_count - first);
    with_height(height, [&]<int H>() {
      packs.each([&](int lane) {
        subtract_below<P, Lanes, H>(L, s.column_count, rows + first, columns + lane, x + lane);
      });
    });
    L += static_cast<std::size_t>(height) * s.column_count;
  }
  const double* diagonal = F.value.data() + s.value_offset;
  const auto block = [&]<int W>(int first) {
    packs.each([&](int lane) { backward_columns<P, Lanes, W>(diagonal, s.column_count, first, columns + lane); });
  };
  const int tail = s.column_count % kPanelRows;
  int first = s.column_count - tail;
  if (tail > 0) with_height(tail, [&]<int W>() { block.template operator()<W>(first); });
  for (first -= kPanelRows; first >= 0; first -= kPanelRows) block.template operator()<kPanelRows>(first);
}

}  // namespace unbruised::kernels
