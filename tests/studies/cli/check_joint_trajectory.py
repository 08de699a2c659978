"""usage: check_joint_trajectory.py PROGRAM CONFIGS FOLDER: exports a strategy for ROS and reads it with Python's yaml.

Every field of trajectory_msgs/JointTrajectory and control_msgs/GripperCommand is there with its type; the other
formats of the same scenario are written, and what cannot be written is refused in a sentence."""

import subprocess
import sys

try:
    import yaml
except ImportError:
    print("python3-yaml is not installed: nothing was read")
    sys.exit(0)

program, configs, folder = sys.argv[1:4]
COARSE = ["--set", "product.cell_size_m=0.0125", "--set", "simulation.time_step_s=2e-3", "--set",
          "vary[0].values=[4.0]", "--no-replay"]


def call(*words, status=0):
    done = subprocess.run([program, *words], capture_output=True, text=True)
    assert done.returncode == status, (words, done.returncode, done.stderr)
    return done.stdout if status == 0 else done.stderr


def seconds(duration):
    assert set(duration) == {"sec", "nanosec"}, duration
    assert all(isinstance(each, int) for each in duration.values()), duration
    assert 0 <= duration["nanosec"] < 10**9, duration
    return duration["sec"] + 1e-9 * duration["nanosec"]


run = f"{folder}/run"
call("run", f"{configs}/robot_pick.toml", "-q", "--fresh", "--output", run, *COARSE)
names = ["base", "shoulder", "elbow", "forearm", "wrist", "hand"]
call("export", run, "--format", "joint_trajectory", "--joint-names", ",".join(names), "-o", f"{folder}/way.yaml")
with open(f"{folder}/way.yaml", encoding="utf-8") as file:
    text = file.read()
read = yaml.safe_load(text)
assert set(read) == {"joint_trajectory", "gripper_commands"}, list(read)
trajectory = read["joint_trajectory"]
assert set(trajectory) == {"header", "joint_names", "points"}, list(trajectory)
assert set(trajectory["header"]) == {"stamp", "frame_id"}
assert trajectory["joint_names"] == names
before = -1.0
for point in trajectory["points"]:
    assert set(point) == {"positions", "velocities", "accelerations", "effort", "time_from_start"}, list(point)
    for field in ("positions", "velocities", "accelerations"):
        assert len(point[field]) == len(names) and all(isinstance(each, float) for each in point[field]), point
    assert point["effort"] == []
    assert seconds(point["time_from_start"]) > before
    before = seconds(point["time_from_start"])
assert all(each == 0.0 for each in trajectory["points"][-1]["velocities"])
words = [command["word"] for command in read["gripper_commands"]]
assert words == ["close", "grip", "open"], words
for command in read["gripper_commands"]:
    assert set(command["command"]) == {"position", "max_effort"}, command
    assert all(isinstance(each, float) for each in command["command"].values()), command
    assert isinstance(command["waits_for_contact"], bool) and seconds(command["time_from_start"]) >= 0.0
for part in ("study robot_pick", "digest of the results", "limits of joint 0", "NOT TRIED ON A REAL CONTROLLER"):
    assert part in text, part

for kind, endings in (("urscript", [".script"]), ("rapid", [".mod"]), ("krl", [".src", ".dat"])):
    said = call("export", run, "--format", kind, "-o", f"{folder}/way{endings[0]}")
    assert said == "".join(f"path: {folder}/way{ending}\n" for ending in endings), said
assert "DEF way()" in open(f"{folder}/way.src", encoding="utf-8").read(), "a KRL module is called as its file"
assert "waits_for_contact" in call("export", run, "--table", "path", "-o", "-")

said = call("export", run, "--format", "krl", "-o", "-", status=2)
assert "is two files" in said, said
said = call("export", run, "--format", "joint_trajectory", "--joint-names", "a,b", status=2)
assert "there are 2, and the arm has 6 joints" in said, said
said = call("export", run, "--format", "rapid", "--joint-names", "a,b", status=2)
assert "--joint-names goes with" in said, said
said = call("export", run, "--format", "rapid", "--scenario", "99", status=2)
assert "holds no scenario of this number" in said, said
said = call("export", run, "--format", "ruby", status=2)
assert "this build writes csv, vtkhdf, joint_trajectory, urscript, rapid and krl" in said, said

bare = f"{folder}/bare"
call("run", f"{configs}/hold.toml", "-q", "--fresh", "--output", bare, "--set", "strategy.hold_s=0.1", "--no-replay")
said = call("export", bare, "--format", "joint_trajectory", status=2)
assert "the study has no [robot]" in said, said
call("export", bare, "--format", "urscript", "-o", f"{folder}/bare.script")
far = f"{folder}/far"
call("run", f"{configs}/robot_pick.toml", "-q", "--fresh", "--output", far, "--set", "robot.base_place_m=[-2.0,0.2,0.0]",
     *COARSE)
said = call("export", far, "--format", "rapid", "--scenario", "0", status=2)
assert "nothing was lifted (out_of_range)" in said, said
print(f"{len(trajectory['points'])} points of {len(names)} joints were read as ROS's messages")
