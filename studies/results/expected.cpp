#include "studies/results/expected.hpp"

namespace unbruised::studies {

int exit_status(ResultsErrorKind kind) {
  switch (kind) {
    case ResultsErrorKind::io:
      return 5;
    case ResultsErrorKind::busy:
      return 4;
    case ResultsErrorKind::damaged:
      return 6;
    case ResultsErrorKind::finished:
    case ResultsErrorKind::other_config:
    case ResultsErrorKind::other_build:
    case ResultsErrorKind::foreign:
    case ResultsErrorKind::not_built:
      return 2;
  }
  return 1;
}

}  // namespace unbruised::studies
