"""SciPy's cKDTree on the points that the gather benchmarks use, one thread: the yardstick beside PhotonGatherBenchmark.

    mvn -q -P benchmarks package -DskipTests
    java -cp target/benchmarks.jar org.diacaustic.map.PointFiles points
    python src/jmh/python/ckdtree.py points
"""

import pathlib
import sys
import time

import numpy
from scipy.spatial import cKDTree


def timed(work):
    """Seconds of processor time that the work takes, the best of three, and its result."""
    best = float("inf")
    for _ in range(3):
        start = time.process_time()
        result = work()
        best = min(best, time.process_time() - start)
    return best, result


def main():
    folder = pathlib.Path(sys.argv[1])

    def points(name):
        return numpy.fromfile(folder / name, dtype="<f4").reshape(-1, 3)

    radius = float((folder / "radius.txt").read_text())
    photons = points("photons.f32")
    seconds, tree = timed(lambda: cKDTree(photons, leafsize=16))
    print(f"build of {len(photons)} points: {seconds:.3f} s")
    for order in ("rows", "shuffled"):
        asked = points(order + ".f32")
        seconds, _ = timed(lambda: tree.query(asked, k=50))
        print(f"{order}: {len(asked) / seconds / 1000:.0f} k/s for the 50 nearest")
        seconds, found = timed(lambda: tree.query_ball_point(asked, radius, return_length=True))
        print(f"{order}: {len(asked) / seconds / 1000:.0f} k/s within the radius, {found.mean():.0f} counted")


if __name__ == "__main__":
    main()
