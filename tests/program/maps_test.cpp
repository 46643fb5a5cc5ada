// Several measured maps in one command: what is read of a folder, what a
// refusal leaves, and how the maps are shared.
#include "results/result_reader.hpp"
#include "tests/program/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <sys/stat.h>

namespace asperity::program::maps_test {

namespace fs = std::filesystem;

class Maps : public ProgramTest {
protected:
  Maps() {
    fs::create_directories(folder / "maps");
    for (int map = 1; map <= 2; ++map)
      write(fmt::format("maps/{}.txt", map), map_text(map));
  }

  static std::string map_text(int number) {
    std::string text = "# Channel: Z\n# Width: 4 um\n# Height: 4 um\n"
                       "# Value units: m\n";
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i)
        text += fmt::format("{}e-9{}", (3 * i + 5 * j + number * i * j) % 7,
                            i == 7 ? "\n" : " ");
    return text;
  }

  Ended press(const std::string& words) const {
    return run("run " + words + " --contact-modulus '2 GPa'");
  }

  void expect_refusal(const Ended& ended, const std::string& words) const {
    EXPECT_EQ(ended.exit_code, 2) << ended.output;
    EXPECT_NE(ended.output.find(words), std::string::npos) << ended.output;
  }
};

TEST_F(Maps, ARefusedRunLeavesNothing) {
  write("maps/bare.txt", "1 2 3\n4 5 6\n7 8 9\n");
  for (const char* words : {"maps --out o", "maps --out o --part 1/2"}) {
    const Ended refused = press(words);
    expect_refusal(refused, "bare.txt is a plain matrix");
    expect_refusal(refused, "please add --length \"20 um\"");
    expect_refusal(refused, "please add --height-unit nm");
    EXPECT_FALSE(fs::exists(folder / "o"));
  }
  fs::remove(folder / "maps/bare.txt");

  const Ended ended = press("maps --out o");

  EXPECT_EQ(ended.exit_code, 0) << ended.output;
  EXPECT_TRUE(fs::exists(folder / "o/maps.toml"));
  EXPECT_TRUE(fs::exists(folder / "o/points/001/report.html"));
}

TEST_F(Maps, ARefusedPartLeavesNothing) {
  expect_refusal(press("maps/1.txt --out o --part 1/1 --set "
                       "halfspace.contact=exponential --set "
                       "halfspace.work_of_adhesion=50 --set "
                       "halfspace.range=1e-12"),
                 "halfspace.range");
  EXPECT_FALSE(fs::exists(folder / "o"));
}

TEST_F(Maps, AreNotMixedWithResults) {
  for (int repeat = 0; repeat < 2; ++repeat)
    expect_refusal(press("maps --out maps/"), "is the folder of the maps");
  for (const fs::path& entry : fs::directory_iterator(folder / "maps"))
    EXPECT_EQ(entry.extension(), ".txt") << entry;
}

TEST_F(Maps, WhatIsNoMapIsLeftOutWithALineEach) {
  write("maps/note.toml", "schema = 1\n");
  write("maps/notes.txt", "measured in 2024\n");
  fs::create_directories(folder / "maps/raw");

  const Ended ended = press("maps --dry-run");

  EXPECT_EQ(ended.exit_code, 0) << ended.output;
  EXPECT_NE(ended.output.find("2 points, "), std::string::npos) << ended.output;
  for (const char* left_out : {"maps/note.toml: is a case file\n",
                               "maps/raw: is a folder\n", "notes.txt:1: "})
    EXPECT_NE(ended.output.find(left_out), std::string::npos) << ended.output;
  const Ended seen = run("surface maps --no-report");
  EXPECT_NE(seen.output.find("notes.txt:1: "), std::string::npos)
      << seen.output;
  expect_refusal(press("maps/1.txt maps/notes.txt"), "notes.txt:1");
}

