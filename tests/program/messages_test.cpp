// Tests of the messages about mistakes: they have exit code 2, and nothing
// incomplete is written.
#include "tests/program/program.hpp"

#include <cmath>

namespace asperity::program::messages_test {

class Messages : public ProgramTest {
protected:
  bool says(const Ended& run, const std::string& words) const {
    return run.output.find(words) != std::string::npos;
  }
};

TEST_F(Messages, SayThatAMapIsMissingWhateverItsOptions) {
  const Ended ended = run("run map.npy --contact-modulus 2GPa --length 1um");
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_NE(ended.output.find("there is no file, folder or shipped case "
                              "map.npy"),
            std::string::npos)
      << ended.output;
}

TEST_F(Messages, NamesThatNoFileCanHaveAreMistakes) {
  std::filesystem::create_symlink("loop", folder / "loop");
  const std::string longest(300, 'a');
  for (const std::string command :
       {"run ", "report ", "check ", "diff loop "}) {
    for (const std::string name : {"loop", "nowhere", longest.c_str()})
      EXPECT_EQ(run(command + name).exit_code, 2) << command << name;
  }

  EXPECT_TRUE(says(run("run " + longest), longest + ": File name too long"));
}

TEST_F(Messages, ShowEveryMistakeOfACaseAtOnce) {
  std::string text = small_case;
  text.replace(text.find("poisson_ratio = 0.3"), 19, "poisson_ratio = 0.7");
  text.replace(text.find("rms_slope"), 9, "rms_slop");
  write("broken.toml", text);

  const Ended refused = run("run broken.toml");

  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(says(refused, "broken.toml:16")) << refused.output;
  EXPECT_TRUE(says(refused, "poisson_ratio")) << refused.output;
  EXPECT_TRUE(says(refused, "rms_slope")) << refused.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

// What fits the keys, but not the block, is refused by every command before
// anything is built; tests/run/key_ranges_test.cpp has the messages.
TEST_F(Messages, NameTheKeyThatDoesNotFitTheBlock) {
  write("small.toml", small_case);

  for (const char* command :
       {"run small.toml", "run small.toml --dry-run", "describe small.toml",
        "check small.toml", "bench small.toml --quick"}) {
    const Ended refused =
        run(command + std::string(" --set fem.depth='0.001 length'"));

    EXPECT_EQ(refused.exit_code, 2) << command << refused.output;
    EXPECT_TRUE(says(refused, "--set: fem.depth = \"0.001 length\", which is "))
        << command << refused.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "out/small/result.h5"));
  }
}

// A run that does not fit into the available memory is refused with both
// numbers, and so is its plan; nothing is written.
TEST_F(Messages, RefuseWhatDoesNotFitIntoMemory) {
  write("small.toml", small_case);
  const std::string huge =
      "run small.toml --methods halfspace --set surface.points=65536 "
      "--set surface.realizations=100";

  const Ended refused = run(huge);
  const Ended planned = run(huge + " --dry-run");

  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(says(refused, "small.toml: surface.points = 65536 with 100 "
                            "realisation(s) needs "))
      << refused.output;
  EXPECT_TRUE(says(refused, " TiB of memory, but ")) << refused.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  EXPECT_EQ(planned.exit_code, 0) << planned.output;
  EXPECT_TRUE(says(planned, "the run would be refused: it needs "))
      << planned.output;
}

// The plan of ten million steps takes negligible time, without looking up each
// of them in the cache. (The shell limits the processor time: the plan once
// took more than ten minutes of it.)
TEST_F(Messages, PlanMillionsOfStepsAtOnce) {
  write("small.toml", small_case);

  const Ended planned =
      run("run small.toml --methods theory,halfspace --dry-run "
          "--set load.nominal_pressure.steps=10000 "
          "--set surface.realizations=1000",
          "ulimit -t 60;");

  EXPECT_EQ(planned.exit_code, 0) << planned.output;
  EXPECT_TRUE(says(planned, " 10000000 ")) << planned.output;
}

// Published values are printed beside ours and never change the exit code: here
// none of our numbers is near them.
TEST_F(Messages, CheckPrintsPublishedValuesWithoutVerdicts) {
  write("small.toml",
        small_case + "[expect]\nbeta = { above = 0, methods = [\"theory\"] "
                     "}\n");
  write("reference.csv", "quantity,value,unit,uncertainty,source\n"
                         "gamma_curve,-70,1,0.5,A\nanother,1,1,0,A\n");
  ASSERT_EQ(run("run small.toml --methods theory --out result").exit_code, 0);

  const Ended checked = run("check result");

  EXPECT_EQ(checked.exit_code, 0) << checked.output;
  EXPECT_TRUE(says(checked, "gamma_curve          -70 ± 0.5: theory 0.42\n"))
      << checked.output;
  EXPECT_FALSE(says(checked, "another")) << checked.output;
}

