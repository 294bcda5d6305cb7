// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/slurm_job.hpp"

#include "app/sweep/slurm_queue.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

namespace {

using namespace gyro;
using Catch::Matchers::Contains;

std::string script_of(const Workplace& place, const std::string& more) {
  place.write("my sweep.yaml",
              "case: '" GYRO_APP_CASES "/platen.yaml'\nset: {case.title: \"it's\"}\nseeds: [7, 8]\n" + more);
  const SweepReport report = load_sweep(place.path() / "my sweep.yaml");
  REQUIRE(report.loaded);
  const CheckedSweep sweep = check_points(*report.loaded);
  REQUIRE(sweep.problems.empty());
  std::vector<const CheckedPoint*> points;
  for (const CheckedPoint& point : sweep.points) points.push_back(&point);
  return slurm_script("/opt/gyrosim", "/data/100% of it", sweep, points);
}

}  // namespace

TEST_CASE("A job array has one task a point, asks for what the sweep file says, and is a shell script") {
  const Workplace place;
  const std::string script =
      script_of(place,
                "until: 5 ms\nthreads: 2\nslurm: {partition: long, time: \"1:00:00\", memory: 2G, "
                "account: rocks, options: [--nice=10, \"-x node7\"]}\n");
  for (const char* line :
       {"#!/bin/bash\n", "#SBATCH --job-name=my-sweep\n", "#SBATCH --array=1-2\n", "#SBATCH --cpus-per-task=2\n",
        "#SBATCH --signal=B:USR1@120\n", "#SBATCH --requeue\n", "#SBATCH --open-mode=append\n",
        "#SBATCH --partition=long\n", "#SBATCH --time=1:00:00\n", "#SBATCH --mem=2G\n", "#SBATCH --account=rocks\n",
        "#SBATCH --nice=10\n", "#SBATCH -x node7\n", "#SBATCH --output='/data/100%% of it/logs/slurm-%A_%a.txt'\n",
        "directory='/data/100% of it'\n", "  2)\n    point=seed-8\n    settings=(--set 'case.title=",
        "--set case.seed=8)\n", "\"${settings[@]}\" --out \"$out\" --resume --quiet --threads 2 --until '5 ms'",
        "scontrol requeue \"${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}\"\n"})
    CHECK_THAT(script, Contains(line));
  CHECK_THAT(script_of(place, "slurm: {cpus: 4, signal: 30, at_once: 1}\n"),
             Contains("--cpus-per-task=4\n") && Contains("B:USR1@30\n") && Contains("--array=1-2%1\n") &&
                 !Contains("--partition"));
  place.write("job.sh", script);
  CHECK(place.shell("bash -n job.sh").code == 0);
}

TEST_CASE("The answer of sbatch is the number of a job, perhaps with a cluster, after its messages") {
  CHECK(job_number("123") == "123");
  CHECK(job_number("sbatch: note\n42;north") == "42");
  CHECK(job_number("sbatch: error: no partition").empty());
  CHECK(job_number("").empty());
}
