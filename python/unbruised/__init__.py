"""Finds how a gripper may handle a delicate product: studies, single scenarios and many in lanes, from Python.

    import unbruised as ub

    study = ub.load("configs/kiwi_first.toml")
    study.check()                                   # what it will cost, and warnings
    results = study.run("results/kiwi_first")       # a run directory, as `unbruised run` makes it
    results.scenarios                               # xarray.Dataset; results.to_dataframe() for pandas

    trace = ub.simulate(study, {"strategy.grip_force_N": 2.0})          # one scenario over time
    table = ub.evaluate(study, [{"strategy.grip_force_N": 1.0}, {"strategy.grip_force_N": 2.0}])

SI units everywhere; the unit stands in each name.
"""
from ._errors import ConfigError, Problem, RunError
from ._objects import Gripper, Product, Table
from ._results import Results, open_results
from ._study import Progress, Study, evaluate, load, simulate
from ._unbruised import __version__, explain, numeric_build

__all__ = ["ConfigError", "Gripper", "Problem", "Product", "Progress", "Results", "RunError", "Study", "Table", "__version__",
           "evaluate", "explain", "load", "numeric_build", "open_results", "simulate"]
