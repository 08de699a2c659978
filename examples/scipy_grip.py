"""SciPy looks for the grip force that holds a block with a reserve of 20 %; the closed form is 1.2 m (g + a) / (2 mu)."""
# %%
from scipy.optimize import brentq

import unbruised as ub

study = ub.load("configs/hold_limit.toml", {"product.cell_size_m": 0.025})
study.strategy.lift_acceleration_m_s2 = 1.0


def reserve(force_N):
    return float(ub.evaluate(study, [{"strategy.grip_force_N": force_N}]).friction_margin_min[0]) - 0.2


# %%
force_N = brentq(reserve, 0.95, 4.0, xtol=0.005)
block = study.resolved["product"]
closed_form_N = 1.2 * block["mass_kg"] * (9.81 + 1.0) / (2 * block["friction"])
print(f"set {force_N:.2f} N; 1.2 m (g + a) / (2 mu) = {closed_form_N:.2f} N")
assert 0.99 < force_N / closed_form_N < 1.10  # the lift begins with a jerk, which stretches the pads and costs some margin