TEST_F(Maps, NoEntryIsLostWithoutAWord) {
  fs::create_symlink("nowhere", folder / "maps/3.txt");
  expect_refusal(press("maps --dry-run"),
                 "maps/3.txt: is a link to a file that does not exist");
  expect_refusal(press("maps/3.txt --dry-run"),
                 "maps/3.txt: is a link to a file that does not exist");
  fs::remove(folder / "maps/3.txt");
  ASSERT_EQ(mkfifo((folder / "maps/3.txt").c_str(), 0600), 0);
  expect_refusal(press("maps --dry-run"),
                 "maps/3.txt: is a pipe, but must be a regular file");
  fs::remove(folder / "maps/3.txt");
  for (const char* name : {"maps/1.txt", "maps/2.txt"})
    fs::remove(folder / name);
  expect_refusal(press("maps --dry-run"), "maps: is a folder without maps");
}

// The case file of maps is written when they run, so that no refusal names it.
TEST_F(Maps, NoRefusalNamesTheCaseThatIsMadeForThem) {
  for (const std::string words : {"maps", "maps/1.txt"})
    for (const std::string wrong :
         {"--methods md", "--set halfspace.thickness=-1",
          "--set fem={} --methods fem --set fem.depth=1e-12"}) {
      const Ended ended = press(words + " --dry-run " + wrong);
      EXPECT_EQ(ended.exit_code, 2) << ended.output;
      EXPECT_EQ(ended.output.find("maps.toml"), std::string::npos)
          << ended.output;
      EXPECT_EQ(ended.output.find("maps/1:"), std::string::npos)
          << ended.output;
    }
}

// E* h' of these maps is some 10 MPa.
TEST_F(Maps, AreNotPressedBeyondTheirHardness) {
  for (const std::string words : {"maps/1.txt --out one", "maps --out all"}) {
    const Ended ended = press(words + " --hardness '5 MPa'");
    EXPECT_EQ(ended.exit_code, 0) << ended.output;
  }

  for (const char* csv : {"one/curves.csv", "all/points/000/curves.csv"}) {
    auto columns = columns_of(text_of(folder / csv), "halfspace");
    const std::vector<std::string>& loads = columns["nominal_pressure [Pa]"];
    ASSERT_GT(loads.size(), 9U) << csv;
    EXPECT_NEAR(std::stod(loads.back()), 3e6, 3e-6); // 5 MPa: above 90 % of it
  }
}

// The loads of a command are round numbers, and the same for all of its maps:
// from 1 % of the smallest E* h' to the largest one.
TEST_F(Maps, ArePressedWithTheSameRoundLoads) {
  ASSERT_EQ(press("maps --flow water --out all").exit_code, 0);

  const std::string table = text_of(folder / "all/loads.csv");
  auto first = columns_of(text_of(folder / "all/points/000/curves.csv"),
                          "halfspace")["nominal_pressure [Pa]"];
  auto second = columns_of(text_of(folder / "all/points/001/curves.csv"),
                           "halfspace")["nominal_pressure [Pa]"];
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_NEAR(std::stod(first[i]) / std::stod(second[i]), 1.0, 1e-9);
  for (const std::string& load : first)
    EXPECT_NE(std::string("1.0 1.5 2.0 3.0 5.0 7.0")
                  .find(fmt::format("{:.1e}", std::stod(load)).substr(0, 3)),
              std::string::npos)
        << load;
  for (const char* row :
       {"\n1.txt,halfspace,", "\n2.txt,halfspace,", "\nmean,halfspace,",
        "\nstandard deviation,halfspace,"})
    EXPECT_NE(table.find(row), std::string::npos) << table;
  const auto numbers = [&](const std::string& row) { // of the first load
    const std::size_t begin = table.find("\n" + row + ",halfspace,") + 1;
    std::istringstream line(
        table.substr(begin, table.find('\n', begin) - begin));
    std::vector<double> found;
    for (std::string cell; std::getline(line, cell, ',');)
      found.push_back(std::atof(cell.c_str()));
    return found;
  };
  for (const std::size_t column : {4U, 5U}) { // area and mean gap
    const double one = numbers("1.txt")[column];
    const double other = numbers("2.txt")[column];
    EXPECT_NE(one, other);
    EXPECT_NEAR(numbers("mean")[column], 0.5 * (one + other), 1e-8 * one);
    EXPECT_NEAR(numbers("standard deviation")[column],
                std::abs(one - other) / std::sqrt(2.0), 1e-8 * one);
  }
  const std::string page = text_of(folder / "all/report.html");
  EXPECT_NE(page.find("over 2 maps (mean"), std::string::npos);
  EXPECT_NE(page.find("2 maps, E* = 2 GPa."), std::string::npos);
  EXPECT_NE(page.find("Leak rate of water at 100 kPa along x: "),
            std::string::npos);
  EXPECT_LT(table.find("leak_rate_y"), table.find("flow_factor_x"));
  // Both are sealed at the largest load: the mean of their flow is of zeros.
  EXPECT_EQ(numbers("samples with a value").back(), 2.0);
  EXPECT_EQ(numbers("samples with 0").back(), 0.0);
  EXPECT_TRUE(table.ends_with(",2\n")) << table;
  EXPECT_NE(page.find("; 2 of 2 are tight"), std::string::npos);
}

