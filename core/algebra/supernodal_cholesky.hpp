#pragma once

/// @file
/// The factor of a body's effective stiffness, made where it is used: supernode by supernode, in the layout of the
/// lane solve. CHOLMOD orders. (Of its own factorisations the supernodal one calls whatever BLAS a machine has,
/// with other bits on each, and is under the GPL; the simplicial one takes two to four times as long:
/// `SparseCholesky`.)

#include <optional>
#include <string>

#include "core/algebra/sparse_cholesky.hpp"
#include "core/algebra/supernodes.hpp"

namespace unbruised {

/// Orders, factors and packs. The same bits for any thread count and vector width: each entry of L is one chain of
/// fused c -= a * b in the order of the columns within a supernode, children before parents (Duff and Reid 1983,
/// doi 10.1145/356044.356047: the multifrontal method).
/// @return nothing, with `error` set, when the matrix is not positive definite or memory is short.
/// @throw std::logic_error when it is no such matrix
std::optional<SupernodalFactor> factor_supernodes(const SymmetricMatrix& matrix, std::string& error);

/// The same without ordering: of matrices that are full.
std::optional<SupernodalFactor> factor_as_it_stands(const SymmetricMatrix& matrix, std::string& error);

}  // namespace unbruised