TEST_F(Messages, NameThePackageOfAMissingEngineBeforeAnythingIsWritten) {
  const Ended refused = run("run md-lammps", "env PATH=" + folder.string());

  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(says(refused, "install the Debian package lammps"))
      << refused.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "out/md-lammps/result.h5"));
}

TEST_F(Messages, NameTheMethodsACaseHas) {
  write("small.toml", small_case);

  const Ended refused = run("run small.toml --methods fen");

  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(says(refused, "nearest: fem")) << refused.output;
}

TEST_F(Messages, NewCaseRunsAndIsNeverOverwritten) {
  ASSERT_EQ(run("new mine").exit_code, 0);

  const Ended again = run("new mine");
  const Ended done = run("run mine");

  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(says(again, "already exists")) << again.output;
  EXPECT_NE(done.exit_code, 2) << done.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/mine/report.html"));
}

/// 24 x 16 heights [nm] with a tilt, in the text format of Gwyddion.
std::string map_text() {
  std::string text = "# Width: 2.4 um\n# Height: 1.6 um\n# Value units: nm\n";
  for (int iy = 0; iy < 16; ++iy)
    for (int ix = 0; ix < 24; ++ix)
      text += std::to_string(0.5 * ix + 4.0 * std::sin(1.1 * ix) *
                                            std::cos(0.9 * iy + 0.2 * ix)) +
              (ix == 23 ? "\n" : "\t");
  return text;
}

// A map runs without a case file, with loads from light to nearly full contact;
// the case that `new` writes of it has the same numbers.
TEST_F(Messages, AMapRunsWithoutACase) {
  write("map.asc", map_text());
  const Ended ran =
      run("run map.asc --contact-modulus '2 GPa' --set load.cycle=load");
  ASSERT_EQ(ran.exit_code, 0) << ran.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/map/report.html"));
  EXPECT_TRUE(says(ran, " steps: ")) << ran.output;
  write("mine.csv", "pressure [MPa],area [%]\n10,3\n20,6\n");
  const Ended compared =
      run("report out/map mine.csv --label 'my map' --label 'my rig' --out c");
  EXPECT_EQ(compared.exit_code, 0) << compared.output;
  EXPECT_NE(text_of(folder / "c/report.html")
                .find("2 results compared: my map; my rig"),
            std::string::npos);
  EXPECT_EQ(run("report mine.csv out/map").exit_code, 2);
  EXPECT_EQ(run("report out/map --label a --label b").exit_code, 2);

  const Ended made = run("new mine --map map.asc --contact-modulus '2 GPa'");
  ASSERT_EQ(made.exit_code, 0) << made.output;
  EXPECT_TRUE(says(made, "24 x 16 points, 2.4 x 1.6 um")) << made.output;
  EXPECT_TRUE(says(made, "run it with: asperity run mine")) << made.output;
  EXPECT_TRUE(text_of(folder / "mine/case.toml").find("\"../map.asc\"") !=
              std::string::npos);
  const Ended again = run("run mine --no-report");
  EXPECT_TRUE(says(again, " steps: 0 computed, ")) << again.output;
}

// The options by which `surface` reads a file without lengths and units.
TEST_F(Messages, AMapWithoutUnitsGetsThemByOptions) {
  write("plain.asc", "1 2 3 1\n2 4 1 2\n5 2 2 1\n1 2 1 3\n");
  const std::string modulus = "run plain.asc --contact-modulus '2 GPa' ";
  EXPECT_EQ(run(modulus + "--dry-run").exit_code, 2);
  const Ended ended =
      run(modulus + "--length '4 um' --height-unit nm --no-report");
  EXPECT_EQ(ended.exit_code, 0) << ended.output;
}

