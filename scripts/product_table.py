#!/usr/bin/python3
"""usage: scripts/product_table.py [--check | --run [PROGRAM]]

Writes the tables of docs/products.md: the products of configs/products, and what published experiments on them give in
simulation. --run runs the studies of these experiments first (PROGRAM: build/release/unbruised; results in results/) and
files what came out in docs/products.csv. --check writes nothing and fails where the page is not what files and CSV say.
"""
import csv
import math
import pathlib
import subprocess
import sys
import tomllib

from library_pages import is_assumed, settle

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE, RECORD = ROOT / "docs/products.md", ROOT / "docs/products.csv"
PRODUCTS, EXPERIMENTS = "products", "experiments"


# --- the products ---

def read(path):
    with path.open("rb") as file:
        return tomllib.load(file)


def source(product, key):
    """Where a value comes from; limits may share one line."""
    sources = product.get("source", {})
    return sources.get(key, sources.get("limits", "") if key.startswith("limits_") else "")


def shown(product, key, text):
    return f"({text})" if is_assumed(source(product, key)) else text


def digits(value):
    return f"{float(f'{value:.3g}'):g}"


def volume_m3(product):
    x, y, z = product["size_m"]
    return x * y * z * {"box": 1.0, "cylinder": math.pi / 4, "sphere": math.pi / 6, "ellipsoid": math.pi / 6}[product["shape"]]


def mass(product):
    if "mass_kg" in product:
        return shown(product, "mass_kg", digits(1e3 * product["mass_kg"]))
    return shown(product, "density_kg_m3", digits(1e3 * product["density_kg_m3"] * volume_m3(product)))


def deviation(product, key):
    """Standard deviation that studies draw with; None where the file gives none."""
    drawn = [random for random in product.get("random", []) if random["key"] == f"product.{key}"]
    return drawn[0].get("standard_deviation") if drawn else None


def modulus(product, key):
    if key not in product:
        return ""
    spread = deviation(product, key)
    return shown(product, key, digits(product[key] / 1e3) + (f" ± {digits(spread / 1e3)}" if spread else ""))


def time_dependent(product):
    if "prony_modulus" in product:
        return f"relaxes, {len(product['prony_modulus'])} terms"
    return "flows and recovers" if "burgers_flow_time_s" in product else ""


def limit(product):
    """The limit of damage that a study meets first, in words."""
    limits = product.get("limits", {})
    if "finger_force_N" in limits:
        return shown(product, "limits_finger_force_N", f"{limits['finger_force_N']:g} N on a finger")
    if "yield_stress_Pa" in product:
        return "first yield" if "contact_yield_ratio" in limits else "permanent set, energy"
    return "permanent set" if "permanent_set_m" in limits else "none"


def product_row(path):
    product = read(path)
    size = " x ".join(digits(1e3 * length) for length in product["size_m"]) if "size_m" in product else "of its mesh"
    cells = [f"`{path.stem}`", product["shape"], shown(product, "size_m", size), mass(product), modulus(product, "youngs_modulus_Pa"),
             shown(product, "poisson_ratio", f"{product['poisson_ratio']:g}"), modulus(product, "yield_stress_Pa"),
             modulus(product, "tangent_modulus_Pa"), time_dependent(product), shown(product, "friction", f"{product['friction']:g}"),
             limit(product)]
    return "| " + " | ".join(cells) + " |"


def product_sources(path):
    product = read(path)
    cited = {}
    for key, text in product.get("source", {}).items():
        if not is_assumed(text):
            cited.setdefault(text, []).append(f"`{key}`")
    return [f"- `{path.stem}`: {product['description']}"] + [f"  - {', '.join(keys)}: {text}" for text, keys in cited.items()]


def products():
    files = sorted((ROOT / "configs/products").glob("*.toml"))
    head = ["| file | shape | size, mm | mass, g | E, kPa | nu | yield, kPa | tangent, kPa | in time | friction | damage by |",
            "|---|---|---|---|---|---|---|---|---|---|---|"]
    rows = head + [product_row(path) for path in files]
    return "\n".join(rows + ["", "Where the numbers without brackets come from:", ""] + [line for path in files for line in product_sources(path)])


