"""SciPy looks for the least grip force that holds a block; the closed form is m (g + a) / (2 mu)."""
# %%
from scipy.optimize import brentq

import unbruised as ub

study = ub.load("configs/hold_limit.toml", {"product.cell_size_m": 0.025})
study.strategy.lift_acceleration_m_s2 = 1.0


def margin(force_N):
    return float(ub.evaluate(study, [{"strategy.grip_force_N": force_N}]).friction_margin_min[0])


# %%
block = study.resolved["product"]
least_N = brentq(margin, 1.0, 6.0, xtol=0.02)
closed_form_N = block["mass_kg"] * (9.81 + 1.0) / (2 * block["friction"])
print(f"holds from {least_N:.2f} N on; m (g + a) / (2 mu) = {closed_form_N:.2f} N")
assert abs(least_N / closed_form_N - 1) < 0.1
