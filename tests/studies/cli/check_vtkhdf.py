"""usage: check_vtkhdf.py PROGRAM CONFIGS FOLDER: exports a scenario and reads it as VTK does.

Every table is looked at by VTKHDF's own rules; where Debian's python3-vtk9 is installed its reader opens the file too."""

import subprocess
import sys

import h5py
import numpy as np

program, configs, folder = sys.argv[1:4]
run = f"{folder}/run"
study = f"{configs}/hold.toml"


def call(*words):
    done = subprocess.run([program, *words], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


call("run", study, "-q", "--fresh", "--set", "strategy.hold_s=0.1", "--no-replay", "--output", run)
path = f"{folder}/motion.vtkhdf"
said = call("export", run, "--scenario", "0", "--format", "vtkhdf", "-o", path)
assert "motion: " in said, said

with h5py.File(path) as file:
    root = file["VTKHDF"]
    assert root.attrs["Type"] == b"UnstructuredGrid", root.attrs["Type"]
    assert tuple(root.attrs["Version"]) == (2, 0)
    assert root["Types"].dtype == np.uint8, "VTK's reader takes no other type"
    points, cells, ids = (int(root[name][0]) for name in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"))
    steps = int(root["Steps"].attrs["NSteps"])
    assert steps > 20, steps
    times = root["Steps/Values"][:]
    assert len(times) == steps and (np.diff(times) > 0).all()
    assert root["Points"].shape == (points * steps, 3)
    assert np.isfinite(root["Points"][:]).all()
    assert (root["Steps/PointOffsets"][:] == points * np.arange(steps)).all()
    offsets, connectivity, types = (root[name][:] for name in ("Offsets", "Connectivity", "Types"))
    assert len(offsets) == cells + 1 and offsets[0] == 0 and offsets[-1] == ids == len(connectivity)
    assert connectivity.min() == 0 and connectivity.max() == points - 1
    corners = {1: 1, 3: 2, 5: 3, 9: 4}
    assert (np.diff(offsets) == [corners[kind] for kind in types]).all()
    part = root["CellData/part"][:]
    assert set(part) == set(range(4)), "a product, two pads and a support"
    # Cells, and what is left behind at the end, are the same in every step; all else has rows of its own in each.
    fields = ["displacement_m", "plastic_strain", "von_mises_Pa", "pressure_Pa", "force_N"]
    assert set(root["PointData"]) == {*fields, "permanent_set_m"}, list(root["PointData"])
    for name in ("CellOffsets", "ConnectivityIdOffsets", "PartOffsets", "CellDataOffsets/part", "PointDataOffsets/permanent_set_m"):
        assert (root[f"Steps/{name}"][:] == 0).all() and len(root[f"Steps/{name}"]) == steps, name
    assert (root["Steps/NumberOfParts"][:] == 1).all()
    assert len(root["PointData/permanent_set_m"]) == points
    for name in fields:
        assert len(root["PointData"][name]) == points * steps, name
        assert (root[f"Steps/PointDataOffsets/{name}"][:] == points * np.arange(steps)).all(), name
    # The product's points come first. Each field is there in every step, and moves (this cube does not yield).
    product = int(np.isfinite(root["PointData/permanent_set_m"][:, 0]).sum())
    assert product > 100, product
    for name in fields[:4]:
        values = root["PointData"][name][:].reshape(steps, points, -1)[:, :product]
        assert np.isfinite(values).all() and (np.ptp(values) > 0.0) == (name != "plastic_strain"), name
    assert not np.array_equal(root["Points"][:points], root["Points"][-points:]), "the last step is the first"
    left = np.linalg.norm(root["PointData/permanent_set_m"][:product], axis=1).max()
    most = np.linalg.norm(root["PointData/displacement_m"][:].reshape(steps, points, 3)[:, :product], axis=2).max()
    assert 0.0 == left < most, (left, most)
    # The force of each surface stands at the last points; in the air the pads carry the product.
    force = root["PointData/force_N"][:].reshape(steps, points, 3)[:, -3:]
    assert np.isfinite(force).all()
    carried = force[steps // 2]
    assert carried[0][0] > 0.0 > carried[1][0], "the pads press towards each other"

try:
    import vtk
    import vtk.util.numpy_support
except ImportError:
    print("no VTK here: its reader did not open the file")
    sys.exit(0)
read = vtk.util.numpy_support.vtk_to_numpy


def rows_of(root, step):
    """Where the rows of each table over points begin in a step."""
    begins = {f"PointData/{name}": int(root[f"Steps/PointDataOffsets/{name}"][step]) for name in root["PointData"]}
    return begins | {"Points": int(root["Steps/PointOffsets"][step])}


def of_one_step(step):
    """A file of this step alone, for readers that know no steps: the rows that the file's own offsets name."""
    alone = f"{folder}/step.vtkhdf"
    with h5py.File(path) as file, h5py.File(alone, "w") as copy:
        file.copy("VTKHDF", copy)
        root = copy["VTKHDF"]
        tables = {name: root[name][begin:begin + points] for name, begin in rows_of(root, step).items()}
        for name, values in tables.items():
            del root[name]
            root[name] = values
        del root["Steps"]
    return alone


def opened(step):
    """The grid of a step as VTK's own reader gives it, and the time it has."""
    reader = vtk.vtkHDFReader()
    knows_steps = hasattr(reader, "SetStep")
    name = path if knows_steps else of_one_step(step)
    assert reader.CanReadFile(name)
    reader.SetFileName(name)
    if knows_steps:
        reader.UpdateInformation()
        assert reader.GetNumberOfSteps() == steps
        reader.SetStep(step)
    reader.Update()
    return reader.GetOutput(), reader.GetTimeValue() if knows_steps else times[step]


for step in (0, steps // 2, steps - 1):
    grid, time = opened(step)
    assert grid.GetNumberOfPoints() == points, grid.GetNumberOfPoints()
    assert grid.GetNumberOfCells() == cells, grid.GetNumberOfCells()
    assert time == times[step]
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        wanted = {name: root[name][begin:begin + points] for name, begin in rows_of(root, step).items()}
    assert (read(grid.GetPoints().GetData()) == wanted.pop("Points").astype(read(grid.GetPoints().GetData()).dtype)).all(), step
    for name, values in wanted.items():
        assert np.array_equal(read(grid.GetPointData().GetArray(name.split("/")[1])), values, equal_nan=True), (step, name)
    assert (read(grid.GetCellData().GetArray("part")) == part).all()
print(f"VTK {vtk.vtkVersion().GetVTKVersion()} opened {points} points and {cells} cells of the first, a middle and the last of {steps} steps")