// With free edges, adhesive maps share pressures: those of the steepest map.
TEST_F(Maps, AdhesiveOnesWithFreeEdgesShareLoads) {
  std::string flatter = map_text(2);
  for (std::size_t at = 0; (at = flatter.find("e-9", at)) != flatter.npos;)
    flatter.replace(at, 3, "e-10");
  write("maps/2.txt", flatter);
  const Ended ended = press("maps --out all --work-of-adhesion '50 mJ/m^2' "
                            "--set surface.edges=free");
  ASSERT_EQ(ended.exit_code, 0) << ended.output;

  const std::string table = text_of(folder / "all/loads.csv");
  EXPECT_TRUE(table.starts_with("sample,method,nominal_pressure [Pa],"))
      << table;
  const std::string page = text_of(folder / "all/report.html");
  EXPECT_LT(page.find("id=\"maps\""), page.find("id=\"loads\""));
}

TEST_F(Maps, ArePressedAsTheOptionsSay) {
  const Ended ended = run(
      "run maps/1.txt --out one --youngs-modulus '2 GPa' --poisson-ratio 0.3 "
      "--counter-youngs-modulus '4 GPa' --counter-poisson-ratio 0.2 "
      "--pressure '1 MPa' --pressure '2MPa..5MPa' --level bow --remove-spikes "
      "9 --cut-off '1 um' --resistivity '1 uOhm m' --counter-resistivity '1 "
      "uOhm m' --no-report");
  ASSERT_EQ(ended.exit_code, 0) << ended.output;

  // 1/E* = (1 - 0.09)/2 GPa + (1 - 0.04)/4 GPa
  const results::Result read =
      results::read_result(folder / "one", results::MapsInFile::large);
  EXPECT_NEAR(read.contact_modulus / (1e9 / (0.91 / 2.0 + 0.96 / 4.0)), 1.0,
              1e-12);
  std::vector<double> loads;
  for (const results::CurvePoint& row :
       read.methods.back().realizations.front().points)
    loads.push_back(std::round(row.nominal_pressure * 1e-5) / 10.0);
  EXPECT_EQ(loads, (std::vector<double>{1.0, 2.0, 3.0, 5.0}));
  for (const char* key : {"level = \"bow\"", "remove_spikes = 9",
                          "cut_off = \"1 um\"", "[conductance]"})
    EXPECT_NE(read.case_text.find(key), std::string::npos) << read.case_text;
}

