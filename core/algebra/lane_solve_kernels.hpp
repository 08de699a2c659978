#pragma once

/// @file
/// The triangular solves of a supernode for all lanes at once, over any pack type `P` (one value per lane).
/// Forward: x_c = L_cc^-1 x_c, x_r -= L_rc x_c. Backward: x_c = L_cc^-T (x_c - L_rc' x_r).
/// `P` needs: P::Number, double or float; P::load(const Number*), store(Number*), P = Number broadcast, *, and
/// `x -= a * b`.
///
/// A row of x is `Lanes` wide, one or several packs. Where it is several, each panel of L is gone through once for
/// each of them while it is in the first cache: the accumulators of a panel of six rows are to stay in registers.
/// No lane's arithmetic depends on that. Packs of one register (`P::kIsPaired`) take two panels at a time: six
/// sums are too few to hide the latency of a multiply-add.

#include <algorithm>
#include <cstddef>

#include "core/algebra/supernodes.hpp"
#include "core/lanes/lane_packs.hpp"

namespace unbruised::kernels {

template <class P>
using NumberOf = typename P::Number;

/// The row of x with this number.
template <int Lanes, class Number>
Number* row_of(Number* x, int row) {
  return x + static_cast<std::size_t>(row) * Lanes;
}

template <class P, int Lanes, int Height>
struct ForwardPanel {
  using Number = NumberOf<P>;

  /// acc[r] -= sum_k L[r, k] x[k] for one panel, k in [0, columns).
  static void update(const Number* L, const Number* x, int columns, P (&acc)[Height]) {
    for (int k = 0; k < columns; ++k) {
      const P xk = P::load(row_of<Lanes>(x, k));
      for (int r = 0; r < Height; ++r) acc[r] -= P(L[r]) * xk;
      L += Height;
    }
  }
  /// Diagonal panel: columns before it, then its own triangle (reciprocals on the diagonal).
  static void diagonal(const Number* L, Number* x, int first) {
    P acc[Height];
    Number* own = row_of<Lanes>(x, first);
    for (int r = 0; r < Height; ++r) acc[r] = P::load(row_of<Lanes>(own, r));
    update(L, x, first, acc);
    const Number* T = L + static_cast<std::size_t>(first) * Height;
#pragma GCC unroll 6  // so that they stay in registers here too
    for (int k = 0; k < Height; ++k) {
      acc[k] = acc[k] * P(T[k * Height + k]);
#pragma GCC unroll 6
      for (int r = k + 1; r < Height; ++r) acc[r] -= P(T[k * Height + r]) * acc[k];
      acc[k].store(row_of<Lanes>(own, k));
    }
  }
  static void below(const Number* L, const Number* x_columns, int columns, const int* rows, Number* x) {
    P acc[Height];
    for (int r = 0; r < Height; ++r) acc[r] = P::load(row_of<Lanes>(x, rows[r]));
    update(L, x_columns, columns, acc);
    for (int r = 0; r < Height; ++r) acc[r].store(row_of<Lanes>(x, rows[r]));
  }
};

/// Two neighbouring panels, the second of `Second` rows.
template <class P, int Lanes, int Second>
struct ForwardPair {
  using Number = NumberOf<P>;
  static constexpr int kRows = kPanelRows + Second;

