# SPDX-License-Identifier: Apache-2.0
"""A Slurm cluster of this machine alone, on loopback, for as long as it is used."""
import os
import pathlib
import pwd
import shutil
import socket
import subprocess
import tempfile
import time

DAEMONS = ("munged", "slurmctld", "slurmd")

CONFIG = """ClusterName=halfspace
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2,batch_sched_delay=0
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=2
RebootProgram=/bin/false
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=60 State=UP
"""


def program(name):
    """Daemons stand in sbin, which is not on everybody's PATH."""
    return shutil.which(name) or shutil.which(name, path="/usr/sbin:/sbin")


def missing():
    """What is not installed; empty: nothing."""
    absent = [name for name in (*DAEMONS, "sbatch") if not program(name)]
    return f"{', '.join(absent)} not installed (packages slurm-wlm, munge)" if absent else ""


def free_ports(count):
    taken = [socket.socket() for _ in range(count)]
    for one in taken:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in taken]
    for one in taken:
        one.close()
    return ports


class Cluster:
    """`with Cluster() as c`: c.environment has what sbatch and squeue need. RuntimeError: it does
    not start here, with the reason."""

    def __init__(self, cpus=4):
        self.cpus, self.daemons = cpus, []

    def __enter__(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="halfspace-slurm-")
        self.folder = pathlib.Path(self.temporary.name)
        try:
            self.start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def start(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        config = self.folder / "slurm.conf"
        config.write_text(CONFIG.format(
            host=socket.gethostname().split(".")[0], user=pwd.getpwuid(os.geteuid()).pw_name,
            folder=self.folder, ports=free_ports(2), cpus=self.cpus))
        self.environment = dict(os.environ, SLURM_CONF=str(config))
        self.daemon("munged", "--foreground", "--force", f"--key-file={key}",
                    *(f"--{what}-file={self.folder}/munge.{what}" for what in
                      ("pid", "log", "seed")), f"--socket={self.folder}/munge.socket")
        self.wait_for(lambda: (self.folder / "munge.socket").exists(), "munged")
        self.daemon("slurmctld", "-D", "-i")
        self.daemon("slurmd", "-D")
        self.wait_for(self.is_idle, "slurmd")

    def is_idle(self):
        done = subprocess.run(["sinfo", "-h", "-o", "%T"], env=self.environment,
                              capture_output=True, text=True)
        return "idle" in done.stdout

    def daemon(self, name, *arguments):
        with open(self.folder / f"{name}.out", "w") as out:
            self.daemons.append(subprocess.Popen([program(name), *arguments], stdout=out,
                                                 stderr=out, env=self.environment))

    def wait_for(self, ready, what):
        end = time.monotonic() + 60
        while not ready():
            stopped = [d for d in self.daemons if d.poll() is not None]
            if stopped or time.monotonic() > end:
                lines = [line for out in sorted(self.folder.glob("*.out"))
                         for line in out.read_text().splitlines() if "error" in line.lower()]
                raise RuntimeError(f"{what} does not start: {lines[-1] if lines else 'no reason'}")
            time.sleep(0.2)

    def stop(self):
        if getattr(self, "environment", None):
            subprocess.run(["scancel", "--full", "--me"], env=self.environment,
                           capture_output=True, timeout=30, check=False)
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(timeout=10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.temporary.cleanup()
