// Tests of the program where its output is in the folder or in the cache: what
// is taken over, and what is written or drawn again.
#include "base/content_hash.hpp"
#include "tests/program/cached_program.hpp"

#include <map>

namespace asperity::program::kept_output_test {

// A case with an expectation that is not met.
const std::string unmet_case =
    small_case + "[expect]\nkappa = { above = 1e9, methods = [\"fem\"] }\n";

bool is_kept(const Ended& run) {
  return run.output.find(" is up to date") != std::string::npos;
}

// The second run writes nothing, and answers as the first one did, by text and
// exit code, also where an expectation is not met.
TEST_F(CachedProgram, AnUnchangedFolderIsKept) {
  write("small.toml", unmet_case);
  const Ended first = run("run small.toml --out o");
  ASSERT_EQ(first.exit_code, 1) << first.output;
  const auto written = std::filesystem::last_write_time(folder / "o/result.h5");

  const Ended second = run("run small.toml --out o");

  EXPECT_TRUE(is_kept(second)) << second.output;
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "o/result.h5"), written);
  EXPECT_FALSE(std::filesystem::exists(folder / "o/result.previous.h5"));
  const std::size_t findings = first.output.find("kappa ");
  ASSERT_NE(findings, std::string::npos);
  EXPECT_NE(second.output.find(first.output.substr(findings)),
            std::string::npos)
      << second.output;
}

/// The bytes of all files under a folder by their relative paths.
std::map<std::string, std::string> files_in(const std::filesystem::path& top) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(top))
    if (entry.is_regular_file())
      files[std::filesystem::relative(entry.path(), top).string()] =
          text_of(entry.path());
  return files;
}

bool is_restored(const Ended& run) {
  return run.output.find(" from the cache, with the report") !=
         std::string::npos;
}

// A deleted folder comes back byte for byte, with findings and exit code, and
// the figures are those that a run without the cache draws.
TEST_F(CachedProgram, ADeletedFolderIsRestored) {
  write("small.toml", unmet_case);
  const Ended first = run("run small.toml --out o");
  ASSERT_EQ(first.exit_code, 1) << first.output;
  const auto written = files_in(folder / "o");
  std::filesystem::remove_all(folder / "o");

  const Ended second = run("run small.toml --out o");

  EXPECT_TRUE(is_restored(second)) << second.output;
  EXPECT_EQ(computed(second), 0);
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_TRUE(files_in(folder / "o") == written);
  const std::size_t findings = first.output.find("kappa ");
  ASSERT_NE(findings, std::string::npos);
  EXPECT_NE(second.output.find(first.output.substr(findings)),
            std::string::npos)
      << second.output;
  ASSERT_EQ(run("run small.toml --no-cache --out whole").exit_code, 1);
  int figures = 0;
  for (const auto& [file, bytes] : files_in(folder / "whole"))
    if (file.starts_with("figures/") && !file.starts_with("figures/cost")) {
      EXPECT_TRUE(written.at(file) == bytes) << file;
      ++figures;
    }
  EXPECT_GT(figures, 0);
}

// A disk that is full, here a limit on the size of a file, leaves whole files
// only, and the message names the file that the user expects.
TEST_F(CachedProgram, AFullDiskLeavesNoPartOfAFile) {
  ASSERT_EQ(run("run small.toml --out o").exit_code, 0);
  const auto written = files_in(folder / "o");
  std::filesystem::remove_all(folder / "o");

  const Ended full =
      run("run small.toml --out o", "bash -c 'ulimit -f 32; exec \"$@\"' -");

  EXPECT_EQ(full.exit_code, 4);
  const std::string names = "cannot write o/";
  const std::size_t name = full.output.find(names);
  ASSERT_NE(name, std::string::npos) << full.output;
  const std::size_t start = name + names.size();
  const std::string file =
      full.output.substr(start, full.output.find(": File too large") - start);
  EXPECT_TRUE(written.contains(file)) << full.output;
  for (const auto& [path, bytes] : files_in(folder / "o")) {
    ASSERT_TRUE(written.contains(path)) << path;
    EXPECT_TRUE(bytes == written.at(path)) << path;
  }
  EXPECT_TRUE(is_restored(run("run small.toml --out o")));
}

bool has_new_pages(const Ended& run) {
  return run.output.find(" from the cache, with the figures") !=
         std::string::npos;
}

// A changed title, comment or expectation changes pages and verdicts only. They
// are those of a run that reads its steps and draws, and the result continues
// to be one of this case.
TEST_F(CachedProgram, ChangedWordsWriteThePagesAgain) {
  ASSERT_EQ(run("run small.toml --out o").exit_code, 0);
  std::string changed = unmet_case;
  changed.replace(changed.find("title = "), 8, "title = \"Renamed\" # ");
  write("small.toml", changed);

  const Ended again = run("run small.toml --out o");

  EXPECT_TRUE(has_new_pages(again)) << again.output;
  EXPECT_EQ(computed(again), 0);
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_TRUE(is_kept(run("run small.toml --out o")));
  for (const auto& entry :
       std::filesystem::directory_iterator(folder / "cache"))
    if (entry.path().extension() == ".output" ||
        entry.path().extension() == ".numbers")
      std::filesystem::remove(entry);
  const Ended drawn = run("run small.toml --out p");
  EXPECT_FALSE(is_restored(drawn) || has_new_pages(drawn)) << drawn.output;
  EXPECT_EQ(computed(drawn), 0);
  tests::expect_same_bits(result("o"), result("p"), true);
  EXPECT_EQ(result("o").case_title, "Renamed");
  EXPECT_EQ(result("o").case_text, result("p").case_text);
  const auto files = files_in(folder / "o");
  EXPECT_NE(files.at("report.html").find("<h1>Renamed</h1>"),
            std::string::npos);
  for (const auto& [file, bytes] : files_in(folder / "p"))
    if (file.starts_with("figures/") || file.ends_with(".csv")) {
      EXPECT_TRUE(files.at(file) == bytes) << file;
    }
  const auto summary = [&](const char* name) {
    const std::string text = text_of(folder / name / "summary.json");
    return text.substr(0, text.find("\"provenance\""));
  };
  EXPECT_EQ(summary("o"), summary("p"));
  const auto pictures = [&](const char* name) {
    const std::string page = text_of(folder / name / "report.html");
    int found = 0;
    for (std::size_t at = page.find("<img "); at != std::string::npos;
         at = page.find("<img ", at + 1))
      ++found;
    return found;
  };
  EXPECT_GT(pictures("o"), 3);
  EXPECT_EQ(pictures("o"), pictures("p"));
  const Ended resumed = run("run small.toml --out o --resume --no-cache");
  EXPECT_EQ(resumed.exit_code, 1) << resumed.output;
}

