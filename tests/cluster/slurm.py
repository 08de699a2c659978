"""A Slurm of one node for as long as it is needed: munged, slurmctld and slurmd with their own files in a temporary folder, on
this machine's own address alone. Ended by the numbers of their processes."""
import getpass
import os
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

DAEMONS = ("munged", "slurmctld", "slurmd")


def find(name):
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def missing():
    """The programs that are not here."""
    return [name for name in (*DAEMONS, "sbatch", "scontrol", "squeue", "scancel") if find(name) is None]


def parent_of(number):
    """Number of a process's parent; 0: it has ended."""
    try:
        return int(Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()[1])
    except OSError:
        return 0


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Slurm:
    """with Slurm(cpus=4) as slurm: slurm.say("squeue")"""

    def __init__(self, cpus, array_size=40):
        self.folder = Path(tempfile.mkdtemp(prefix="unbruised-slurm-"))
        self.daemons = []
        self.environment = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"))
        self._write(cpus, array_size)

    def _write(self, cpus, array_size):
        folder, host, user = self.folder, socket.gethostname().split(".")[0], getpass.getuser()
        folder.chmod(0o755)
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "slurm.conf").write_text(f"""
ClusterName=unbruised
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SlurmdParameters=config_overrides
MailProg=/bin/true
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=1
ReturnToService=2
SlurmdTimeout=10
MaxArraySize={array_size}
KillWait=20
MinJobAge=600
JobRequeue=1
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
""")
        self.host = host

    def __enter__(self):
        folder = self.folder
        try:
            self._start([find("munged"), "--foreground", "--force", f"--socket={folder}/munge.socket", f"--key-file={folder}/munge.key",
                         f"--pid-file={folder}/munged.pid", f"--seed-file={folder}/munge.seed", f"--log-file={folder}/munged.log",
                         "--num-threads=2"])
            self.wait_until(lambda: (folder / "munge.socket").exists(), "munged")
            self._start([find("slurmctld"), "-D", "-i", "-f", str(folder / "slurm.conf")])
            self.start_node()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        if self.daemons:
            self.say("scancel", "--user", getpass.getuser(), check=False)
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _start(self, command):
        log = open(self.folder / f"{Path(command[0]).name}.out", "wb")  # pylint: disable=consider-using-with
        self.daemons.append(subprocess.Popen(command, stdout=log, stderr=log, env=self.environment, cwd=self.folder))

    def start_node(self):
        self._start([find("slurmd"), "-D", "-f", str(self.folder / "slurm.conf"), "-N", self.host])
        self.wait_until(lambda: "idle" in self.say("sinfo", "-h", "-o", "%T", check=False), "the node")

    def lose_node(self, programs):
        """As when its power fails: slurmd, the steps below it and the programs they run end at once, and tell nobody."""
        daemon = self.daemons.pop()
        ends = set()
        for number in programs:
            while number > 1 and number != daemon.pid and number not in ends:
                ends.add(number)
                number = parent_of(number)
        daemon.kill()
        daemon.wait()
        for number in ends:
            try:
                os.kill(number, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.wait_until(lambda: "down" in self.say("sinfo", "-h", "-o", "%T", check=False), "the loss of the node", 120)

    def restarts(self, job):
        """How often tasks of a job were put back into the queue, together."""
        return sum(int(number) for number in re.findall(r"Restarts=(\d+)", self.say("scontrol", "show", "job", job)))

    def logs(self):
        return "\n".join(f"== {path.name}\n" + path.read_text(errors="replace")[-3000:] for path in sorted(self.folder.glob("*.[lo][ou][gt]")))

    def wait_until(self, is_so, what, most_s=60):
        until = time.monotonic() + most_s
        while not is_so():
            ended = [str(daemon.args[0]) for daemon in self.daemons if daemon.poll() is not None]
            if ended or time.monotonic() > until:
                raise RuntimeError(f"{what} did not come; ended: {ended}\n{self.logs()}")
            time.sleep(0.2)

    def say(self, *command, check=True):
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, cwd=self.folder)
        if check and done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)} ended with {done.returncode}: {done.stderr}")
        return done.stdout

    def jobs(self, state="all"):
        """(number of the task, state) of each task."""
        lines = self.say("squeue", "-h", "-r", "-t", state, "-o", "%i %T").split("\n")
        return [tuple(line.split()) for line in lines if line]

    def wait_for_jobs(self, most_s=240):
        """Until nothing runs or waits."""
        self.wait_until(lambda: not self.jobs("PENDING,RUNNING,COMPLETING,SUSPENDED"), "the end of all jobs", most_s)
