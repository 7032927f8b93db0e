"""Flies the shards of an ensemble as tasks of HyperQueue: a server and workers of one core each, on this machine.

    shards.py WORKERS SHARDS FOLDER schuler ensemble …

Each task is the command with `--shard K/N --resume --out FOLDER`. On a cluster the server and its workers are started
by `hq server start` and `hq worker start`, or by `hq alloc add slurm`, and `Client()` finds them; the job is the same.
"""

import sys
from pathlib import Path

from hyperqueue import Job, LocalCluster
from hyperqueue.cluster import WorkerConfig


def main():
    workers, shards, folder = int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3]).resolve()
    command = sys.argv[4:]
    folder.mkdir(parents=True, exist_ok=True)
    job = Job(default_workdir=Path.cwd(), max_fails=None)
    for k in range(1, shards + 1):
        shard = ["--shard", f"{k}/{shards}", "--resume", "--threads", "1", "--out", str(folder)]
        # A worker that is lost is not the task's fault: it starts again, and goes on with what it has.
        said = [str(folder / f"shard-{k}.{name}") for name in ("out", "err")]
        job.program(command + shard, stdout=said[0], stderr=said[1], name=f"shard-{k}")
    with LocalCluster() as cluster:
        for _ in range(workers):
            cluster.start_worker(WorkerConfig(cores=1))
        client = cluster.client()
        # Raises where a task fails, with what it said.
        client.wait_for_jobs([client.submit(job)])


if __name__ == "__main__":
    main()