// Neither numbers nor figures are taken over where they depend on the change,
// or where the figures in the cache are damaged.
TEST_F(CachedProgram, OtherChangesDrawAgain) {
  const std::string theory = "run small.toml --methods theory --out o";
  ASSERT_EQ(run(theory).exit_code, 0);

  EXPECT_FALSE(has_new_pages(run(theory + " --set report.fields=2")));
  EXPECT_TRUE(has_new_pages(run(theory + " --set title=Other")));

  for (const auto& entry :
       std::filesystem::directory_iterator(folder / "cache"))
    if (entry.path().extension() == ".figures")
      std::filesystem::resize_file(entry, 200);
  const Ended drawn = run(theory + " --set title=Third");
  EXPECT_FALSE(has_new_pages(drawn)) << drawn.output;
  EXPECT_EQ(drawn.exit_code, 0) << drawn.output;
}

// The folder of another run is not mixed with the files that are restored, and
// a file that the cache has lost is drawn or written again.
TEST_F(CachedProgram, ARestoredFolderIsWhole) {
  const std::string theory = "run small.toml --methods theory --out ";
  ASSERT_EQ(run(theory + "o").exit_code, 0);
  const auto written = files_in(folder / "o");
  ASSERT_EQ(run("run small.toml --set report.fields=2 --out p").exit_code, 0);

  EXPECT_TRUE(is_restored(run(theory + "p")));

  auto other = files_in(folder / "p");
  EXPECT_EQ(other.erase("result.previous.h5"), 1U);
  EXPECT_TRUE(other == written);

  ASSERT_TRUE(std::filesystem::remove(
      folder / "cache" / (content_hash(written.at("report.html")) + ".file")));
  const Ended again = run(theory + "q");
  EXPECT_FALSE(is_restored(again)) << again.output;
  EXPECT_EQ(computed(again), 0);
  EXPECT_EQ(again.exit_code, 0);
}

// An output that is larger than a tenth of the cache would displace the steps
// of other cases. Here the limit is 150 kB and the page alone is larger than a
// tenth of it.
TEST_F(CachedProgram, ALargeOutputIsNotSaved) {
  const std::string limited = "ASPERITY_CACHE_SIZE=150kB";
  const std::string theory = "run small.toml --methods theory --out ";
  ASSERT_EQ(run(theory + "o", limited).exit_code, 0);
  ASSERT_GT(std::filesystem::file_size(folder / "o/report.html"), 15000U);

  const Ended again = run(theory + "p", limited);

  EXPECT_FALSE(is_restored(again)) << again.output;
  EXPECT_EQ(computed(again), 0);
}

// Whatever the files of the folder depend on, or a file itself, changes.
TEST_F(CachedProgram, AChangeIsNoticed) {
  const std::string again = "run small.toml --methods theory --out o";
  const auto expect_run = [&](const std::string& change,
                              const std::string& arguments = "") {
    const Ended changed = run(again + arguments);
    EXPECT_EQ(changed.exit_code, 0) << changed.output;
    EXPECT_FALSE(is_kept(changed)) << change;
    EXPECT_EQ(computed(changed), arguments == " --no-cache" ? 4 : 0) << change;
    EXPECT_TRUE(is_kept(run(again)) || !arguments.empty()) << change;
  };
  ASSERT_EQ(run(again).exit_code, 0);
  ASSERT_TRUE(is_kept(run(again)));

  std::filesystem::remove(folder / "o/curves.csv");
  expect_run("a table was deleted");
  write("o/report.html", "<html>");
  expect_run("the report was overwritten");
  write("o/output.json", "{");
  expect_run("the list of files is damaged");
  std::string titled = small_case;
  titled.replace(titled.find("small"), 5, "other");
  write("small.toml", titled);
  expect_run("the title");
  expect_run("options", " --no-report");
  expect_run("everything is computed", " --no-cache");
}

TEST_F(CachedProgram, AnInterruptedRunIsNotKept) {
  const std::string arguments =
      "run small.toml --set surface.points=512 --methods halfspace --out o";
  ASSERT_EQ(interrupt(arguments, "o/result.journal").exit_code, 130);
  EXPECT_FALSE(std::filesystem::exists(folder / "o/output.json"));

  const Ended again = run(arguments);

  EXPECT_FALSE(is_kept(again)) << again.output;
  EXPECT_EQ(again.exit_code, 0) << again.output;
}

} // namespace asperity::program::kept_output_test
