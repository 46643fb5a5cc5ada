"""A load step of the half-space and of condensed blocks on rows that the
ranks of mpirun share: 1, 2 and 3 ranks give the bits of one process, and a
failure of one rank ends all of them within seconds, with its message.

Arguments: the program shared_step, mpirun. Tolerance: equal hashes.
"""
import os
import subprocess
import sys
import time


def run(command):
    environment = os.environ | {
        "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_NUM_THREADS": "1"}
    return subprocess.run(command, env=environment, text=True, timeout=100,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def main(program, mpirun):
    def on_ranks(ranks, *words):
        return run([mpirun, "-np", str(ranks), "--oversubscribe", program, *words])

    for points, block, on in (("256", [], ((1, 1), (2, 2), (3, 1))), ("600x500", [], ((2, 1), )),
                              ("256", ["q1"], ((2, 1), )), ("251x301", ["q1"], ((3, 2), )),
                              ("256", ["q2"], ((2, 2), )), ("300x250", ["q2"], ((3, 1), )),
                              ("256", ["free"], ((1, 1), (2, 1), (4, 1))),
                              ("300x250", ["free"], ((3, 2), ))):
        alone = run([program, points, "1", "alone", *block])
        assert alone.returncode == 0 and "converged true" in alone.stdout, alone.stdout
        answer = alone.stdout.splitlines()[0]
        for ranks, threads in on:
            shared = on_ranks(ranks, points, str(threads), "ranks", *block)
            assert shared.returncode == 0, shared.stdout
            assert answer in shared.stdout.splitlines(), (points, ranks, answer, shared.stdout)

    start = time.monotonic()
    failed = on_ranks(3, "256", "1", "ranks", "fail")
    assert time.monotonic() - start < 60.0  # two waits of 5 s, and the start of mpirun
    assert failed.returncode == 4, (failed.returncode, failed.stdout)
    assert "rank 2 of 3: the third transform failed on purpose" in failed.stdout, failed.stdout
    assert "pressure" not in failed.stdout, failed.stdout


if __name__ == "__main__":
    main(*sys.argv[1:])
