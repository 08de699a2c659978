"""What a kiwi feels while it is picked: one scenario over time, and the balance of its forces."""
# %%
import numpy as np

import unbruised as ub

study = ub.load("configs/kiwi_first.toml", {"product.cell_size_m": 0.01, "strategy.approach_speed_m_s": 0.1})
trace = ub.simulate(study, {"strategy.grip_force_N": 2.0})
print(f"{trace.outcome}, {trace.sizes['time_s']} rows of {len(trace.data_vars)} signals")

# %% What the two fingers press with, across the waist (x); they press alike.
fingers_N = trace.finger_force_N.isel(component=0).to_numpy()
print(f"peaks {abs(fingers_N).max(axis=0).round(2)} N, impulse balance within {trace.impulse_balance_error:.1e}")

# %% A gripper with heavier fingers bumps harder.
study.gripper = ub.Gripper("grippers/parallel_jaw.toml", finger_mass_kg=0.3)
heavier = ub.simulate(study, {"strategy.grip_force_N": 2.0})
print(f"peak with 0.3 kg fingers {np.abs(heavier.finger_force_N).max().item():.2f} N: {heavier.outcome}")