# --- the experiments ---

def window(study, row, column):
    import h5py  # only where results are read
    with h5py.File(ROOT / "results" / study / "results.h5", "r") as file:
        return float(file["window"][column][row])


def metric(study, row, name):
    import h5py
    with h5py.File(ROOT / "results" / study / "results.h5", "r") as file:
        return float(file["scenarios/metric"][name][row])


def damage(row):
    return lambda: window("experiment_damage", row, "damage_force_N")


def foam(row):
    return lambda: window("apple_pads", row, "damage_force_N") / window("apple_pads", 0, "damage_force_N")


def waited(row):
    return lambda: window("carrot_held", row, "hold_force_N") / window("carrot_held", 0, "hold_force_N")


def closed(row):
    return lambda: 1e3 * metric("experiment_closure", row, "compression_max_m")


def bruise_mm2():
    return 1e6 * metric("kiwi_drop", 2, "bruised_area_m2")


def touched_mm2():
    """Hertz's patch (with the geometric mean of both radii) at the peak of the plate's force in the highest fall."""
    import h5py
    with h5py.File(ROOT / "results/kiwi_drop/scenario_2.h5", "r") as file:
        force = file["trace/surface_force_N"][:, -1, 2].max()
    product = read(ROOT / "configs/products/kiwi_layered.toml")
    radius = 0.5 * product["size_m"][1]  # it lies on its side, a b b: the radii b and a^2 / b have the mean a
    modulus = product["youngs_modulus_Pa"] / (1.0 - product["poisson_ratio"] ** 2)
    return 1e6 * math.pi * (0.75 * force * radius / modulus) ** (2.0 / 3.0)


def potato_ratio(name):
    """Of nine falls to one."""
    return lambda: metric("potato_impacts", 1, name) / metric("potato_impacts", 0, name)


def kiwi_stiffness():
    """Between 1 and 3 N."""
    return 2.0 / (closed(1)() - closed(0)())


SHEEP = "github.com/SheepLiu712/FruitRuptureEstimate, 40 specimens"
AGRONOMY = "Agronomy 2025, 15(10):2283 (review)"
FU = "Fu, He, Ma, Karkee et al., Jazz apple impact bruise responses to different cushioning materials"
MOLEMA = "Molema 1999, PhD Wageningen"
XIA = "Xia et al. 2021, Agriculture 11(6):471, its Prony terms"
KORLA = "doi 10.13427/j.cnki.njyi.2022.06.026"

