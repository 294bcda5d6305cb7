# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of one node in a scratch folder that all users can enter, of Debian's packages: slurmctld slurmd slurm-client munge.

Nothing of the system's own Slurm is touched: sockets, keys, ports and states are those of the folder.
"""
import os
import shutil
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "sinfo")

CONFIGURATION = """\
ClusterName=gyrosim
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
# A requeued job waits until credentials of its former launch have expired, 2 min by default.
AuthInfo=socket={folder}/munge/socket,cred_expire=15
CredType=cred/munge
SlurmctldPort={controller}
SlurmdPort={node}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/run/slurmctld.pid
SlurmdPidFile={folder}/run/slurmd.pid
SlurmctldLogFile={folder}/log/slurmctld.log
SlurmdLogFile={folder}/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
SchedulerParameters=sched_interval=2,batch_sched_delay=0
MinJobAge=3600
KillWait=20
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def missing_programs():
    """The programs that are not installed."""
    path = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
    return [name for name in PROGRAMS if shutil.which(name, path=path) is None]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class OneNode:
    """The daemons of a Slurm, from `with` to its end. Its commands need `environment`."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.host = socket.gethostname().split(".")[0]
        self.daemons = []
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf"),
                            "PATH": os.environ.get("PATH", "") + ":/usr/sbin:/sbin"}

    def __enter__(self):
        try:
            self.make_files()
            self.start_munge()
            self.start("slurmctld", "-D", "-f", str(self.folder / "slurm.conf"))
            self.start("slurmd", "-D", "-f", str(self.folder / "slurm.conf"), "-N", self.host)
            self.wait_until_idle()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in reversed(self.daemons):
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()

    def make_files(self):
        for name in ("run", "log", "state", "spool", "munge"):
            (self.folder / name).mkdir()
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            folder=self.folder, host=self.host, user=user, controller=free_port(), node=free_port(), cpus=os.cpu_count()))
        (self.folder / "munge" / "key").write_bytes(os.urandom(128))
        (self.folder / "munge" / "key").chmod(0o600)

    def start(self, *command):
        with open(self.folder / "log" / (Path(command[0]).name + ".out"), "wb") as log:
            self.daemons.append(subprocess.Popen(command, stdout=log, stderr=log, env=self.environment))

    def start_munge(self):
        """munged, as the user munge where this is root: it refuses to work for root."""
        folder = self.folder / "munge"
        command = ["munged", "--foreground", f"--key-file={folder}/key", f"--socket={folder}/socket",
                   f"--pid-file={folder}/pid", f"--log-file={folder}/log", f"--seed-file={folder}/seed"]
        if os.getuid() == 0:
            for path in (folder, folder / "key"):
                shutil.chown(path, "munge", "munge")
            command = ["runuser", "-u", "munge", "--", *command]
        folder.chmod(0o755)
        self.start(*command)
        self.wait(lambda: (folder / "socket").exists(), "munged does not start")

    def wait_until_idle(self):
        self.wait(lambda: "idle" in self.output("sinfo", "--noheader", "--format=%t"), "the node does not become idle")

    def wait(self, condition, problem, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end or any(daemon.poll() is not None for daemon in self.daemons):
                logs = "\n".join(f"--- {log.name}\n{log.read_text(errors='replace')[-2000:]}"
                                 for log in sorted((self.folder / "log").iterdir()))
                raise RuntimeError(f"{problem} within {seconds} s, or a daemon has ended\n{logs}")
            time.sleep(0.5)

    def output(self, *command):
        """Standard output of a command of Slurm; empty if it fails."""
        return subprocess.run(command, capture_output=True, text=True, env=self.environment, check=False).stdout