TEST_F(Messages, AMapNeedsAContactModulusAndACaseTakesAnother) {
  write("map.asc", map_text());
  write("small.toml", small_case);
  const Ended without = run("run map.asc");
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_TRUE(says(without, "please add --contact-modulus \"2 GPa\", or "
                            "--youngs-modulus"))
      << without.output;
  const Ended with_case =
      run("run small.toml --contact-modulus '2 GPa' --dry-run");
  EXPECT_EQ(with_case.exit_code, 0) << with_case.output;
  EXPECT_EQ(run("run map.asc --contact-modulus '2 GPa' --friction .5 --dry-run")
                .exit_code,
            0);
  const Ended unit = run("run map.asc --contact-modulus '2 GPb'");
  EXPECT_EQ(unit.exit_code, 2);
  EXPECT_TRUE(says(unit, "--contact-modulus = \"2 GPb\" has the unknown unit"))
      << unit.output;
  write("plain.asc", "1 2 3\n2 4 1\n5 2 2\n");
  const Ended number = run("run map.asc --contact-modulus 2e9");
  EXPECT_EQ(number.exit_code, 2);
  EXPECT_TRUE(says(number, "--contact-modulus = \"2e9\" has no unit; allowed: "
                           "Pa, kPa, MPa, GPa\n"))
      << number.output;
  EXPECT_EQ(run("new plain --map plain.asc --contact-modulus 2e9").exit_code,
            2);
  EXPECT_FALSE(std::filesystem::exists(folder / "plain"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

// A refused option does not hide what else is missing or wrong.
TEST_F(Messages, AllRefusalsComeAtOnce) {
  write("plain.asc", "1 2 3 1\n2 4 1 2\n5 2 2 1\n1 2 1 3\n");
  write("small.toml", small_case);
  const auto expect_all = [&](const std::string& words,
                              const std::vector<std::string>& refusals) {
    const Ended ended = run(words);
    EXPECT_EQ(ended.exit_code, 2) << words;
    for (const std::string& refusal : refusals)
      EXPECT_TRUE(says(ended, refusal)) << refusal << "\n" << ended.output;
  };
  expect_all("run plain.asc --flow watr",
             {"--flow = \"watr\" is no known fluid",
              "please add --contact-modulus \"2 GPa\"",
              "please add --length \"20 um\""});
  expect_all("run small.toml --flow watr --contact-modulus 2",
             {"--flow = \"watr\" is no known fluid",
              "--contact-modulus = \"2\" has no unit"});
  expect_all(
      "run plain.asc --friction half --level flat --remove-spikes 2",
      {"--friction = \"half\", but must be a number, as in --friction 0.5",
       "--level", "--remove-spikes"});
  expect_all("check small.toml --flow watr --contact-modulus 2",
             {"--flow = \"watr\" is no known fluid",
              "--contact-modulus = \"2\" has no unit"});
  expect_all("surface plain.asc --contact-modulus 2 --length 3 --tip-radius 4",
             {"--contact-modulus = \"2\" has no unit",
              "--length = \"3\" has no unit",
              "--tip-radius = \"4\" has no unit"});
}

TEST_F(Messages, UnknownCommandsAndOptionsAreBadInput) {
  const Ended command = run("rnu polymer");
  EXPECT_EQ(command.exit_code, 2);
  EXPECT_TRUE(says(command, "rnu: did you mean run?")) << command.output;
  const Ended option = run("run polymer --method=fem --quick");
  EXPECT_EQ(option.exit_code, 2);
  EXPECT_TRUE(says(option, "--method: did you mean --methods?"))
      << option.output;
  const Ended missing = run("run --set surface.points=64");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_FALSE(says(missing, "did you mean")) << missing.output;
  EXPECT_EQ(run("").exit_code, 2);
  EXPECT_EQ(run("--help").exit_code, 0);
}

// A case in which nothing was checked does not pass: neither without an
// expectation nor if all expectations concern excluded methods.
TEST_F(Messages, CheckDoesNotPassWhereNothingWasChecked) {
  write("bare.toml", small_case);
  write("partial.toml",
        small_case + "[expect]\niterations_max = { below = 100, methods = "
                     "[\"halfspace\"] }\n");
  ASSERT_EQ(run("run bare.toml --methods theory").exit_code, 0);
  ASSERT_EQ(run("run partial.toml --methods theory").exit_code, 0);

  const Ended bare = run("check out/bare --junit junit.xml");
  const Ended partial = run("check out/partial");

  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_TRUE(says(bare, "out/bare: nothing was checked: the case states no "
                         "expectation; put one under [expect]"))
      << bare.output;
  EXPECT_NE(text_of(folder / "junit.xml").find("<skipped"), std::string::npos);
  EXPECT_EQ(partial.exit_code, 2);
  EXPECT_TRUE(says(partial, "concern halfspace, which the result does not "
                            "have; run the case with them"))
      << partial.output;
}

TEST_F(Messages, ReportWorksFromInsideTheFolder) {
  write("small.toml", small_case);
  ASSERT_EQ(run("run small.toml --methods theory --out .").exit_code, 0);

  EXPECT_EQ(run("report result.h5").exit_code, 0);
  std::filesystem::remove(folder / "report.html");

  const Ended two = run("report result.h5 .");
  EXPECT_EQ(two.exit_code, 0) << two.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/comparison/report.html"));
  EXPECT_FALSE(std::filesystem::exists(folder / "report.html"));
}

} // namespace asperity::program::messages_test