// Whatever is wrong or missing is named at once, by the option that gives it.
TEST_F(Maps, AreRefusedForAllReasonsAtOnce) {
  write("bare.txt", "1 2 3\n4 5 6\n7 8 9\n");
  const Ended missing = run("run bare.txt");
  for (const char* option :
       {"--contact-modulus", "--youngs-modulus", "--length", "--height-unit"})
    expect_refusal(missing, option);
  const Ended wrong = run("run maps/1.txt --youngs-modulus '2 GPx' --level "
                          "fla --pressure 2 --poisson-ratio 3");
  for (const char* line :
       {"--youngs-modulus = \"2 GPx\" has the unknown unit",
        "--level = \"fla\", but must be none", "--pressure = \"2\" has no unit",
        "--poisson-ratio = 3, but must"})
    expect_refusal(wrong, line);
  for (const std::string words : {"--hardness 3 --contact-modulus 2GPa",
                                  "--hardness '3 m' --contact-modulus 2GPa",
                                  "--poisson-ratio .3m --youngs-modulus 2GPa",
                                  "--channel x --contact-modulus 2GPa"}) {
    const Ended once = run("run maps/1.txt " + words);
    expect_refusal(once, words.substr(0, words.find(' ')));
    EXPECT_EQ(std::ranges::count(once.output, '\n'), 1) << once.output;
  }
  const Ended of_case = run("run polymer --pressure '2 MPx' --dry-run");
  expect_refusal(of_case, "--pressure = \"2 MPx\" has the unknown unit");
  EXPECT_EQ(run("run polymer --youngs-modulus '3 GPa' --poisson-ratio 0.3 "
                "--pressure '1 MPa' --dry-run")
                .exit_code,
            0);
  expect_refusal(run("run maps/1.txt --contact-modulus '1 GPa' --pressure "
                     "'5 MPa..1 MPa'"),
                 "a range goes from the smaller pressure");
}

// What is known of a map before it is pressed is said then, and once.
TEST_F(Maps, ASpikeIsToldOnce) {
  std::string text = "# Channel: Z\n# Width: 4 um\n# Height: 4 um\n"
                     "# Value units: m\n";
  for (int j = 0; j < 32; ++j)
    for (int i = 0; i < 32; ++i)
      text += fmt::format("{:.3f}e-9{}",
                          i == 9 && j == 9
                              ? 900.0
                              : 9.0 * std::sin(0.4 * i) * std::cos(0.6 * j),
                          i == 31 ? "\n" : " ");
  write("spike.txt", text);

  const std::string output =
      press("spike.txt --pressure '1 MPa' --out o").output;

  const std::size_t told = output.find("1 spike of up to ");
  EXPECT_LT(told, output.find(" step ")) << output;
  EXPECT_EQ(output.find("1 spike of up to ", told + 1), std::string::npos)
      << output;
}

TEST_F(Maps, PartsJoinToTheUndividedRun) {
  ASSERT_EQ(press("maps --out whole/maps").exit_code, 0);
  for (const char* part : {"2/2", "1/2"}) {
    const Ended ended =
        press("maps --out parts/maps --no-cache --part " + std::string(part));
    EXPECT_EQ(ended.exit_code, 0) << ended.output;
  }

  const Ended merged = run("merge parts/maps");

  EXPECT_EQ(merged.exit_code, 0) << merged.output;
  for (const char* name : {"sweep.csv", "sweep.json", "maps.toml"})
    EXPECT_EQ(text_of(folder / "parts/maps" / name),
              text_of(folder / "whole/maps" / name))
        << name;
  EXPECT_TRUE(fs::exists(folder / "parts/maps/points/001/report.html"));
  const Ended again =
      run("run parts/maps/maps.toml --no-report --out parts/maps");
  EXPECT_EQ(again.exit_code, 0) << again.output;
}

TEST_F(Maps, ArePlannedForSlurmAndRunInTheSameFolder) {
  const Ended planned =
      run("plan maps --contact-modulus '2 GPa' --slurm --out o");
  EXPECT_EQ(planned.exit_code, 0) << planned.output;
  EXPECT_NE(text_of(folder / "o/slurm/parts.sh").find("o/maps.toml"),
            std::string::npos);

  EXPECT_EQ(press("maps --no-report --out o").exit_code, 0);
}

} // namespace asperity::program::maps_test
