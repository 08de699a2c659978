#pragma once

/// @file
/// The triangular solves of a supernode for all lanes at once, over any pack type `P` (one value per lane).
/// Forward: x_c = L_cc^-1 x_c, x_r -= L_rc x_c. Backward: x_c = L_cc^-T (x_c - L_rc' x_r).
/// `P` needs: P::load(const double*), store(double*), P = double broadcast, -, *, and `x -= a * b`.

#include <algorithm>
#include <cstddef>

#include "core/algebra/supernodes.hpp"

namespace unbruised::kernels {

template <class P, int Height>
struct ForwardPanel {
  /// acc[r] -= sum_k L[r, k] x[k] for one panel, k in [0, columns).
  static void update(const double* L, const double* x, int columns, P (&acc)[Height]) {
    for (int k = 0; k < columns; ++k) {
      const P xk = P::load(x + static_cast<std::size_t>(k) * P::size);
      for (int r = 0; r < Height; ++r) acc[r] -= P(L[r]) * xk;
      L += Height;
    }
  }
  /// Diagonal panel: columns before it, then its own triangle (reciprocals on the diagonal).
  static void diagonal(const double* L, double* x, int first) {
    P acc[Height];
    double* own = x + static_cast<std::size_t>(first) * P::size;
    for (int r = 0; r < Height; ++r) acc[r] = P::load(own + static_cast<std::size_t>(r) * P::size);
    update(L, x, first, acc);
    const double* T = L + static_cast<std::size_t>(first) * Height;
    for (int k = 0; k < Height; ++k) {
      acc[k] = acc[k] * P(T[k * Height + k]);
      for (int r = k + 1; r < Height; ++r) acc[r] -= P(T[k * Height + r]) * acc[k];
      acc[k].store(own + static_cast<std::size_t>(k) * P::size);
    }
  }
  static void below(const double* L, const double* x_columns, int columns, const int* rows, double* x) {
    P acc[Height];
    for (int r = 0; r < Height; ++r) acc[r] = P::load(x + static_cast<std::size_t>(rows[r]) * P::size);
    update(L, x_columns, columns, acc);
    for (int r = 0; r < Height; ++r) acc[r].store(x + static_cast<std::size_t>(rows[r]) * P::size);
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

template <class P>
void forward_supernode(const SupernodalFactor& F, const Supernode& s, double* x) {
  double* columns = x + static_cast<std::size_t>(s.first_column) * P::size;
  const double* L = F.value.data() + s.value_offset;
  for (int first = 0; first < s.column_count; first += kPanelRows) {
    const int height = std::min(kPanelRows, s.column_count - first);
    with_height(height, [&]<int H>() { ForwardPanel<P, H>::diagonal(L, columns, first); });
    L += static_cast<std::size_t>(height) * (first + height);
  }
  L = F.value.data() + s.below_offset;
  const int* rows = F.row.data() + s.row_offset;
  for (int first = 0; first < s.row_count; first += kPanelRows) {
    const int height = std::min(kPanelRows, s.row_count - first);
    with_height(height, [&]<int H>() { ForwardPanel<P, H>::below(L, columns, s.column_count, rows + first, x); });
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

/// One block of `Width` columns starting at `first` of supernode `s`.
template <class P, int Width>
void backward_columns(const SupernodalFactor& F, const Supernode& s, int first, double* x) {
  double* columns = x + static_cast<std::size_t>(s.first_column) * P::size;
  P acc[Width];
  for (int c = 0; c < Width; ++c) acc[c] = P::load(columns + static_cast<std::size_t>(first + c) * P::size);
  const int* rows = F.row.data() + s.row_offset;
  const double* below = F.value.data() + s.below_offset;
  int r = 0;
  for (; r + kPanelRows <= s.row_count; r += kPanelRows) {
    const double* L =
        below + static_cast<std::size_t>(r) * s.column_count + static_cast<std::size_t>(first) * kPanelRows;
    BackwardColumns<P, Width>::template panel<kPanelRows>(
        L, [&](int i) { return x + static_cast<std::size_t>(rows[r + i]) * P::size; }, acc);
  }
  if (r < s.row_count) {
    with_height(s.row_count - r, [&]<int H>() {
      const double* L = below + static_cast<std::size_t>(r) * s.column_count + static_cast<std::size_t>(first) * H;
      BackwardColumns<P, Width>::template panel<H>(
          L, [&](int i) { return x + static_cast<std::size_t>(rows[r + i]) * P::size; }, acc);
    });
  }
  const double* diagonal = F.value.data() + s.value_offset;
  for (int p = first + Width; p < s.column_count; p += kPanelRows) {
    with_height(std::min(kPanelRows, s.column_count - p), [&]<int H>() {
      const double* L = diagonal + diagonal_panel_offset(p) + static_cast<std::size_t>(first) * H;
      BackwardColumns<P, Width>::template panel<H>(
          L, [&](int i) { return columns + static_cast<std::size_t>(p + i) * P::size; }, acc);
    });
  }
  const double* T = diagonal + diagonal_panel_offset(first) + static_cast<std::size_t>(first) * Width;
  for (int k = Width - 1; k >= 0; --k) {
    acc[k] = acc[k] * P(T[k * Width + k]);
    for (int c = 0; c < k; ++c) acc[c] -= P(T[c * Width + k]) * acc[k];
    acc[k].store(columns + static_cast<std::size_t>(first + k) * P::size);
  }
}

template <class P>
void backward_supernode(const SupernodalFactor& F, const Supernode& s, double* x) {
  const int tail = s.column_count % kPanelRows;
  int first = s.column_count - tail;
  if (tail > 0) with_height(tail, [&]<int W>() { backward_columns<P, W>(F, s, first, x); });
  for (first -= kPanelRows; first >= 0; first -= kPanelRows) backward_columns<P, kPanelRows>(F, s, first, x);
}

}  // namespace unbruised::kernels