# What was measured, unit, the number, what of it the model leaves open, source, study, how the simulated number is read.
TABLE = [
    ("kiwi, ripe: mean force that ruptures it between fingertips", "N", 3.61, "1.23 to 7.86 N, ripeness mixed; simulated: first yield", SHEEP,
     "experiment_damage", damage(0)),
    ("kiwi, ripe: mean stiffness of a grip", "N/mm", 1.58, "0.35 to 4.42 N/mm; simulated between plates, 1 to 3 N", SHEEP, "experiment_closure",
     kiwi_stiffness),
    ("kiwi, firm: force from which gripping damages", "N", 180, "about; patch and ripeness not given", AGRONOMY, "experiment_damage", damage(1)),
    ("kiwi, firm (Xuxiang): bruised area after 0.5 m onto steel", "mm2", 540.38, "their finite elements 592, with skin and core; simulated: flesh strained by 1 % and more, with both; the flesh gets to 1.07 of first yield",
     "Zhu et al. 2024, Foods 13(21):3523", "kiwi_drop", bruise_mm2),
    ("the same, against the area that touches the plate", "mm2", 540.38, "Hertz's patch at the simulated peak force: what was seen from outside is as large as what had touched, "
     "most of which stays below the bio-yield stress that was published with it", "Zhu et al. 2024, Foods 13(21):3523", "kiwi_drop", touched_mm2),
    ("potato, 0.6 J in nine impacts over the same in one: bruised volume", "", 0.36, "simulated: falls onto steel; each of the nine stays below first yield, which was taken from the energy at which damage begins",
     MOLEMA, "potato_impacts", potato_ratio("bruised_volume_m3")),
    ("the same: depth", "", 0.67, "", MOLEMA, "potato_impacts", potato_ratio("bruised_depth_m")),
    ("apple: force from which gripping damages", "N", 27.5, "15 to 40 N, middle taken; simulated between bare plates", AGRONOMY, "experiment_damage",
     damage(2)),
    ("apple, Red Fuji of 70 to 90 mm: least compression that damages", "N", 24.33, "", "Agriculture 2026, 16(2):178", "experiment_damage", damage(3)),
    ("apple, Jazz, 12.7 mm of foam of 2.1 kPa: largest force without bruise over bare aluminium", "", 95 / 22, "blows on free apples; simulated: grips",
     FU, "apple_pads", foam(1)),
    ("the same, foam of 4.8 kPa", "", 160 / 22, "", FU, "apple_pads", foam(2)),
    ("the same, foam of 9.7 to 11 kPa", "", 160 / 22, "", FU, "apple_pads", foam(3)),
    ("pear, Korla: least usable grasp force", "N", 0.53, "", KORLA, "experiment_hold", lambda: window("experiment_hold", 0, "hold_force_N")),
    ("pear, Korla: compression at the largest usable force, 35 N", "mm", 3.5, "an upper bound; its modulus is assumed", KORLA, "experiment_closure",
     closed(2)),
    ("peach: compression at 59.6 N between plates", "mm", 5.44, "from the printed 10.9 % of 50 mm; simulated: 66 mm",
     "Determination of Drop-Test Behavior of a Sample Peach Using Finite Element Method, Int. J. Food Properties", "experiment_closure", closed(3)),
    ("carrot, grip locked for 2 s: hold force over that of a grip held by force", "", 1 / 0.83, "", XIA, "carrot_held", waited(1)),
    ("the same, 5 s", "", 1 / 0.75, "", XIA, "carrot_held", waited(2)),
    ("the same, 60 s", "", 1 / 0.57, "", XIA, "carrot_held", waited(3)),
]


def run(program):
    for study in dict.fromkeys(entry[5] for entry in TABLE):
        subprocess.run([program, "run", ROOT / f"configs/{study}.toml", "--output", ROOT / "results" / study, "--quiet", "--no-replay"],
                       check=False, stdout=subprocess.DEVNULL)
    subprocess.run([program, "run", ROOT / "configs/kiwi_drop.toml", "--output", ROOT / "results/kiwi_drop", "--scenario", "2", "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)  # touched_mm2 reads its trace
    with RECORD.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["experiment", "published", "simulated", "unit", "study"])
        for name, unit, published, _, _, study, value in TABLE:
            writer.writerow([name, f"{published:.4g}", f"{value():.4g}", unit, study])


def experiments():
    with RECORD.open(encoding="utf-8", newline="") as file:
        simulated = {row["experiment"]: float(row["simulated"]) for row in csv.DictReader(file)}
    lines = ["| experiment | published | simulated | ratio | study | remarks | source |", "|---|---|---|---|---|---|---|"]
    for name, unit, published, remark, where, study, _ in TABLE:
        value = simulated[name]
        lines.append(f"| {name} | {digits(published)} {unit} | {digits(value)} {unit} | {value / published:.2f} | `{study}` | {remark} | {where} |")
    return "\n".join(lines)


# --- the page ---

def put(page, name, text):
    begin, end = f"<!-- made by scripts/product_table.py: {name} -->", f"<!-- end of {name} -->"
    before, rest = page.split(begin)
    return before + begin + "\n\n" + text + "\n\n" + end + rest.split(end)[1]


def main():
    options = sys.argv[1:]
    if options not in ([], ["--check"]) and options[:1] != ["--run"]:
        print(__doc__.strip(), file=sys.stderr if options != ["--help"] else sys.stdout)
        return 0 if options == ["--help"] else 2
    if options[:1] == ["--run"]:
        run(options[1] if len(options) > 1 else ROOT / "build/release/unbruised")
    page = PAGE.read_text(encoding="utf-8")
    wanted = put(put(page, PRODUCTS, products()), EXPERIMENTS, experiments())
    return settle(PAGE, wanted, options == ["--check"], "scripts/product_table.py")


if __name__ == "__main__":
    sys.exit(main())
