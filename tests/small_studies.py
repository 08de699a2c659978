"""Studies that take no time, for tests in Python."""


def masses(duration_s, count):
    """A mass on a spring, of so many stiffnesses: a second of it takes some tenths of a millisecond."""
    return f"""[study]
name = "masses"
kind = "sweep"
[product]
kind = "network"
[[product.particle]]
position_m = [0.0, 0.0, 0.0]
fixed = ["x", "y", "z"]
[[product.particle]]
position_m = [1.0, 0.0, 0.0]
mass_kg = 2.0
fixed = ["y", "z"]
initial_displacement_m = [0.01, 0.0, 0.0]
[[product.spring]]
between = [0, 1]
stiffness_N_m = 50.0
[simulation]
time_step_s = 0.01
duration_s = {duration_s}
[cell]
gravity_m_s2 = [0.0, 0.0, 0.0]
support = false
[[vary]]
key = "product.spring[0].stiffness_N_m"
from = 40.0
to = 60.0
count = {count}
"""
