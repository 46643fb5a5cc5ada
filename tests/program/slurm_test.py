#!/usr/bin/env python3
"""A run by a real Slurm: an array of parts, of which one is killed, and its merge.

slurm_test.py PROGRAM FOLDER: starts munged, slurmctld and slurmd for this test
alone, with a key, sockets, ports and folders of their own (a machine without
systemd will do), runs the scripts of `asperity plan --slurm`, and ends the three.
Exits 77 with the reason if a program is missing. The killed task must lose only
itself, and the second submission must give the numbers of an undivided run.
"""
import os
import pwd
import re
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from rough_case import rough_case

CASE = rough_case("a run by Slurm", points=512, realizations=4, steps=8, methods="""[halfspace]
contact = "hard"
""")
PROGRAMS = ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo"]
PATIENCE = 120.0  # for anything that Slurm does within seconds [s]
SKIPPED = 77


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def wait_for(what, question, patience=PATIENCE):
    end = time.monotonic() + patience
    while not (answer := question()):
        if time.monotonic() > end:
            raise SystemExit(f"{what}: not within {patience:g} s")
        time.sleep(0.05)
    return answer


def configuration(home):
    """The text of slurm.conf for one node, this machine."""
    user = pwd.getpwuid(os.getuid()).pw_name
    host = socket.gethostname().split(".")[0]
    controller, daemon = free_ports(2)
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // 2**20
    return f"""ClusterName=asperity
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={daemon}
AuthInfo=socket={home}/munge.socket
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={home}/state
SlurmdSpoolDir={home}/spool
SlurmctldPidFile={home}/slurmctld.pid
SlurmdPidFile={home}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1
ReturnToService=2
KillWait=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} RealMemory={memory * 9 // 10} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=60 State=UP
"""


class Slurm:
    """The three daemons, as children of this process that end with it."""

    def __init__(self, home):
        self.home = home
        self.environment = os.environ | {"SLURM_CONF": f"{home}/slurm.conf",
                                         "ASPERITY_CACHE_SIZE": "0"}
        self.daemons = []

    def __enter__(self):
        for name in ("state", "spool"):
            (self.home / name).mkdir()
        (self.home / "munge.key").write_bytes(secrets.token_bytes(128))
        (self.home / "munge.key").chmod(0o600)
        (self.home / "slurm.conf").write_text(configuration(self.home))
        try:
            self.start("munged", "--foreground", "--force",
                       *(f"--{what}-file={self.home}/munge.{what}"
                         for what in ("key", "log", "pid", "seed")),
                       f"--socket={self.home}/munge.socket")
            wait_for("munged", (self.home / "munge.socket").exists)
            self.start("slurmctld", "-D")
            self.start("slurmd", "-D")
            wait_for("an idle node", lambda: "idle" in self.ask("sinfo", "-h", "-o", "%T"))
        except BaseException:
            self.__exit__()
            raise
        return self

    def start(self, name, *words):
        with open(self.home / f"{name}.out", "w", encoding="utf-8") as out:
            self.daemons.append(subprocess.Popen([program(name), *words], stdout=out,
                                                 stderr=out, env=self.environment))

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in reversed(self.daemons):
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def ask(self, *words):
        """Standard output of a command of Slurm; "" if it fails, as while the daemons start."""
        return subprocess.run(words, env=self.environment, text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout

    def has_no_job(self):
        return self.ask("squeue", "-h", "-o", "%i") == "" and self.ask("sinfo", "-h") != ""


def program(name):
    """Its path; daemons are in folders that a user's PATH may lack."""
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/usr/local/sbin")


def run(words, environment, code=0):
    ended = subprocess.run(words, env=environment, text=True, check=False,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if ended.returncode != code:
        raise SystemExit(f"{words}: exit code {ended.returncode}, not {code}\n{ended.stdout}")
    return ended.stdout


def submit(scripts, slurm):
    """The numbers of the two jobs."""
    words = run(["sh", scripts / "submit.sh"], slurm.environment).replace(",", "").split()
    return words[2], words[5]


def process_of(part):
    """The number of the process that computes a part, which its lock names."""
    return int(re.search(r"\(process (\d+) ", (part / ".lock").read_text())[1])


def check(asperity, folder, slurm):
    case, out, whole = folder / "rough.toml", folder / "out", folder / "whole"
    case.write_text(CASE)
    run([asperity, "run", case, "--out", whole, "--no-report"], slurm.environment)
    run([asperity, "plan", case, "--slurm", "--parts", "2", "--out", out], slurm.environment)
    scripts = out / "slurm"

    parts, merge = submit(scripts, slurm)
    log = scripts / "part-2.log"
    wait_for("the third step of part 2", lambda: log.exists() and " 3/16 " in log.read_text())
    os.kill(process_of(out / "parts/2-of-2"), signal.SIGKILL)
    wait_for(f"the end of jobs {parts} and {merge}", slurm.has_no_job)
    assert "steps: " not in log.read_text(), "the task ended before it was killed"
    assert not (out / "result.h5").exists(), "the merge of a run that is not complete"
    first = out / "parts/1-of-2/result.h5"
    written = first.stat().st_mtime_ns
    refused = run([asperity, "merge", out], slurm.environment, code=2)
    assert "1 of 2 parts is missing or incomplete" in refused, refused

    parts, merge = submit(scripts, slurm)
    wait_for(f"the end of jobs {parts} and {merge}", slurm.has_no_job)
    assert (out / "result.h5").exists(), (scripts / "merge.log").read_text()
    assert first.stat().st_mtime_ns == written, "part 1 was computed again"
    assert "is complete already" in (scripts / "part-1.log").read_text()
    run([asperity, "diff", out, whole, "--tolerance", "0"], slurm.environment)
    assert (out / "report.html").exists()


def main(asperity, folder):
    missing = [name for name in PROGRAMS if not program(name)]
    if missing:
        print(f"skipped: not installed: {' '.join(missing)} (slurmctld slurmd slurm-client munge)")
        return SKIPPED
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    # The path of a socket may have some 100 letters only.
    with tempfile.TemporaryDirectory(prefix="slurm-") as home, Slurm(Path(home)) as slurm:
        try:
            check(asperity, folder, slurm)
        finally:
            for name in ("slurmctld.out", "slurmd.out", "munged.out", "slurm.conf"):
                shutil.copy(Path(home) / name, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