  static void update(const Number* L, const Number* L2, const Number* x, int columns, P (&acc)[kRows]) {
    for (int k = 0; k < columns; ++k) {
      const P xk = P::load(row_of<Lanes>(x, k));
      for (int r = 0; r < kPanelRows; ++r) acc[r] -= P(L[r]) * xk;
      for (int r = 0; r < Second; ++r) acc[kPanelRows + r] -= P(L2[r]) * xk;
      L += kPanelRows;
      L2 += Second;
    }
  }
  static void diagonal(const Number* L, Number* x, int first) {
    const Number* L2 = L + static_cast<std::size_t>(kPanelRows) * (first + kPanelRows);
    P acc[kRows];
    Number* own = row_of<Lanes>(x, first);
    for (int r = 0; r < kRows; ++r) acc[r] = P::load(row_of<Lanes>(own, r));
    update(L, L2, x, first, acc);
    const Number* T = L + static_cast<std::size_t>(first) * kPanelRows;
    const Number* beside = L2 + static_cast<std::size_t>(first) * Second;
#pragma GCC unroll 6
    for (int k = 0; k < kPanelRows; ++k) {
      acc[k] = acc[k] * P(T[k * kPanelRows + k]);
#pragma GCC unroll 6
      for (int r = k + 1; r < kPanelRows; ++r) acc[r] -= P(T[k * kPanelRows + r]) * acc[k];
#pragma GCC unroll 6
      for (int r = 0; r < Second; ++r) acc[kPanelRows + r] -= P(beside[k * Second + r]) * acc[k];
      acc[k].store(row_of<Lanes>(own, k));
    }
    const Number* T2 = beside + static_cast<std::size_t>(kPanelRows) * Second;
#pragma GCC unroll 6
    for (int k = 0; k < Second; ++k) {
      P& own_k = acc[kPanelRows + k];
      own_k = own_k * P(T2[k * Second + k]);
#pragma GCC unroll 6
      for (int r = k + 1; r < Second; ++r) acc[kPanelRows + r] -= P(T2[k * Second + r]) * own_k;
      own_k.store(row_of<Lanes>(own, kPanelRows + k));
    }
  }
  static void below(const Number* L, const Number* x_columns, int columns, const int* rows, Number* x) {
    P acc[kRows];
    for (int r = 0; r < kRows; ++r) acc[r] = P::load(row_of<Lanes>(x, rows[r]));
    update(L, L + static_cast<std::size_t>(kPanelRows) * columns, x_columns, columns, acc);
    for (int r = 0; r < kRows; ++r) acc[r].store(row_of<Lanes>(x, rows[r]));
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

/// Goes through `rows` rows by panels, two at a time where packs are paired: calls `one.operator()<H>(first)` and
/// `two.operator()<H>(first)` with the height of the last panel it is about.
template <class P, class One, class Two>
inline void each_panel(int rows, One&& one, Two&& two) {
  int first = 0;
  if constexpr (P::kIsPaired) {
    for (; rows - first > kPanelRows; first += 2 * kPanelRows) {
      with_height(std::min(kPanelRows, rows - first - kPanelRows),
                  [&]<int H>() { two.template operator()<H>(first); });
    }
  }
  for (; first < rows; first += kPanelRows) {
    with_height(std::min(kPanelRows, rows - first), [&]<int H>() { one.template operator()<H>(first); });
  }
}

template <class P, int Lanes = P::size>
void forward_supernode(const SupernodalFactor& F, const Supernode& s, NumberOf<P>* x,
                       const Packs<P, Lanes>& packs = {}) {
  NumberOf<P>* columns = row_of<Lanes>(x, s.first_column);
  const NumberOf<P>* const diagonal = values_of<NumberOf<P>>(F) + s.value_offset;
  each_panel<P>(
      s.column_count,
      [&]<int H>(int first) {
        const NumberOf<P>* L = diagonal + diagonal_panel_offset(first);
        packs.each([&](int lane) { ForwardPanel<P, Lanes, H>::diagonal(L, columns + lane, first); });
      },
      [&]<int H>(int first) {
        const NumberOf<P>* L = diagonal + diagonal_panel_offset(first);
        packs.each([&](int lane) { ForwardPair<P, Lanes, H>::diagonal(L, columns + lane, first); });
      });
  const NumberOf<P>* const below = values_of<NumberOf<P>>(F) + s.below_offset;
  const int* rows = F.row.data() + s.row_offset;
  const auto panel = [&](int first) { return below + static_cast<std::size_t>(first) * s.column_count; };
  each_panel<P>(
      s.row_count,
      [&]<int H>(int first) {
        packs.each([&](int lane) {
          ForwardPanel<P, Lanes, H>::below(panel(first), columns + lane, s.column_count, rows + first, x + lane);
        });
      },
      [&]<int H>(int first) {
        packs.each([&](int lane) {
          ForwardPair<P, Lanes, H>::below(panel(first), columns + lane, s.column_count, rows + first, x + lane);
        });
      });
}

template <class P, int Width>
struct BackwardColumns {
  using Number = NumberOf<P>;

  /// acc[c] -= sum_r L[r, c] x[r] over one panel of `height` rows; L points at (row 0, column c = 0).
  template <int Height, class RowAddress>
  static void panel(const Number* L, RowAddress&& address, P (&acc)[Width]) {
    for (int r = 0; r < Height; ++r) {
      const P xr = P::load(address(r));
      for (int c = 0; c < Width; ++c) acc[c] -= P(L[c * Height + r]) * xr;
    }
  }
};

/// x_k -= sum_r L[r, k] x[r] for the columns k of a panel of rows below the diagonal, the rows held in registers.
template <class P, int Lanes, int Height>
void subtract_below(const NumberOf<P>* L, int columns, const int* rows, NumberOf<P>* x_columns,
                    const NumberOf<P>* x) {
  P xr[Height];
  for (int r = 0; r < Height; ++r) xr[r] = P::load(row_of<Lanes>(x, rows[r]));
  for (int k = 0; k < columns; ++k) {
    NumberOf<P>* const xk = row_of<Lanes>(x_columns, k);
    P acc = P::load(xk);
    for (int r = 0; r < Height; ++r) acc -= P(L[r]) * xr[r];
    acc.store(xk);
    L += Height;
  }
}

/// The same for two panels, the second of `Second` rows.
template <class P, int Lanes, int Second>
void subtract_two_below(const NumberOf<P>* L, int columns, const int* rows, NumberOf<P>* x_columns,
                        const NumberOf<P>* x) {
  const NumberOf<P>* L2 = L + static_cast<std::size_t>(kPanelRows) * columns;
  P xr[kPanelRows + Second];
  for (int r = 0; r < kPanelRows + Second; ++r) xr[r] = P::load(row_of<Lanes>(x, rows[r]));
  for (int k = 0; k < columns; ++k) {
    NumberOf<P>* const xk = row_of<Lanes>(x_columns, k);
    P acc = P::load(xk);
    for (int r = 0; r < kPanelRows; ++r) acc -= P(L[r]) * xr[r];
    for (int r = 0; r < Second; ++r) acc -= P(L2[r]) * xr[kPanelRows + r];
    acc.store(xk);
    L += kPanelRows;
    L2 += Second;
  }
}

/// One pack of lanes of the block of `Width` columns of the triangle that begins at `first`, once all rows below
/// the triangle are subtracted. @param columns first row of the pack in the supernode
template <class P, int Lanes, int Width>
void backward_columns(const NumberOf<P>* diagonal, int column_count, int first, NumberOf<P>* columns) {
  P acc[Width];
  for (int c = 0; c < Width; ++c) acc[c] = P::load(row_of<Lanes>(columns, first + c));
  for (int p = first + Width; p < column_count; p += kPanelRows) {
    with_height(std::min(kPanelRows, column_count - p), [&]<int H>() {
      const NumberOf<P>* L = diagonal + diagonal_panel_offset(p) + static_cast<std::size_t>(first) * H;
      BackwardColumns<P, Width>::template panel<H>(
          L, [&](int i) { return row_of<Lanes>(columns, p + i); }, acc);
    });
  }
  const NumberOf<P>* T = diagonal + diagonal_panel_offset(first) + static_cast<std::size_t>(first) * Width;
#pragma GCC unroll 6
  for (int k = Width - 1; k >= 0; --k) {
    acc[k] = acc[k] * P(T[k * Width + k]);
#pragma GCC unroll 6
    for (int c = 0; c < k; ++c) acc[c] -= P(T[c * Width + k]) * acc[k];
    acc[k].store(row_of<Lanes>(columns, first + k));
  }
}

/// Two neighbouring blocks of `kPanelRows` columns.
template <class P, int Lanes>
void backward_two_blocks(const NumberOf<P>* diagonal, int column_count, int first, NumberOf<P>* columns) {
  constexpr int kTwo = 2 * kPanelRows;
  P acc[kTwo];
  for (int c = 0; c < kTwo; ++c) acc[c] = P::load(row_of<Lanes>(columns, first + c));
  for (int p = first + kTwo; p < column_count; p += kPanelRows) {
    with_height(std::min(kPanelRows, column_count - p), [&]<int H>() {
      const NumberOf<P>* L = diagonal + diagonal_panel_offset(p) + static_cast<std::size_t>(first) * H;
      BackwardColumns<P, kTwo>::template panel<H>(
          L, [&](int i) { return row_of<Lanes>(columns, p + i); }, acc);
    });
  }
  const int second = first + kPanelRows;
  const NumberOf<P>* beside =
      diagonal + diagonal_panel_offset(second) + static_cast<std::size_t>(first) * kPanelRows;
  const NumberOf<P>* T2 = beside + kPanelRows * kPanelRows;
#pragma GCC unroll 6
  for (int k = kPanelRows - 1; k >= 0; --k) {
    P& own = acc[kPanelRows + k];
    own = own * P(T2[k * kPanelRows + k]);
#pragma GCC unroll 6
    for (int c = 0; c < k; ++c) acc[kPanelRows + c] -= P(T2[c * kPanelRows + k]) * own;
#pragma GCC unroll 6
    for (int c = 0; c < kPanelRows; ++c) acc[c] -= P(beside[c * kPanelRows + k]) * own;
    own.store(row_of<Lanes>(columns, second + k));
  }
  const NumberOf<P>* T = diagonal + diagonal_panel_offset(first) + static_cast<std::size_t>(first) * kPanelRows;
#pragma GCC unroll 6
  for (int k = kPanelRows - 1; k >= 0; --k) {
    acc[k] = acc[k] * P(T[k * kPanelRows + k]);
#pragma GCC unroll 6
    for (int c = 0; c < k; ++c) acc[c] -= P(T[c * kPanelRows + k]) * acc[k];
    acc[k].store(row_of<Lanes>(columns, first + k));
  }
}

template <class P, int Lanes = P::size>
void backward_supernode(const SupernodalFactor& F, const Supernode& s, NumberOf<P>* x,
                        const Packs<P, Lanes>& packs = {}) {
  NumberOf<P>* columns = row_of<Lanes>(x, s.first_column);
  const NumberOf<P>* L = values_of<NumberOf<P>>(F) + s.below_offset;
  const int* rows = F.row.data() + s.row_offset;
  // Panel after panel as they lie in memory: each entry of L and each row of x is read once.
  const auto panel = [&](int first) { return L + static_cast<std::size_t>(first) * s.column_count; };
  each_panel<P>(
      s.row_count,
      [&]<int H>(int first) {
        packs.each([&](int lane) {
          subtract_below<P, Lanes, H>(panel(first), s.column_count, rows + first, columns + lane, x + lane);
        });
      },
      [&]<int H>(int first) {
        packs.each([&](int lane) {
          subtract_two_below<P, Lanes, H>(panel(first), s.column_count, rows + first, columns + lane, x + lane);
        });
      });
  const NumberOf<P>* diagonal = values_of<NumberOf<P>>(F) + s.value_offset;
  const auto block = [&]<int W>(int first) {
    packs.each([&](int lane) { backward_columns<P, Lanes, W>(diagonal, s.column_count, first, columns + lane); });
  };
  const int tail = s.column_count % kPanelRows;
  int first = s.column_count - tail;
  if (tail > 0) with_height(tail, [&]<int W>() { block.template operator()<W>(first); });
  if constexpr (P::kIsPaired) {
    for (; first >= 2 * kPanelRows; first -= 2 * kPanelRows) {
      packs.each([&](int lane) {
        backward_two_blocks<P, Lanes>(diagonal, s.column_count, first - 2 * kPanelRows, columns + lane);
      });
    }
  }
  for (first -= kPanelRows; first >= 0; first -= kPanelRows) block.template operator()<kPanelRows>(first);
}

}  // namespace unbruised::kernels
