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
    for name in root["PointData"]:
        assert len(root["PointData"][name]) == points * steps, name
        assert (root[f"Steps/PointDataOffsets/{name}"][:] == points * np.arange(steps)).all(), name
    # The force of each surface stands at the last points; in the air the pads carry the product.
    force = root["PointData/force_N"][:].reshape(steps, points, 3)[:, -3:]
    assert np.isfinite(force).all()
    carried = force[steps // 2]
    assert carried[0][0] > 0.0 > carried[1][0], "the pads press towards each other"

try:
    import vtk
except ImportError:
    print("no VTK here: its reader did not open the file")
    sys.exit(0)
reader = vtk.vtkHDFReader()
assert reader.CanReadFile(path)
reader.SetFileName(path)
reader.Update()
grid = reader.GetOutput()
assert grid.GetNumberOfPoints() == points, grid.GetNumberOfPoints()
assert grid.GetNumberOfCells() == cells, grid.GetNumberOfCells()
print(f"VTK {vtk.vtkVersion().GetVTKVersion()} opened {points} points and {cells} cells")
