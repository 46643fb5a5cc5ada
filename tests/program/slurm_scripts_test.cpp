// Tests of `plan --slurm`: its scripts do what Slurm would be told, here by a
// small program in place of sbatch that runs all tasks one after another.
#include "results/result_reader.hpp"
#include "tests/program/program.hpp"
#include "tests/same_bits.hpp"

#include <filesystem>

namespace asperity::program::slurm_scripts_test {

namespace fs = std::filesystem;

class SlurmScripts : public ProgramTest {
protected:
  SlurmScripts() {
    write("rough.toml", small_case);
    write(
        "sbatch",
        "#!/bin/sh\n"
        "echo \"$@\" >> submitted.txt\n"
        "for script; do :; done\n" // the last word
        "last=$(sed -n 's/^#SBATCH --array=1-\\([0-9]*\\) .*/\\1/p' $script)\n"
        "for i in $(seq ${last:-1}); do\n"
        "  SLURM_ARRAY_TASK_ID=$i sh $script >> tasks.txt 2>&1 || exit 1\n"
        "done\n"
        "echo '17;cluster'\n"); // as on a federation of clusters
    fs::permissions(folder / "sbatch", fs::perms::owner_all);
  }

  /// Runs submit.sh, to which the program and its arguments mean nothing.
  Ended submit(const std::string& out) const {
    return run("", "PATH=\"$PWD:$PATH\" sh '" + out + "/slurm/submit.sh'");
  }

  std::string script(const std::string& name) const {
    return text_of(folder / "out/rough/slurm" / name);
  }

  bool is_in_script(const std::string& name, const std::string& words) const {
    return script(name).find(words) != std::string::npos;
  }
};

const std::string plan_it = "plan rough.toml --slurm --methods halfspace ";

TEST_F(SlurmScripts, ComputeAndMergeTheParts) {
  fs::create_directories(folder / "it's");
  ASSERT_EQ(run("run rough.toml --methods halfspace --no-cache --no-report "
                "--out whole")
                .exit_code,
            0);
  const Ended planned = run(plan_it + "--out \"it's/a run\"");
  ASSERT_EQ(planned.exit_code, 0) << planned.output;
  EXPECT_NE(planned.output.find("rough: 2 parts, each of 1 thread; submit"),
            std::string::npos);

  fs::rename(folder / "it's", folder / "its"); // no ' in what sh -c gets
  fs::create_symlink(folder / "its", folder / "it's");
  const Ended submitted = submit("its/a run");

  const fs::path home = folder / "its/a run";
  ASSERT_EQ(submitted.exit_code, 0)
      << submitted.output << text_of(home / "slurm/tasks.txt");
  EXPECT_EQ(submitted.output, "parts: job 17, merge: job 17\n");
  EXPECT_EQ(text_of(home / "slurm/submitted.txt"),
            "--parsable parts.sh\n--parsable --dependency=afterok:17 "
            "--kill-on-invalid-dep=yes merge.sh\n");
  tests::expect_same_bits(results::read_result(home),
                          results::read_result(folder / "whole"));
  EXPECT_TRUE(fs::exists(home / "report.html"));

  const Ended again = submit("its/a run");
  EXPECT_EQ(again.exit_code, 0) << again.output;
  const std::string tasks = text_of(home / "slurm/tasks.txt");
  EXPECT_NE(tasks.find("is complete already"), std::string::npos) << tasks;
}

// A step that does not converge is a result: it must not stop the merge.
TEST_F(SlurmScripts, AcceptWhatDoesNotConverge) {
  const std::string keys = "--set halfspace.max_iterations=2 ";
  ASSERT_EQ(run(plan_it + keys).exit_code, 0);

  const Ended submitted = submit("out/rough");

  EXPECT_EQ(submitted.exit_code, 1) << submitted.output; // of the merge
  const results::Result result = results::read_result(folder / "out/rough");
  EXPECT_EQ(result.status, "complete");
  EXPECT_EQ(result.methods.at(0).realizations.at(1).points.at(3).status,
            results::StepStatus::not_converged);
}

TEST_F(SlurmScripts, SayWhatATaskNeeds) {
  ASSERT_EQ(run(plan_it + "--parts 2 --threads 3 --time 1-02").exit_code, 0);
  for (const char* words :
       {"#SBATCH --array=1-2 ", "#SBATCH --time=1-02\n", "--cpus-per-task=3\n",
        " --threads 3 --part \"$SLURM_ARRAY_TASK_ID/2\"\n", "#SBATCH --mem="})
    EXPECT_TRUE(is_in_script("parts.sh", words)) << script("parts.sh");
  EXPECT_FALSE(is_in_script("merge.sh", "--array"));
}

// In the name of a log Slurm would read %j as the number of the job.
TEST_F(SlurmScripts, NameLogsWithoutTheFolder) {
  ASSERT_EQ(run(plan_it + "--out '50%j'").exit_code, 0);

  const fs::path home = folder / "50%j/slurm";
  EXPECT_NE(text_of(home / "parts.sh").find("--output=part-%a.log "),
            std::string::npos);
  EXPECT_NE(text_of(home / "merge.sh").find("--output=merge.log "),
            std::string::npos);
}

TEST_F(SlurmScripts, AreNotOverwritten) {
  ASSERT_EQ(run(plan_it + "--time 10").exit_code, 0);
  const std::string before = script("parts.sh");
  EXPECT_EQ(run(plan_it + "--time 10").exit_code, 0);

  const Ended other = run(plan_it + "--time 20");

  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.output.find("slurm/merge.sh is there already, with another"),
            std::string::npos)
      << other.output;
  EXPECT_EQ(script("parts.sh"), before);
}

TEST_F(SlurmScripts, RefuseWhatSlurmWould) {
  for (const char* time : {"soon", "1h", "1:2:3:4", "-5", "''", "10 min"}) {
    const Ended refused = run(plan_it + "--time \"" + time + "\"");
    EXPECT_EQ(refused.exit_code, 2) << time;
    EXPECT_NE(refused.output.find("for example 90 or 1:30:00"),
              std::string::npos)
        << refused.output;
  }
  EXPECT_EQ(run("plan rough.toml --parts 2").exit_code, 2); // without --slurm
  const Ended many = run(plan_it + "--parts 3");
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_NE(many.output.find("must lie between 1 and 2"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// Without --slurm the command prints what a dry run prints.
TEST_F(SlurmScripts, AreNotNeededForAPlan) {
  const Ended planned = run("plan rough.toml --methods theory");

  EXPECT_EQ(planned.exit_code, 0);
  EXPECT_NE(planned.output.find("predicted"), std::string::npos)
      << planned.output;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

} // namespace asperity::program::slurm_scripts_test
