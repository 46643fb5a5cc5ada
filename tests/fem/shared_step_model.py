"""Fits a cost model to the output of fem_shared_step and extrapolates it.

Arguments: files with the output of runs "mpirun -np R fem_shared_step N 1 ranks",
any number of runs in each; then --at POINTS RANKS for each extrapolation.

With N = points^2, R ranks and T applications of the operator:

    T = t0 points^t1                                     applications in a step
    CPU time of a rank  = N/R T (c0 + c1 log2 N)         [s]
    bytes from a rank   = b N/R (1 - 1/R) T              [B]
    memory of a rank    = m0 + m1 N/R                    [B]

Of several runs of one size the one with the least CPU time is used, because other
programs, and ranks that wait, only add to it. Each is a least-squares fit to the logarithms (the CPU time and the memory, which
are sums, to relative residuals). Prints the constants and the largest residuals.
"""
import argparse
import math
import re
import sys
from pathlib import Path

RUN = re.compile(
    r"iterations (\d+) transforms (\d+).*?points (\d+) ranks (\d+) set-up [\d.]+ s, time ([\d.]+) s"
    r".*?CPU time of each rank \[s\]([ \d.]+).*?memory of each rank [^\]]*\]([ \d.]+)"
    r".*?sent of each rank \[B\]([ \d.]+)", re.S)


def largest(text):
    return max(map(float, text.split()))


def runs_in(text):
    for found in RUN.finditer(text):
        points, ranks = int(found[3]), int(found[4])
        own = points * points / ranks
        yield {"points": points, "ranks": ranks, "own": own, "iterations": int(found[1]),
               "transforms": int(found[2]), "cpu": largest(found[6]),
               "memory": largest(found[7]) * own, "sent": largest(found[8])}


def fit_two(rows):
    """Least squares of sum_k x_k a_k = y, for two columns x; rows of (x0, x1, y)."""
    a, b, c = (sum(r[i] * r[j] for r in rows) for i, j in ((0, 0), (0, 1), (1, 1)))
    p, q = (sum(r[i] * r[2] for r in rows) for i in (0, 1))
    det = a * c - b * b
    if abs(det) < 1e-12 * a * c:
        sys.exit("the runs do not determine the model: run more sizes")
    return (c * p - b * q) / det, (a * q - b * p) / det


def relative(x0, x1, y):
    return x0 / y, x1 / y, 1.0


class Model:
    def __init__(self, runs):
        log_t0, self.t1 = fit_two([(1.0, math.log(r["points"]), math.log(r["transforms"]))
                                   for r in runs])
        self.t0 = math.exp(log_t0)
        work = [(r["own"] * r["transforms"], r) for r in runs]
        self.c0, self.c1 = fit_two([relative(w, w * 2 * math.log2(r["points"]), r["cpu"])
                                    for w, r in work])
        logs = [math.log(r["sent"] / (w * (1 - 1 / r["ranks"]))) for w, r in work
                if r["ranks"] > 1]
        self.b = math.exp(sum(logs) / len(logs))
        self.m0, self.m1 = fit_two([relative(1.0, r["own"], r["memory"]) for r in runs])

    def at(self, points, ranks, transforms=None):
        own = points * points / ranks
        t = transforms or self.t0 * points**self.t1
        return {"transforms": t, "cpu": own * t * (self.c0 + self.c1 * 2 * math.log2(points)),
                "sent": self.b * own * (1 - 1 / ranks) * t, "memory": self.m0 + self.m1 * own}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("outputs", nargs="+", type=Path)
    parser.add_argument("--at", nargs=2, type=int, action="append", default=[],
                        metavar=("POINTS", "RANKS"))
    asked = parser.parse_args()
    best = {}
    for path in asked.outputs:
        for run in runs_in(path.read_text()):
            key = run["points"], run["ranks"]
            if key not in best or run["cpu"] < best[key]["cpu"]:
                best[key] = run
    runs = [best[key] for key in sorted(best)]
    if len(runs) < 4:
        sys.exit(f"{len(runs)} runs found; the model needs at least 4")
    model = Model(runs)
    print(f"t0 {model.t0:.3g} t1 {model.t1:.3g} c0 {model.c0:.3g} s c1 {model.c1:.3g} s "
          f"b {model.b:.3g} B m0 {model.m0:.3g} B m1 {model.m1:.3g} B")
    print("points ranks: measured and model of transforms, CPU [s], sent [GB], memory [GB]")
    worst = dict.fromkeys(("transforms", "cpu", "sent", "memory"), 0.0)
    for run in runs:
        fit = model.at(run["points"], run["ranks"], run["transforms"])
        fit["transforms"] = model.t0 * run["points"]**model.t1
        for key in worst:
            if run[key] > 0.0:
                worst[key] = max(worst[key], abs(math.log(fit[key] / run[key])))
        print(run["points"], run["ranks"], f"{run['transforms']} {fit['transforms']:.1f}",
              f"{run['cpu']:.3g} {fit['cpu']:.3g}",
              f"{run['sent'] / 1e9:.3g} {fit['sent'] / 1e9:.3g}",
              f"{run['memory'] / 1e9:.3g} {fit['memory'] / 1e9:.3g}")
    print("largest residual:", ", ".join(f"{key} {math.expm1(value) * 100:.0f} %"
                                         for key, value in worst.items()))
    for points, ranks in asked.at:
        fit = model.at(points, ranks)
        print(f"{points}^2 on {ranks} ranks: {fit['transforms']:.0f} transforms, CPU "
              f"{fit['cpu']:.3g} s, {fit['sent'] / 1e9:.3g} GB sent and "
              f"{fit['memory'] / 1e9:.3g} GB of memory, each rank")


if __name__ == "__main__":
    main()
