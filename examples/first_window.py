"""How hard may a ripe kiwi be gripped? A sweep of forces and speeds, as a table. Cells (# %%) run one by one in editors that know them."""
# %%
import sys

import unbruised as ub

study = ub.load("configs/kiwi_first.toml", {"study.name": "kiwi_from_python"})
study.product.cell_size_m = 0.01  # coarse: seconds, to look at first
cost = study.check()
print(f"{cost['scenarios']:.0f} scenarios, about {cost['seconds']:.0f} s on {cost['threads']} threads")

# %% In the folder given, or results/kiwi_from_python; a run that is there already is looked at, not run again.
results = study.run(sys.argv[1] if len(sys.argv) > 1 else None)
scenarios = results.to_dataframe()

# %% Outcomes over force and speed.
print(scenarios.pivot(index="strategy.grip_force_N", columns="strategy.approach_speed_m_s", values="outcome"))

# %% The same as windows: what holds, what bruises.
print(results.table("window")[["strategy.approach_speed_m_s", "hold_force_N", "damage_force_N", "exists"]])
